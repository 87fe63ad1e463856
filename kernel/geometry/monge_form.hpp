// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The Monge form of a surface at a point (paper 002, equations 1 and 2).
#include "kernel/arithmetic/vec3.hpp"
#include "kernel/predicates/crossing_type.hpp"

namespace crest::kernel {

/// In the direct orthonormal frame (d1, d2, n) at the point,
///   z = (k1 x^2 + k2 y^2)/2 + (b0 x^3 + 3 b1 x^2 y + 3 b2 x y^2 + b3 y^3)/6
///     + (c0 x^4 + 4 c1 x^3 y + 6 c2 x^2 y^2 + 4 c3 x y^3 + c4 y^4)/24 + ...
/// with k1 >= k2. n is the mesh's side (outward on a closed mesh with outward faces: there a convex
/// point has k1, k2 <= 0); d2 = n x d1. Switching to the frame (-d1, -d2, n) negates b0..b3.
/// Units: k 1/length, b 1/length^2, c 1/length^3. All numbers are doubles, hence exact rationals.
struct MongeForm {
  Vec3 d1{}, n{};
  double k1 = 0, k2 = 0;
  double b0 = 0, b1 = 0, b2 = 0, b3 = 0;
  double c0 = 0, c1 = 0, c2 = 0, c3 = 0, c4 = 0;
};

/// d2 = n x d1 in plain double (for output; decisions use the exact product).
inline Vec3 minimal_direction(const MongeForm& m) {
  return cross(m.n, m.d1);
}

inline RidgeEndData blue_end(const MongeForm& f) {
  return {f.b0, f.k1, f.k2, f.b1, f.c0};
}
inline RidgeEndData red_end(const MongeForm& f) {
  return {f.b3, f.k2, f.k1, f.b2, f.c4};
}

/// P1 = 3 b1^2 + (k1 - k2)(c0 - 3 k1^3): along the blue line k1'' = P1 / (k1 - k2) (equation 3).
inline double blue_p(const MongeForm& f) {
  return InterpolatedP::end_p<double>(blue_end(f));
}
/// P2 = 3 b2^2 + (k2 - k1)(c4 - 3 k2^3): along the red line k2'' = P2 / (k2 - k1).
inline double red_p(const MongeForm& f) {
  return InterpolatedP::end_p<double>(red_end(f));
}

}  // namespace crest::kernel
