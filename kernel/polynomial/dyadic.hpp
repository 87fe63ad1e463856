// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Integers (GMP) and dyadic numbers: mantissa * 2^exponent. Bisection never leaves them.
#include <boost/multiprecision/gmp.hpp>

#include "kernel/arithmetic/rational.hpp"
#include "kernel/arithmetic/sign.hpp"

namespace crest::kernel {

using Integer =
    boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;

inline Sign sign_of(const Integer& x) {
  return static_cast<Sign>(x.sign());
}
/// Bits of |x|; 0 for 0.
inline long bit_length(const Integer& x) {
  return x.is_zero() ? 0 : static_cast<long>(mpz_sizeinbase(x.backend().data(), 2));
}

struct Dyadic {
  Integer mantissa;
  long exponent = 0;

  Rational value() const;
  /// Nearest doubles below and above; equal iff the number is a double. Infinite on overflow.
  double lower() const;
  double upper() const;

  friend Dyadic operator+(const Dyadic& a, const Dyadic& b);
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b);
  /// a 2^k.
  friend Dyadic shifted(const Dyadic& a, long k) { return {a.mantissa, a.exponent + k}; }
};

/// Requires: x finite.
Dyadic dyadic(double x);
/// The sign of a - b.
Sign compare(const Dyadic& a, const Dyadic& b);
Sign compare(const Dyadic& a, const Rational& b);
inline Dyadic middle(const Dyadic& a, const Dyadic& b) {
  return shifted(a + b, -1);
}

}  // namespace crest::kernel
