// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Sign of the volume that oriented triangles enclose.
//
// enclosed_volume is the sign of the sum of the determinants (a - o, b - o, c - o) of the faces,
// six times the volume counted with the surface's windings, decided exactly; o is the first corner.
// Laws, for closed surfaces. (1) turning every face turns the sign. (2) invariant under translation
// and scaling by powers of two (barring rounding). (3) positive for a convex body whose faces are
// counter-clockwise from outside. (4) zero if every face is there turned around, too. Not true:
// that a positive sign means a surface without self-intersections.
#include <cstdint>
#include <span>

#include "kernel/arithmetic/stage.hpp"
#include "kernel/arithmetic/vec3.hpp"

namespace crest::kernel {

using FaceCorners = std::array<std::uint32_t, 3>;

/// With the stage that decided. Requires: finite points, indices below points.size().
Decision enclosed_volume_decision(std::span<const Vec3> points, std::span<const FaceCorners> faces);

inline Sign enclosed_volume(std::span<const Vec3> points, std::span<const FaceCorners> faces) {
  return enclosed_volume_decision(points, faces).sign;
}

}  // namespace crest::kernel
