// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// No output holds a number that is not finite: one would be a bug of ours (exit code 70, nothing is
// written), for no reader could do anything with it.
#include <cmath>
#include <stdexcept>
#include <string>

namespace crest::io {

/// Throws: std::runtime_error naming `what` otherwise.
inline void require_finite(double x, const std::string& what) {
  if (!std::isfinite(x)) throw std::runtime_error("the output's " + what + " is not finite");
}

}  // namespace crest::io
