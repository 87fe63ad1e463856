// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Whether a quadratic has a zero on a segment (SPEC.md, lemma 21), over intervals, balls or
// rationals.
#include <optional>

#include "certify/exact/quadratic_spline.hpp"
#include "certify/spline_rays/long_ball.hpp"

namespace crest::certify::spline_rays {

/// Bernstein coefficients along a segment.
template <class Number>
using Along = std::array<Number, 3>;

inline kernel::MaybeSign sign_if_certain(const kernel::Interval& x) {
  return certain_sign(x);
}
inline kernel::MaybeSign sign_if_certain(const LongBall& x) {
  return certain_sign(x);
}
inline kernel::MaybeSign sign_if_certain(const kernel::Rational& x) {
  return kernel::sign_of(x);
}

/// On the closed segment. Always decided over rationals.
template <class Number>
std::optional<bool> has_zero(const Along<Number>& b) {
  using kernel::Sign;
  const auto first = sign_if_certain(b[0]), last = sign_if_certain(b[2]);
  if (!first || !last) return std::nullopt;
  if (*first * *last != Sign::positive) return true;
  const auto middle = sign_if_certain(b[1]);
  if (middle && *middle != -*first) return false;
  const auto excess = sign_if_certain(Number(b[1] * b[1] - b[0] * b[2]));
  if (excess && *excess == Sign::negative) return false;
  if (!middle || !excess) return std::nullopt;
  return true;
}

/// On the segment without its last point. Always decided over rationals.
template <class Number>
std::optional<bool> has_zero_before_end(const Along<Number>& b) {
  using kernel::Sign;
  const auto first = sign_if_certain(b[0]), last = sign_if_certain(b[2]);
  if (!first || !last) return std::nullopt;
  if (*first == Sign::zero) return true;
  if (*last != Sign::zero) return has_zero(b);
  const auto middle = sign_if_certain(b[1]);
  if (!middle) return std::nullopt;
  return *middle == -*first;
}

}  // namespace crest::certify::spline_rays
