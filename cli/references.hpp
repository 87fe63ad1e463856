// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// references.bib, embedded at build time: what --cite prints.
#include <string>
#include <vector>

namespace crest::cli {

/// The text of references.bib (generated source).
const char* references_text();

/// The BibTeX entries with these keys, in the order of the keys, one empty line between two.
/// Throws std::out_of_range for a key that references.bib does not have.
std::string bibtex(const std::vector<std::string>& keys);

/// All keys of references.bib in file order.
std::vector<std::string> reference_keys();

}  // namespace crest::cli
