// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The forms of a simplex in integers: Cramer's rule instead of elimination, each form times a
// positive number.
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "algorithms/modes/degenerate_conic.hpp"
#include "kernel/arithmetic/rational.hpp"
#include "kernel/polynomial/algebraic_number.hpp"
#include "kernel/polynomial/dyadic.hpp"
#include "kernel/polynomial/integer_polynomial.hpp"

namespace crest::modes {

using kernel::Integer;

/// t(T_i), all times one power of two.
template <std::size_t K>
std::array<std::array<Integer, 5>, K> integer_rows(const std::array<const Tensor*, K>& corners) {
  std::vector<double> all;
  for (const Tensor* t : corners) all.insert(all.end(), t->begin(), t->end());
  const std::vector<Integer> x = *kernel::integers(all);  // finite by the callers' contracts
  std::array<std::array<Integer, 5>, K> rows;
  for (std::size_t i = 0; i < K; ++i) {
    const Integer* t = &x[6 * i];
    rows[i] = {t[0] - t[2], t[1] - t[2], 2 * t[3], 2 * t[4], 2 * t[5]};
  }
  return rows;
}

template <std::size_t K>
Integer determinant(const std::array<std::array<Integer, K>, K>& m);

/// The determinant without a row and a column.
template <std::size_t K>
Integer minor_of(const std::array<std::array<Integer, K>, K>& m, std::size_t row,
                 std::size_t column) {
  std::array<std::array<Integer, K - 1>, K - 1> rest;
  for (std::size_t i = 0, a = 0; i < K; ++i) {
    if (i == row) continue;
    for (std::size_t j = 0, b = 0; j < K; ++j)
      if (j != column) rest[a][b++] = m[i][j];
    ++a;
  }
  return determinant<K - 1>(rest);
}

template <std::size_t K>
Integer determinant(const std::array<std::array<Integer, K>, K>& m) {
  if constexpr (K == 1) {
    return m[0][0];
  } else {
    Integer sum = 0;
    for (std::size_t k = 0; k < K; ++k) {
      if (m[0][k].is_zero()) continue;
      const Integer term = m[0][k] * minor_of(m, 0, k);
      sum += k % 2 ? Integer(-term) : term;
    }
    return sum;
  }
}
/// Nothing: dependent deviators.
template <std::size_t K>
std::optional<SimplexForms<Integer, K>> exact_forms(const std::array<const Tensor*, K>& corners) {
  const auto rows = integer_rows<K>(corners);
  std::array<int, 5> pivots{};
  std::fill_n(pivots.begin(), K, 1);  // descending permutations: all choices of K columns
  do {
    std::array<std::size_t, 5> column{};
    for (std::size_t k = 0, chosen = 0, other = K; k < 5; ++k)
      column[pivots[k] ? chosen++ : other++] = k;
    std::array<std::array<Integer, K>, K> m, adjugate;
    for (std::size_t i = 0; i < K; ++i)
      for (std::size_t j = 0; j < K; ++j) m[i][j] = rows[i][column[j]];
    const Integer det = determinant<K>(m);
    if (det.is_zero()) continue;
    const int sign = det.sign();  // adj / |det| is the inverse, up to a positive factor
    for (std::size_t i = 0; i < K; ++i)
      for (std::size_t j = 0; j < K; ++j)
        adjugate[i][j] = ((i + j) % 2 ? -sign : sign) * minor_of<K>(m, j, i);
    SimplexForms<Integer, K> f;
    for (std::size_t k = K; k < 5; ++k) {
      std::array<Integer, 5> w{};
      w[column[k]] = abs(det);
      for (std::size_t i = 0; i < K; ++i)
        for (std::size_t j = 0; j < K; ++j) w[column[i]] -= adjugate[i][j] * rows[j][column[k]];
      f.vanishing[k - K] = traceless(w);
    }
    for (std::size_t j = 0; j < K; ++j) {
      std::array<Integer, 5> w{};
      for (std::size_t i = 0; i < K; ++i) w[column[i]] = adjugate[i][j];
      f.coordinates[j] = traceless(w);
    }
    return f;
  } while (std::prev_permutation(pivots.begin(), pivots.end()));
  return std::nullopt;
}

/// A degenerate point inside a face: v up to a factor, polynomials at a real root.
struct ExactPoint {
  Vector3<Ball> near;
  Vector3<kernel::IntegerPolynomial> v;
  kernel::AlgebraicNumber root;
};
/// Requires: as for face_roots. Those of exact_face_roots, in its order.
std::vector<ExactPoint> exact_face_points(const std::array<const Tensor*, 3>& corners);

/// Whether all tensors of an edge are degenerate: its ends are, and are one another's positive
/// multiples. (A mixture of s v v^T and r w w^T, less multiples of I, has one eigenvalue twice at
/// single places only unless v = +-w.)
inline bool is_degenerate_edge(const Tensor& a, const Tensor& b) {
  const auto [p, q] = integer_rows<2>({&a, &b});
  bool along = false;
  for (std::size_t i = 0; i < 5; ++i) {
    along = along || p[i] * q[i] > 0;
    if (p[i] * q[i] < 0) return false;
    for (std::size_t k = 0; k < i; ++k)
      if (p[i] * q[k] != p[k] * q[i]) return false;
  }
  if (!along) return false;
  // 3 times the deviator times that power of two, in VTK's order.
  const Integer x = 2 * p[0] - p[1], y = 2 * p[1] - p[0], z = -x - y;
  const Integer u = 3 * p[2] / 2, v = 3 * p[3] / 2, w = 3 * p[4] / 2;
  const Integer det = x * (y * z - v * v) - u * (u * z - v * w) + w * (u * v - y * w);
  const Integer square = x * x + y * y + z * z + 2 * (u * u + v * v + w * w);
  return 54 * det * det == square * square * square;
}

/// Times a positive number, so that doubles hold the forms.
inline Conic<Ball> ball(const Conic<Integer>& c, const Integer& scale) {
  Conic<Ball> b;
  for (std::size_t k = 0; k < 6; ++k) {
    const auto mid = static_cast<double>(kernel::Rational(c.c[k], scale));
    b.c[k] = {mid, 0x1p-51 * std::fabs(mid) + Ball::kTiny};
  }
  return b;
}
inline Integer largest(std::span<const Conic<Integer>> forms) {
  Integer most = 1;
  for (const auto& f : forms)
    for (const Integer& x : f.c) most = std::max<Integer>(most, abs(x));
  return most;
}

}  // namespace crest::modes
