// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Levels as people write them.
#include <string>

#include "algorithms/modes/level.hpp"

namespace crest::modes {

struct SignedLevel {
  Level level;
  int sign = 0;  ///< of the mode; 0: it is 0
};

/// A decimal or a fraction p/q of at most 15 digits, exactly, between -1 and 1.
/// Throws: std::invalid_argument "TEXT: PROBLEM".
SignedLevel parse_level(const std::string& text);

}  // namespace crest::modes
