// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Plane vectors of rationals.
#include <optional>

#include "kernel/arithmetic/rational.hpp"
#include "kernel/arithmetic/vec3.hpp"

namespace crest::vector_fields {

using kernel::Rational;
using Exact = kernel::Vector2<Rational>;

inline Exact exact(const kernel::Vec2& a) {
  return {Rational(a[0]), Rational(a[1])};
}

/// Of a square.
inline std::optional<Rational> square_root(const Rational& x) {
  using Integer = boost::multiprecision::mpz_int;
  if (x < 0) return std::nullopt;
  const Integer n = numerator(x), d = denominator(x);
  const Integer p = sqrt(n), q = sqrt(d);
  if (p * p != n || q * q != d) return std::nullopt;
  return Rational(p) / Rational(q);
}

/// As two doubles, if they hold a positive multiple of it exactly.
inline std::optional<kernel::Vec2> as_doubles(const Exact& d) {
  const Rational scale = abs(d[0]) > abs(d[1]) ? abs(d[0]) : abs(d[1]);
  const Rational common = Rational(denominator(d[0])) * Rational(denominator(d[1]));
  for (const Exact& e :
       {d, Exact{d[0] / scale, d[1] / scale}, Exact{d[0] * common, d[1] * common}}) {
    const kernel::Vec2 x = {static_cast<double>(e[0]), static_cast<double>(e[1])};
    if (exact(x) == e) return x;
  }
  return std::nullopt;
}

}  // namespace crest::vector_fields
