// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A slow producer of claim 9, written from SPEC.md and the definitions: rationals for what is
// decided, stream lines in plain double. It knows nothing of barriers.
#include <functional>

#include "certify/skeleton/records.hpp"

namespace crest::tests {

struct PlaneField {
  std::vector<std::array<double, 2>> positions;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::array<double, 2>> vectors;
};

/// (nx + 1) x (ny + 1) points with unit spacing times `spacing`, diagonals from lower left to upper
/// right; cells for which `left_out` is true are holes.
PlaneField grid_field(std::uint32_t nx, std::uint32_t ny, double spacing,
                      const std::function<std::array<double, 2>(double, double)>& v,
                      const std::function<bool(std::uint32_t, std::uint32_t)>& left_out = {});

/// The lattice field L(seed, m) on n x n cells of the unit square; `hole`: without the middle.
PlaneField lattice_field(std::uint64_t seed, std::uint32_t m, std::uint32_t n, bool hole);

/// Square rings |x|max = size around a hole, eight vertices each, v = strength x + (-y, x) / 2;
/// ring r has vertices 8 r to 8 r + 7, from (size, 0) on.
PlaneField ring_field(const std::vector<std::array<double, 2>>& size_and_strength);

/// Everything but traps and ways: all separatrices are undecided. Exact, also for fields with ties
/// (sectors: where rays are 1/512 of a cone apart).
certify::SkeletonCertificate reference_points(const PlaneField& field);

/// All of it; lines that cannot be followed are undecided. Then the lines that the checker refuses
/// are made undecided, too.
certify::SkeletonCertificate reference_skeleton(const PlaneField& field);

}  // namespace crest::tests
