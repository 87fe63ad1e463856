// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// det and |D|^2 of a tensor at a place inside a simplex, with their errors.
#include <algorithm>
#include <cmath>
#include <optional>

#include "certify/exact/tensor_field.hpp"

namespace crest::certify::modes {

struct Invariants {
  double det, det_error, norm, norm_error;
};

/// Of sum weights_i D_i, times a power of two. Requires: weights in [0, 1], each wrong by at most
/// 3 u, whose exact values sum to 1. Nothing where the tensors' size may overflow.
///
/// Scaled so that the corners' entries are at most 1; e bounds the entries' errors (of an average:
/// those of the corners; n products and n - 1 sums, u each of what is at most 1; 3 u n from the
/// weights), m their sizes. det has six products of three entries, each wrong by 3 m^2 e, and at
/// most five roundings; |D|^2 nine of two, 2 m e and eight.
template <std::size_t n>
std::optional<Invariants> invariants(const Field& field, const std::array<u32, n>& corners,
                                     const std::array<double, n>& weights) {
  double size = 0, error = 0;
  for (const u32 v : corners) {
    size = std::max(size, field.approximate(v).largest);
    error = std::max(error, field.approximate(v).error);
  }
  if (!(size > 0x1p-900 && size < 0x1p900)) return std::nullopt;
  const double scale = std::ldexp(1, -std::ilogb(size) - 1);
  Tensor<double> d{};
  double m = 0;
  for (std::size_t k = 0; k < 6; ++k) {
    for (std::size_t i = 0; i < n; ++i)
      d[k] += weights[i] * (field.approximate(corners[i]).entries[k] * scale);
    m = std::max(m, std::fabs(d[k]));
  }
  const double e = widened(error * scale + 5 * n * kUnit);
  m = widened(m + e);
  return Invariants{
      d[0] * (d[1] * d[2] - d[4] * d[4]) - d[3] * (d[3] * d[2] - d[4] * d[5]) +
          d[5] * (d[3] * d[4] - d[1] * d[5]),
      widened(18 * m * m * e + 32 * kUnit * m * m * m),
      d[0] * d[0] + d[1] * d[1] + d[2] * d[2] + 2 * (d[3] * d[3] + d[4] * d[4] + d[5] * d[5]),
      widened(18 * m * e + 80 * kUnit * m * m)};
}

}  // namespace crest::certify::modes
