// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Umbilics of a smooth surface: found by Newton's method, proven by Krawczyk's operator and the
// blow-up (certify/ridges_smooth/SPEC.md, Patches 2, 4 and 5).
#include <array>
#include <optional>

#include "algorithms/smooth_ridges/blow_up.hpp"
#include "algorithms/smooth_ridges/surface_point.hpp"

namespace crest::smooth_ridges {

/// The umbilic that Newton's method reaches from `start` within `steps` steps, none longer than
/// `reach` in all. No proof.
std::optional<SurfacePoint> find_umbilic(const Surface& surface, SurfacePoint start, double reach);

/// A proven umbilic.
struct Umbilic {
  SurfacePoint centre;
  double rho;                         ///< it lies within rho of the centre, in each coordinate
  double radius;                      ///< R: half the side of Q
  std::array<double, 2> heights;      ///< implicit: the graph's range over Q
  std::array<double, 2> own_heights;  ///< implicit: its range within rho
  Branches branches;
};

/// Tries R = radius and smaller ones, down to about radius / 2^30.
std::optional<Umbilic> prove_umbilic(const Surface& surface, const SurfacePoint& guess,
                                     double radius);

}  // namespace crest::smooth_ridges
