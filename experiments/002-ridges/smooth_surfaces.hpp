// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The surfaces of the tables on certified ridges, as text: what the command line takes.
#include <array>
#include <string>
#include <vector>

#include "algorithms/smooth_ridges/surface.hpp"

namespace crest::experiments {

struct SmoothSurface {
  std::string name;
  std::vector<std::string> functions;   ///< one: F(x, y, z) = 0 in `box`; three: x; y; z of u, v
  std::array<double, 6> box{};          ///< of an implicit surface
  std::array<std::string, 4> domain{};  ///< u0, u1, v0, v1 of a parametric one
  std::array<bool, 2> periodic{};       ///< in u, in v
};

inline smooth_ridges::Surface make_surface(const SmoothSurface& s) {
  const auto& f = s.functions;
  if (f.size() == 1) return smooth_ridges::Surface::implicit(f[0], s.box);
  return smooth_ridges::Surface::parametric({f[0], f[1], f[2]}, s.domain, s.periodic);
}

/// x^2/a^2 + y^2/b^2 + z^2/c^2 = 1 in a box half as large again.
SmoothSurface ellipsoid(double a, double b, double c);
/// Paper 002, section 9, with the exponents' factor -0.7 replaced by -sharpness.
SmoothSurface blend(double sharpness);

/// Surfaces in general position.
std::vector<SmoothSurface> generic_surfaces();
/// Surfaces without a ridge graph in the sense of the theorem.
std::vector<SmoothSurface> degenerate_surfaces();
/// Ordinary expressions that users wrote, and an ellipsoid beside another of a hundredth and a
/// thousandth of its size. Two are not generic: they are to be refused with the place.
std::vector<SmoothSurface> reported_surfaces();
/// Ellipsoids whose axes come together, blends that sharpen.
std::vector<SmoothSurface> growing_surfaces();

}  // namespace crest::experiments
