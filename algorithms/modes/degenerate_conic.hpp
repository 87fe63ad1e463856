// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Degenerate tensors of a simplex's linear field, over any number type (Ball, Integer).
//
// A traceless T is degenerate iff T = s (v v^T - I/3) with s != 0, v != 0. With t(T) = (xx - zz,
// yy - zz, 2xy, 2yz, 2xz), which does not see multiples of I, a linear form w on tensors vanishes
// on I iff it is w . t, and w . t(v v^T) is the quadratic form of the traceless matrix (w0, w1, -w0
// - w1; w2, w3, w4). So v v^T - I/3 lies in the span of the corners' deviators iff the forms of all
// w with w . t(T_i) = 0 vanish at v: two conics P, Q for a face, one (the tensor Tbar of paper 004,
// equation 3) for a tet; and its coordinates there are forms of the same kind (B_i of the README).
// Nothing here needs the deviators themselves.
#include <array>
#include <cmath>
#include <optional>

#include "algorithms/modes/degenerate_result.hpp"
#include "kernel/arithmetic/ball.hpp"
#include "kernel/arithmetic/vec3.hpp"

namespace crest::modes {

using kernel::Ball;
using kernel::Vector3;

/// A symmetric matrix as a quadratic form; xx yy zz xy yz xz.
template <class N>
struct Conic {
  std::array<N, 6> c;

  N at(const Vector3<N>& v) const {
    const N mixed = c[3] * (v[0] * v[1]) + c[4] * (v[1] * v[2]) + c[5] * (v[0] * v[2]);
    return c[0] * (v[0] * v[0]) + c[1] * (v[1] * v[1]) + c[2] * (v[2] * v[2]) + (mixed + mixed);
  }
  Vector3<N> times(const Vector3<N>& v) const {
    return {c[0] * v[0] + c[3] * v[1] + c[5] * v[2], c[3] * v[0] + c[1] * v[1] + c[4] * v[2],
            c[5] * v[0] + c[4] * v[1] + c[2] * v[2]};
  }
  N det() const {
    return c[0] * (c[1] * c[2] - c[4] * c[4]) - c[3] * (c[3] * c[2] - c[4] * c[5]) +
           c[5] * (c[3] * c[4] - c[1] * c[5]);
  }
};

/// w of the header as a traceless form.
template <class N>
Conic<N> traceless(const std::array<N, 5>& w) {
  return {{w[0], w[1], N(0) - (w[0] + w[1]), w[2], w[3], w[4]}};
}

/// t(T), and for the corners after the first t(T_i) - t(T_0): neighbours in a mesh differ little,
/// and what they have in common costs no digits.
template <class N, std::size_t K>
std::array<std::array<N, 5>, K> corner_rows(const std::array<const Tensor*, K>& corners) {
  std::array<std::array<N, 5>, K> rows;
  for (std::size_t i = 0; i < K; ++i) {
    const Tensor& t = *corners[i];
    rows[i] = {N(t[0]) - N(t[2]), N(t[1]) - N(t[2]), N(t[3]) + N(t[3]), N(t[4]) + N(t[4]),
               N(t[5]) + N(t[5])};
    if (i == 0) continue;
    for (std::size_t k = 0; k < 5; ++k) rows[i][k] = rows[i][k] - rows[0][k];
  }
  return rows;
}

/// The forms of a simplex with K corners. Requires of both: independent deviators.
template <class N, std::size_t K>
struct SimplexForms {
  std::array<Conic<N>, 5 - K> vanishing;  ///< P, Q of a face; Tbar, up to a factor, of a tet
  std::array<Conic<N>, K> coordinates;    ///< s times the barycentric coordinates at v
};

/// Gauss-Jordan with the largest pivot of all, the row operations kept.
template <std::size_t K>
struct Elimination {
  std::array<std::array<Ball, 5>, K> rows;
  std::array<std::array<Ball, K>, K> left{};  ///< left x given rows = rows
  std::array<std::size_t, 5> column{0, 1, 2, 3, 4};

  explicit Elimination(const std::array<std::array<Ball, 5>, K>& given) : rows(given) {
    for (std::size_t i = 0; i < K; ++i) left[i][i] = 1;
  }

  /// False: not decided.
  bool run() {
    for (std::size_t rank = 0; rank < K; ++rank) {
      choose_pivot(rank);
      const Ball pivot = rows[rank][column[rank]];
      if (!certain_sign(pivot)) return false;
      const Ball factor = Ball(1) / pivot;
      for (std::size_t k = rank + 1; k < 5; ++k)
        rows[rank][column[k]] = rows[rank][column[k]] * factor;
      for (std::size_t j = 0; j < K; ++j) left[rank][j] = left[rank][j] * factor;
      for (std::size_t i = 0; i < K; ++i)
        if (i != rank) subtract(i, rank);
    }
    return true;
  }

  SimplexForms<Ball, K> forms() const {
    SimplexForms<Ball, K> f;
    for (std::size_t k = K; k < 5; ++k) {
      std::array<Ball, 5> w{};
      w[column[k]] = 1;
      for (std::size_t i = 0; i < K; ++i) w[column[i]] = -rows[i][column[k]];
      f.vanishing[k - K] = traceless(w);
    }
    std::array<std::array<Ball, 5>, K> b{};
    for (std::size_t j = 0; j < K; ++j)
      for (std::size_t i = 0; i < K; ++i) b[j][column[i]] = left[i][j];
    // The rows are differences: the first corner has what the others leave.
    for (std::size_t j = 1; j < K; ++j)
      for (std::size_t i = 0; i < K; ++i) b[0][column[i]] = b[0][column[i]] - left[i][j];
    for (std::size_t j = 0; j < K; ++j) f.coordinates[j] = traceless(b[j]);
    return f;
  }

 private:
  void choose_pivot(std::size_t rank) {
    std::size_t row = rank, place = rank;
    double largest = 0;
    for (std::size_t i = rank; i < K; ++i)
      for (std::size_t k = rank; k < 5; ++k)
        if (const double w = std::fabs(rows[i][column[k]].mid); w > largest)
          largest = w, row = i, place = k;
    std::swap(rows[rank], rows[row]);
    std::swap(left[rank], left[row]);
    std::swap(column[rank], column[place]);
  }
  void subtract(std::size_t i, std::size_t rank) {
    const Ball factor = rows[i][column[rank]];
    for (std::size_t k = rank + 1; k < 5; ++k)
      rows[i][column[k]] = rows[i][column[k]] - factor * rows[rank][column[k]];
    for (std::size_t j = 0; j < K; ++j) left[i][j] = left[i][j] - factor * left[rank][j];
  }
};

/// Nothing: not decided.
template <std::size_t K>
std::optional<SimplexForms<Ball, K>> triage_forms(const std::array<const Tensor*, K>& corners) {
  Elimination<K> e(corner_rows<Ball, K>(corners));
  if (!e.run()) return std::nullopt;
  return e.forms();
}

/// The common points of two conics, seen from a point (the z axis) that is not on both: with the
/// multiple of P that takes z^2 away, Q = q(x, y) + 2 z l(x, y), so z = -q / (2 l), and P there is
/// F / (4 l^2) with F = p q^2 - 4 m l q + 4 n l^2 for P = p z^2 + 2 z m + n.
/// Law. A simple root of F is one common point v = (2 l x, 2 l y, -q): where l = 0, q = 0 too, and
/// the root is not simple.
template <class N>
struct PencilQuartic {
  std::array<N, 5> f;  ///< coefficient k: x^k y^(4 - k)
  std::array<N, 3> q;  ///< y^2, x y, x^2
  std::array<N, 2> l;  ///< y, x
  N p;
  std::array<N, 2> m;
  std::array<N, 3> n;

  /// Requires: P's z^2 is not zero.
  PencilQuartic(const Conic<N>& P, const Conic<N>& Q)
      : p(P.c[2]), m{P.c[4], P.c[5]}, n{P.c[1], P.c[3] + P.c[3], P.c[0]} {
    const auto less = [&](std::size_t i) { return p * Q.c[i] - Q.c[2] * P.c[i]; };
    const N xy = less(3);
    q = {less(1), xy + xy, less(0)};
    l = {less(4), less(5)};
    // F = q (p q - 4 m l) + n (2 l)^2
    const std::array<N, 3> ll = product(l, l), ml = product(m, l);
    std::array<N, 3> inner, twice;
    for (std::size_t k = 0; k < 3; ++k) {
      inner[k] = p * q[k] - N(4) * ml[k];
      twice[k] = N(4) * ll[k];
    }
    const std::array<N, 5> a = product(q, inner), b = product(n, twice);
    for (std::size_t k = 0; k < 5; ++k) f[k] = a[k] + b[k];
  }

  Vector3<N> point(const N& x, const N& y) const {
    const N line = l[0] * y + l[1] * x, two = line + line;
    const N conic = q[0] * (y * y) + q[1] * (x * y) + q[2] * (x * x);
    return {two * x, two * y, N(0) - conic};
  }

 private:
  static std::array<N, 3> product(const std::array<N, 2>& a, const std::array<N, 2>& b) {
    return {a[0] * b[0], a[0] * b[1] + a[1] * b[0], a[1] * b[1]};
  }
  static std::array<N, 5> product(const std::array<N, 3>& a, const std::array<N, 3>& b) {
    return {a[0] * b[0], a[0] * b[1] + a[1] * b[0], a[0] * b[2] + a[1] * b[1] + a[2] * b[0],
            a[1] * b[2] + a[2] * b[1], a[2] * b[2]};
  }
};

}  // namespace crest::modes
