// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Plain vectors, and frames (SPEC.md, "Coordinates").
#include "certify/second/surface.hpp"

namespace crest::recheck {

using Plain = std::array<double, 3>;

inline Plain minus(const Plain& a, const Plain& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Plain cross(const Plain& a, const Plain& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// That of a face, from the quaternion; integers, so exact.
inline Frame frame_of(const std::array<int, 4>& quaternion) {
  const double e = quaternion[0], f = quaternion[1], g = quaternion[2], h = quaternion[3];
  return {{{{e * e + f * f - g * g - h * h, 2 * (f * g + e * h), 2 * (f * h - e * g)},
            {2 * (f * g - e * h), e * e - f * f + g * g - h * h, 2 * (g * h + e * f)},
            {2 * (f * h + e * g), 2 * (g * h - e * f), e * e - f * f - g * g + h * h}}},
          1};
}
/// That of a patch: the unit vectors in cyclic order, the axis last.
inline Frame frame_of_axis(Index axis, int sign) {
  Frame frame = {{}, sign};
  for (Index i = 0; i < 3; ++i) frame.axis[i][(axis + 1 + i) % 3] = 1;
  return frame;
}

/// Coordinates of a vector in a frame, up to the square of its length.
inline Vector<Model> in_frame(const Frame& frame, const Vector<Model>& x) {
  Vector<Model> r;
  for (Index i = 0; i < 3; ++i)
    for (Index k = 0; k < 3; ++k) r[i].add_product(Model(frame.axis[i][k]), x[k]);
  return r;
}

}  // namespace crest::recheck
