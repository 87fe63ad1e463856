// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What is said of the ridges of one colour.
#include "cli/json.hpp"

namespace crest::cli {

/// Lengths in units of the input; what has no type counts in neither of the last two.
struct ColourSummary {
  std::size_t loops = 0, segments = 0;
  double length = 0, elliptic_length = 0, hyperbolic_length = 0;
};

inline Json to_json(const ColourSummary& s) {
  return {{"loops", s.loops},
          {"segments", s.segments},
          {"length", s.length},
          {"elliptic_length", s.elliptic_length},
          {"hyperbolic_length", s.hyperbolic_length}};
}

}  // namespace crest::cli
