// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A scene as one HTML file that needs nothing else: no network, no server, no library.
#include <string>

#include "io/page/scene.hpp"

namespace crest::io {

/// The page's bytes. Scripts and styles are allowed by their digests only (content security
/// policy), text from files is data of the page and never its markup. With a certificate and a
/// checker (docs/page.md) the page can verify.
/// Exact: attributes of items, values of fields, places of lines and points (doubles). Rounded to
/// single precision: the surfaces' points, which are only shown.
/// Guarantees: the same bytes for the same scene, context and checker.
/// Throws: std::logic_error when a field or a column has not as many numbers as there are vertices,
///   faces or items, or a run has no item, kind or place.
std::string page_bytes(const Scene& scene, const PageContext& context,
                       const std::string& checker = {});

/// The checker that pages carry: the file named by the environment's CREST_VERIFY_JS, else by the
/// build; empty if there is none. Throws: kernel::InputError if the environment names a file that
/// cannot be read.
std::string page_checker();

/// Writes page_bytes with page_checker. Guarantees: no half-written file.
/// Throws: as they do; kernel::InputError for a place that cannot be written.
void write_page(const std::string& path, const Scene& scene, const PageContext& context);

}  // namespace crest::io
