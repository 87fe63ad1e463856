// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How long classes and functions are: a matcher of braces that knows comments, literals and what
// stands before a brace, but no more of C++.
#include <string>
#include <vector>

namespace crest::tests {

struct Body {
  std::string name;  ///< with the classes around it
  bool is_class;
  std::size_t lines;  ///< between the braces
};

/// The text with comments, literals and preprocessor lines blanked: as many lines as before.
std::string without_comments(const std::string& text);

/// Classes at any depth, functions that are in no other function.
std::vector<Body> bodies_of(const std::string& text);

}  // namespace crest::tests
