// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Which parts of a line are kept for a number z at its points: hysteresis. A run of points with
// z >= Z / 2 that holds one with z >= Z is kept; gaps up to R between two runs, or between a run
// and an end that holds, are closed; then runs shorter than R are dropped, but for two kinds
// that are as long as they can be: a whole line between two umbilics, and a run with an infinite z
// at both ends (a piece of a crease). A line with z >= Z on 80 % of its length is kept whole.
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

/// A piece of a crease: z is infinite at its first point and at its last; in a whole loop, which
/// has no ends, everywhere.
bool infinite_at_ends(const Profile& profile, const Run& run);

/// Guarantees: runs in order, disjoint. A point's share of the length is half of its gaps. R of a
/// gap or run is the mean at its two ends.
Runs hysteresis(const Profile& profile, double threshold);

}  // namespace crest::ridges
