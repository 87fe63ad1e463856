// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Umbilics of a smooth surface: found by Newton's method, proven by Krawczyk's operator and the
// blow-up (certify/ridges_smooth/SPEC.md, Patches 2, 4 and 5).
#include <array>
#include <optional>

#include "algorithms/smooth_ridges/blow_up.hpp"
#include "algorithms/smooth_ridges/surface_point.hpp"

namespace crest::smooth_ridges {

/// Not for two threads at a time.
class UmbilicFinder {
 public:
  explicit UmbilicFinder(const Surface& surface);
  /// The umbilic that Newton's method reaches from `start` by steps of at most `reach` in all. No
  /// proof.
  std::optional<SurfacePoint> operator()(SurfacePoint start, double reach);

 private:
  std::optional<ImplicitMap<double, 1>> value_;
  std::optional<ImplicitMap<double, 3>> jet_;
  std::optional<ParametricMap<double, 3>> map_;
};

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
