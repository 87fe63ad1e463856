// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Whether a leaf is empty or simple (SPEC.md, "Leaves"), over intervals or rationals: an answer may
// be missing over intervals only.
#include <optional>

#include "certify/exact/quadratic_spline.hpp"
#include "certify/spline_isosurface/bisection.hpp"

namespace crest::certify::spline_isosurface {

/// Below 0, which counts as positive elsewhere.
inline std::optional<bool> is_negative(const kernel::Interval& x) {
  if (!is_defined(x) || (x.inf() < 0 && x.sup() >= 0)) return std::nullopt;
  return x.sup() < 0;
}
inline std::optional<bool> is_negative(const kernel::Rational& x) {
  return x < 0;
}
/// Above 0.
template <class Number>
std::optional<bool> is_positive(const Number& x) {
  return is_negative(Number(-x));
}

/// s - c on a leaf: Bernstein coefficients.
template <class Number>
struct LeafForm {
  Quadratic<Number> b;
  std::array<std::array<double, 3>, 4> corners;  ///< small integers

  /// Along an edge.
  std::array<Number, 3> edge(std::size_t i, std::size_t j) const {
    return {b[i][i], b[i][j], b[j][j]};
  }
};

/// The corners of a leaf, less the first one, in the largest unit that makes them integers.
inline std::array<std::array<double, 3>, 4> small_corners(const Simplex& leaf) {
  std::int64_t unit = 0;
  for (const Point& corner : leaf.corners)
    for (std::size_t d = 0; d < 3; ++d) unit |= corner[d] - leaf.corners[0][d];
  unit &= -unit;
  std::array<std::array<double, 3>, 4> corners;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t d = 0; d < 3; ++d)
      corners[i][d] = static_cast<double>((leaf.corners[i][d] - leaf.corners[0][d]) / unit);
  return corners;
}

/// `root_form` is s on the tetrahedron of the partition, `cube` the lowest corner of its cube.
template <class Number>
LeafForm<Number> leaf_form(const Quadratic<Number>& root_form, const Tetrahedron& tet,
                           const Point& cube, const Simplex& leaf, double level) {
  LeafForm<Number> form{root_form, small_corners(leaf)};
  if (leaf.tag != 0) {
    std::array<std::array<Number, 4>, 4> weights;
    for (std::size_t i = 0; i < 4; ++i) {
      std::array<Number, 3> from_centre;
      for (std::size_t d = 0; d < 3; ++d) {
        const std::int64_t x = leaf.corners[i][d] - kScale * (cube[d] + 1);
        from_centre[d] = Number(static_cast<double>(x) / static_cast<double>(kScale));
      }
      weights[i] = barycentrics(tet, from_centre);
    }
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i; j < 4; ++j)
        form.b[i][j] = form.b[j][i] = blossom(root_form, weights[i], weights[j]);
  }
  for (auto& row : form.b)
    for (Number& b : row) b = b - Number(level);
  return form;
}

/// All coefficients of the corners `which` (bits) negative, or none.
template <class Number>
std::optional<bool> is_empty(const LeafForm<Number>& form, unsigned which) {
  bool negative = false, positive = false, unknown = false;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i; j < 4; ++j) {
      if ((which >> i & which >> j & 1U) == 0) continue;
      const auto sign = is_negative(form.b[i][j]);
      unknown = unknown || !sign;
      negative = negative || (sign && *sign);
      positive = positive || (sign && !*sign);
    }
  if (negative && positive) return false;
  if (unknown) return std::nullopt;
  return true;
}

/// (i): the edge has a zero of s = c - e, for all small e > 0, iff its ends have different signs.
template <class Number>
std::optional<bool> is_simple_edge(const std::array<Number, 3>& b) {
  const auto first = is_negative(b[0]), last = is_negative(b[2]);
  if (!first || !last) return std::nullopt;
  if (*first != *last) return true;
  const auto middle = is_negative(b[1]);
  const Number excess = b[1] * b[1] - b[0] * b[2];
  if (!*first) {  // both not negative
    if (middle && !*middle) return true;
    const auto more = is_positive(excess);
    if (more && !*more) return true;
    return middle && more ? std::optional(false) : std::nullopt;
  }
  if (middle && *middle) return true;
  const auto less = is_negative(excess);
  if (less && *less) return true;
  return middle && less ? std::optional(false) : std::nullopt;
}

/// (ii), (iii): on the simplex of the corners listed (3 or 4), the gradient of s restricted to it
/// has a positive product with its mean, at all of them.
template <class Number, std::size_t n>
std::optional<bool> is_monotone(const LeafForm<Number>& form,
                                const std::array<std::size_t, n>& list) {
  constexpr std::size_t m = n - 1;
  // Products of the sides at the first corner, and the adjugate of their matrix.
  std::array<std::array<double, 3>, 3> gram{}, adjugate{};
  gram[2][2] = 1;
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j < m; ++j) {
      gram[i][j] = 0;
      for (std::size_t d = 0; d < 3; ++d)
        gram[i][j] += (form.corners[list[i + 1]][d] - form.corners[list[0]][d]) *
                      (form.corners[list[j + 1]][d] - form.corners[list[0]][d]);
    }
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t r1 = (j + 1) % 3, r2 = (j + 2) % 3, k1 = (i + 1) % 3, k2 = (i + 2) % 3;
      adjugate[i][j] = gram[r1][k1] * gram[r2][k2] - gram[r1][k2] * gram[r2][k1];
    }
  // Derivatives along the sides, halved, and their sum over the corners, turned into a vector.
  std::array<std::array<Number, m>, n> slopes;
  std::array<Number, m> sum, dual;
  sum.fill(Number(0));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < m; ++j) {
      slopes[i][j] = form.b[list[i]][list[j + 1]] - form.b[list[i]][list[0]];
      sum[j] = sum[j] + slopes[i][j];
    }
  for (std::size_t i = 0; i < m; ++i) {
    dual[i] = Number(0);
    for (std::size_t j = 0; j < m; ++j) dual[i] = dual[i] + Number(adjugate[i][j]) * sum[j];
  }
  bool unknown = false;
  for (const auto& slope : slopes) {
    Number product(0);
    for (std::size_t j = 0; j < m; ++j) product = product + slope[j] * dual[j];
    const auto positive = is_positive(product);
    if (positive && !*positive) return false;
    unknown = unknown || !positive;
  }
  if (unknown) return std::nullopt;
  return true;
}

enum class LeafKind { empty, simple, neither };

/// Over rationals there is always an answer.
template <class Number>
std::optional<LeafKind> kind_of(const LeafForm<Number>& form) {
  const auto empty = is_empty(form, 15);
  if (!empty) return std::nullopt;
  if (*empty) return LeafKind::empty;
  bool unknown = false;
  const auto fails = [&](const std::optional<bool>& holds) {
    unknown = unknown || !holds;
    return holds && !*holds;
  };
  if (fails(is_monotone(form, std::array<std::size_t, 4>{0, 1, 2, 3}))) return LeafKind::neither;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j)
      if (fails(is_simple_edge(form.edge(i, j)))) return LeafKind::neither;
  for (unsigned out = 0; out < 4; ++out) {
    const auto empty_face = is_empty(form, 15U ^ 1U << out);
    if (empty_face && *empty_face) continue;
    std::array<std::size_t, 3> face{};
    for (std::size_t i = 0, k = 0; i < 4; ++i)
      if (i != out) face[k++] = i;
    const auto monotone = is_monotone(form, face);
    if (monotone && *monotone) continue;
    if (!empty_face || !monotone)
      unknown = true;
    else
      return LeafKind::neither;
  }
  if (unknown) return std::nullopt;
  return LeafKind::simple;
}

}  // namespace crest::certify::spline_isosurface
