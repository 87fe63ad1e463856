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

/// The key of a method of `crest curvature`, nullptr for those of paper 001 itself.
const char* curvature_reference(const std::string& method);

}  // namespace crest::cli
