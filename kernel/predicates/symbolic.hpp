// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// All symbolic perturbation of Crest: how exact zeros are resolved, and why it is consistent.
//
// Every rule is odd in each frame (negating d1 negates the answer), so the graph does not depend on
// the arbitrary signs of the stored frames, and symmetric in an edge's ends, so both triangles of
// an edge see the same answer. The order of the coordinates x, y, z is the only convention.
#include "kernel/arithmetic/vec3.hpp"
#include "kernel/predicates/ladder.hpp"

namespace crest::kernel {

/// Sign of d.e after the identity is perturbed to I + eps M1 + eps^2 M2 + ..., the M_i being the
/// symmetric matrices xx, yy, zz, xy+yx, xz+zx, yz+zy in this order. Requires: d.e is exactly zero,
/// d and e not zero vectors. Guarantees: not zero (the M_i span the symmetric matrices, and the
/// symmetric part of d e^T vanishes for no non-zero pair).
Sign symbolic_product(const Vec3& d, const Vec3& e);

/// Sign of an extremality that is exactly zero: that of +eps in the frame whose d1 has its first
/// non-zero coordinate positive. Requires: d1 not the zero vector.
inline Sign symbolic_extremality(const Vec3& d1) {
  for (double x : d1)
    if (x != 0) return sign_of(x);
  return Sign::zero;
}

}  // namespace crest::kernel
