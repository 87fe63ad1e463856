// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Inputs with known answers.
#include "algorithms/modes/modes.hpp"

namespace crest::tests {

/// One cell with corners at different places.
inline modes::Input one_cell() {
  modes::Input input;
  input.cells.emplace_back();
  for (std::uint32_t k = 0; k < 4; ++k) {
    input.points.push_back({0.5 * (k & 1), 0.25 * (k >> 1 & 1), 2.0 * (k >> 2)});
    input.cells[0][k] = k;
  }
  return input;
}

}  // namespace crest::tests
