// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Certified ridges and umbilics of a smooth surface given by expressions (paper 002, case I;
// certify/ridges_smooth/SPEC.md states what is proven and why).
#include <functional>
#include <optional>

#include "algorithms/smooth_ridges/smooth_ridges_result.hpp"
#include "algorithms/smooth_ridges/stop.hpp"

namespace crest::smooth_ridges {

class Surface;  // surface.hpp

/// How far the refinement may go.
struct RefinementOptions {
  int max_depth = 60;               ///< rounds of refinement
  std::size_t max_faces = 2000000;  ///< budget
  std::function<void(int round, std::size_t faces, std::size_t left)> progress;
};

struct Options {
  /// Of the first triangulation, about. Else 1500 that resolve an implicit surface, or 400: of a
  /// parametrisation any grid is a start.
  std::optional<int> start_faces;
  RefinementOptions refinement;
  Stop stop;
};

/// Throws: std::invalid_argument for options outside their ranges.
/// The same result for any number of threads, unless it is stopped.
SmoothRidges smooth_ridges(const Surface& surface, const Options& options);

}  // namespace crest::smooth_ridges
