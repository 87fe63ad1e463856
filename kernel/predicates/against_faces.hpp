// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Does a normal at a vertex point to the side from which the faces around it are clockwise?
//
// against_faces(n, p, sides): n . sum of (q - p) x (r - p) over the sides (q, r) of the faces
// across from p is not positive, decided exactly (certify/ridges_mesh/SPEC.md). Laws. (1) true for
// n or for -n, for both iff the sum is exactly zero. (2) invariant under scaling of n, and under
// the order of the sides. (3) reversing all sides is the same as reversing n.
#include <array>
#include <span>

#include "kernel/arithmetic/vec3.hpp"
#include "kernel/predicates/ladder.hpp"

namespace crest::kernel {

/// The term of one face.
struct AlongNormal {
  Vec3 n, p, q, r;
  /// Minor 5 (CrossCoordinate), product 0 + 5 + 2, two sums.
  static constexpr int depth = 9;
  template <class T>
  T value() const {
    const auto edge = [&](const Vec3& to, std::size_t i) { return T(to[i]) - T(p[i]); };
    const auto minor = [&](std::size_t i, std::size_t j) {
      return edge(q, i) * edge(r, j) - edge(q, j) * edge(r, i);
    };
    return T(n[0]) * minor(1, 2) + T(n[1]) * minor(2, 0) + T(n[2]) * minor(0, 1);
  }
};

/// The sum: of any length, so no double's bound covers it.
struct AlongNormals {
  const Vec3& n;
  const Vec3& p;
  std::span<const std::array<Vec3, 2>> sides;
  template <class T>
  T value() const {
    T sum(0);
    for (const auto& [q, r] : sides) sum = sum + AlongNormal{n, p, q, r}.value<T>();
    return sum;
  }
};

bool against_faces(const Vec3& n, const Vec3& p, std::span<const std::array<Vec3, 2>> sides);

}  // namespace crest::kernel
