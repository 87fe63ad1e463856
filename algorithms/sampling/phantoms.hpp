// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Volumes that hold one bright sheet, and points on a surface with normals of any sign: inputs with
// known answers for extremal surfaces.
#include <cstdint>
#include <string>
#include <vector>

#include "algorithms/sampling/surfaces.hpp"
#include "kernel/geometry/sampled_grid.hpp"

namespace crest::sampling {

/// What is true of the sheet.
struct SheetFacts {
  int euler_characteristic = 0, boundary_loops = 0;
  bool orientable = true;
};

struct Phantom {
  std::string name, summary;
  SheetFacts known;
};

/// sphere-shell, ellipsoid-shell, torus-shell, genus2-shell, moebius-sheet, junction: in [-1, 1]^3,
/// the profile exp(-(d/0.09)^2) across the sheet. A junction is three half planes that meet in a
/// line, no surface there: the facts are those of the union.
const std::vector<Phantom>& volume_phantoms();
/// moebius-points, hemisphere-points.
const std::vector<Phantom>& point_phantoms();

/// N nodes along each axis, at -1 + 2 i/(N - 1), in single precision. Requires: a name of
/// volume_phantoms(), nodes > 1.
kernel::SampledGrid volume_phantom(const std::string& name, std::size_t nodes);

struct OrientlessPoints {
  std::vector<kernel::Vec3> points, normals;  ///< unit normals with random signs
};

/// Random points: of the strip ((1 + w cos(u/2)) cos u, .. sin u, w sin(u/2)), |w| <= 0.45, uniform
/// in u and w; of the upper half of the unit sphere, uniform in area. `noise`: the standard
/// deviation along the normals, which stay. The same bytes for the same arguments.
/// Requires: a name of point_phantoms().
OrientlessPoints point_phantom(const std::string& name, int count, double noise,
                               std::uint64_t seed);

}  // namespace crest::sampling
