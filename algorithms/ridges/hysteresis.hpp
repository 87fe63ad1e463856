// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Which parts of a line are kept for a number z at its points: hysteresis. A run of points with
// z >= Z / 2 that holds one with z >= Z is kept; gaps up to R between two runs, or between a run
// and an end that holds, are closed; then runs shorter than R are dropped, but for two kinds
// that are as long as they can be: a whole line between two umbilics, and a piece of a crease, from
// a run's first point of infinite z to its last; of any other run shorter than R that piece stays.
// A line with z >= Z on 80 % of its length is kept whole.
#include <cstddef>
#include <vector>

namespace crest::ridges {

/// Shapes: n points; gap[i] leads from point i to the next (n of them in a loop, else n - 1).
struct Profile {
  bool loop = false;
  bool holds[2] = {false, false};  ///< ends to which gaps may be closed
  bool between_umbilics = false;   ///< significant ones
  std::vector<double> z, gap;
  std::vector<double> radius;  ///< R at the points
};

/// count points from first on, cyclically in a loop; all n of a loop: the closed loop.
struct Run {
  std::size_t first, count;
};

struct Runs {
  std::vector<Run> kept;
  std::size_t found = 0;   ///< before the short ones were dropped
  std::size_t closed = 0;  ///< gaps
};

/// The run's piece of a crease: from its first point of infinite z to its last; in a whole loop,
/// which has no ends, all but the longest gap between two such points, all of it if there is none.
/// Of no points where z is finite throughout.
Run crease_piece(const Profile& profile, const Run& run);

/// Guarantees: runs in order, disjoint. A point's share of the length is half of its gaps. R of a
/// gap or run is the mean at its two ends.
Runs hysteresis(const Profile& profile, double threshold);

}  // namespace crest::ridges
