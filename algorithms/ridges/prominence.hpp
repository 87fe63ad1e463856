// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How much an extremum of curvature stands out along its line of curvature, and how sure that is.
//
// From a crossing x the line of curvature of its colour is followed to both sides, at most 4 R (R:
// the support's radius at x). With sense +1 for a maximum of k, -1 for a minimum, the peak is the
// largest sense k within one mean edge of x; a side ends where sense k exceeds it. At y, on the
// peak's own side beyond it,
//   drop(y) = sense (k_peak - k(y)),       drop' likewise with the wider fit's k',
//   z(y)    = drop / sqrt(n + max(0, m^2 - n) / 4),
//   n = sigma_x^2 + sigma_y^2,  m = max |drop - drop'| over the last R / 2.
// m is the model's error: truncation changes by more than itself from one support to the other, a
// crease (k ~ 1 / R) by a fifth; the largest, because drop and drop' may cross by chance. Noise
// alone makes m^2 about n, which is counted already: the least squares of all points that both fits
// hold have var(k - k') = var k - var k', here 0.74 var k, and m is the largest of several.
// A side's z and drop are the largest of its walk; the significance and the prominence of a
// crossing are those of the lesser side.
#include "algorithms/ridges/curvature_lines.hpp"

namespace crest::ridges {

/// Blue: k1 > |k2|; red: -k2 > |k1|: the place of a crest line, whatever the type.
bool on_crest(const Crossing& c, Colour colour);

/// Sets significance and prominence of every crossing, in the sense of its type, and
/// crest_significance of those on the crest, in the sense in which |k| falls whatever the type: the
/// sign of P is noise near creases. Returns the prominences of the latter sense, 0 off the crest,
/// by ridge and crossing. Requires: fit.errors. Guarantees: the same values whatever the thread
/// count. Cost: some 20 to 100 triangles a crossing.
std::vector<std::vector<double>> mark_prominence(const kernel::TriangleMesh& mesh,
                                                 const FitResult& fit, RidgeGraph& graph);

}  // namespace crest::ridges
