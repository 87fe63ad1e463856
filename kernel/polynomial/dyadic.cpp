// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/polynomial/dyadic.hpp"

#include <mpfr.h>

#include <algorithm>
#include <cmath>

namespace crest::kernel {
namespace {

Integer up(const Integer& x, long bits) {
  return x << static_cast<unsigned long>(bits);
}

// Two roundings in one direction are one.
double rounded(const Dyadic& x, mpfr_rnd_t direction) {
  const auto& z = x.mantissa.backend().data();
  // A double as it is: neither rounded nor subnormal bits lost.
  if (mpz_sizeinbase(z, 2) <= 53 && x.exponent >= -1074 && x.exponent <= 970)
    return std::ldexp(mpz_get_d(z), static_cast<int>(x.exponent));
  mpfr_t t;
  mpfr_init2(t, 53);
  mpfr_set_z_2exp(t, z, x.exponent, direction);
  const double result = mpfr_get_d(t, direction);
  mpfr_clear(t);
  return result;
}

}  // namespace

Rational Dyadic::value() const {
  return exponent >= 0 ? Rational(up(mantissa, exponent))
                       : Rational(mantissa, up(Integer(1), -exponent));
}
double Dyadic::lower() const {
  return rounded(*this, MPFR_RNDD);
}
double Dyadic::upper() const {
  return rounded(*this, MPFR_RNDU);
}

Dyadic operator+(const Dyadic& a, const Dyadic& b) {
  const long e = std::min(a.exponent, b.exponent);
  return {up(a.mantissa, a.exponent - e) + up(b.mantissa, b.exponent - e), e};
}
Dyadic operator-(const Dyadic& a, const Dyadic& b) {
  return a + Dyadic{-b.mantissa, b.exponent};
}

Dyadic dyadic(double x) {
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);
  Dyadic r{Integer(std::ldexp(fraction, 53)), exponent - 53L};
  if (r.mantissa.is_zero()) return {};
  const unsigned long zeros = mpz_scan1(r.mantissa.backend().data(), 0);
  return {r.mantissa >> zeros, r.exponent + static_cast<long>(zeros)};
}

Sign compare(const Dyadic& a, const Dyadic& b) {
  const long e = std::min(a.exponent, b.exponent);
  return static_cast<Sign>(
      (up(a.mantissa, a.exponent - e) - up(b.mantissa, b.exponent - e)).sign());
}
Sign compare(const Dyadic& a, const Rational& b) {
  return sign_of(a.value() - b);
}

}  // namespace crest::kernel
