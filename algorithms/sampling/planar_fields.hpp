// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Plane vector fields on triangles to measure with: blends of random lattice vectors, and twins of
// two data sets of paper 001, chapter 5, which are not public.
#include <cstdint>
#include <vector>

#include "kernel/arithmetic/vec3.hpp"
#include "kernel/geometry/index.hpp"

namespace crest::sampling {

struct PlanarSample {
  std::vector<kernel::Vec2> points, vectors;
  std::vector<kernel::Triangle> triangles;
};

/// The lattice field of a seed on n x n cells of the unit square; `hole`: without the middle
/// quarter of each side. lattice: cells of the field; 0: 5 + seed mod 9. Requires: n > 0.
PlanarSample lattice_field(std::uint64_t seed, int n, bool hole = false, int lattice = 0);

/// Stands for the flow in a bay: 14 086 triangles, an island.
PlanarSample twin_bodden();

/// Stands for skin friction on a cylinder: 12 726 triangles, thin ones among them.
PlanarSample twin_skin();

}  // namespace crest::sampling
