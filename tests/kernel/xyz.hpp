// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The names of an expression's variables in most tests.
#include <string>
#include <vector>

namespace crest::tests {

inline const std::vector<std::string> kXyz = {"x", "y", "z"};

}  // namespace crest::tests
