// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// First, second and third fundamental quantities of a surface in two coordinates, with K
// derivatives, from the jets of a graph or of a parametrisation: I_ij = X_i . X_j, L_ij = N . X_ij,
// T_ijk = N . X_ijk (certify/ridges_smooth/SPEC.md, Forms; N is X_1 x X_2, of a graph (-h_p, -h_q,
// 1) or its opposite).
#include <array>

#include "algorithms/smooth_ridges/local_graph.hpp"
#include "kernel/arithmetic/vec3.hpp"

namespace crest::smooth_ridges {

/// The graph of h over the coordinates, its normal upwards if sign = 1, downwards if -1.
template <class T, int Order>
struct GraphGeometry {
  using Number = T;
  kernel::Jet<T, 2, Order> h;  ///< at the point
  int sign = 1;

  /// I. Requires of this and the next two: K + 1, K + 2, K + 3 <= Order.
  template <int K>
  std::array<kernel::Jet<T, 2, K>, 3> first() const {
    const auto p = partial<K>(h, 1, 0), q = partial<K>(h, 0, 1);
    return {p * p + 1.0, p * q, q * q + 1.0};
  }
  template <int K>
  std::array<kernel::Jet<T, 2, K>, 3> second() const {
    return {up<K>(2, 0), up<K>(1, 1), up<K>(0, 2)};
  }
  template <int K>
  std::array<kernel::Jet<T, 2, K>, 4> third() const {
    return {up<K>(3, 0), up<K>(2, 1) * 3.0, up<K>(1, 2) * 3.0, up<K>(0, 3)};
  }

 private:
  template <int K>
  kernel::Jet<T, 2, K> up(int a, int b) const {
    auto f = partial<K>(h, a, b);
    return sign > 0 ? f : -f;
  }
};

/// A parametric surface, its three coordinates' jets at the point.
template <class T, int Order>
struct MapGeometry {
  using Number = T;
  std::array<kernel::Jet<T, 2, Order>, 3> x;

  template <int K>
  std::array<kernel::Jet<T, 2, K>, 3> first() const {
    const auto x1 = derivative<K>(1, 0), x2 = derivative<K>(0, 1);
    return {dot(x1, x1), dot(x1, x2), dot(x2, x2)};
  }
  template <int K>
  std::array<kernel::Jet<T, 2, K>, 3> second() const {
    const auto n = normal<K>();
    return {dot(n, derivative<K>(2, 0)), dot(n, derivative<K>(1, 1)), dot(n, derivative<K>(0, 2))};
  }
  template <int K>
  std::array<kernel::Jet<T, 2, K>, 4> third() const {
    const auto n = normal<K>();
    return {dot(n, derivative<K>(3, 0)), dot(n, derivative<K>(2, 1)) * 3.0,
            dot(n, derivative<K>(1, 2)) * 3.0, dot(n, derivative<K>(0, 3))};
  }

 private:
  template <int K>
  using Vector = kernel::Vector3<kernel::Jet<T, 2, K>>;

  template <int K>
  Vector<K> derivative(int a, int b) const {
    return {partial<K>(x[0], a, b), partial<K>(x[1], a, b), partial<K>(x[2], a, b)};
  }
  template <int K>
  Vector<K> normal() const {
    return cross(derivative<K>(1, 0), derivative<K>(0, 1));
  }
};

}  // namespace crest::smooth_ridges
