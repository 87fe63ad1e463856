// SPDX-License-Identifier: GPL-3.0-or-later
// Cody and Waite's reduction (Software Manual for the Elementary Functions, 1980), Taylor
// polynomials, and the errors they make. u = 2^-53; half an ulp below 2^e is at most u 2^(e-1).
//
// Theorem (reduction). Let P = H + L + d be ln 2 or pi / 2 with H of 33 bits, |d| <= half an ulp of
// L, and k an integer near x / P, |k| < 2^19. Then k H is exact; x - k H is exact: it is a multiple
// of 2^-54 and below 1/2 (ln 2), or of 2^-53 and below 1 (pi / 2), as |x| > 0.4 P unless k = 0. So
// r = (x - k H) - k L errs by half an ulp of r, by half one of k L and by |k d|:
//   ln 2, |x| <= 700:      |r| < 0.34658, the error is at most 2^-55 + 2^-74 < 0.26 u;
//   pi / 2, |x| <= 2^19:   |r| < 0.78545, the error is at most 2^-54 + 2^-66 < 0.51 u.
//
// Theorem (exp). With Q_i the sum of r^(j - i) / j! over j from i to 13 and e_i the error of its
// Horner scheme, e_i <= |r| e_(i+1) + |r Q_(i+1)| u + |Q_i| u, and u / i! more for the constants
// that are not exact: e_3 < 0.4 u, e_2 < 0.8 u, e_1 < 1.8 u, e_0 < 2.5 u for r > 0 (Q_0 >= 1) and
// e_0 < 2.0 u for r < 0 (Q_0 > 0.707): at most 2.9 u of Q_0. What is left out is below 0.04 u, the
// error of r adds 0.26 u: together less than 4 u of e^x. 2^k is exact, the result not subnormal.
//
// Theorem (sin, cos). With z = r r: sin r = r - r z S(z), |z S| < 0.103, |r z S| < 0.081, computed
// within 6 u of itself: 0.5 u; the difference's half an ulp 0.5 u, the error of r at most 0.51 u,
// what is left out (r^19 / 19!) below 0.001 u. cos r = 1 - z C(z), |z C| < 0.31, computed within 4
// u of itself: 1.3 u, then 0.5 u, 0.37 u, and 0.02 u (r^18 / 18!). Together less than 4 u. If k =
// 0, r is exact and the errors of sin r are below 4 u |sin r|.
#include "kernel/arithmetic/elementary.hpp"

#include <mpfr.h>

#include <cmath>

namespace crest::kernel {
namespace {

constexpr double kUnit = 0x1p-53;

/// Correctly rounded but for subnormal results.
template <class Function>
Approximation by_mpfr(Function function, double x) {
  mpfr_t y;
  mpfr_init2(y, 53);
  mpfr_set_d(y, x, MPFR_RNDN);
  function(y, y, MPFR_RNDN);
  const double value = mpfr_get_d(y, MPFR_RNDN);
  mpfr_clear(y);
  return {value, kUnit * std::fabs(value) + 0x1p-1074};
}

/// x - k P.
struct Reduced {
  double k, r;
};
Reduced reduce(double x, double inverse, double high, double low) {
  const double k = std::nearbyint(x * inverse);
  return {k, (x - k * high) - k * low};
}

constexpr double factorial(int n) {
  double f = 1;
  for (int i = 2; i <= n; ++i) f *= i;
  return f;
}

/// The sum of sign^i z^i / (first + 2 i)! up to the term (last)!.
template <int first, int last>
double alternating(double z) {
  double sum = 0;
  for (int n = last; n >= first; n -= 2)
    sum = sum * z + ((n - first) / 2 % 2 == 0 ? 1 : -1) / factorial(n);
  return sum;
}

}  // namespace

Approximation exp_near(double x) {
  if (!(std::fabs(x) <= 700)) return by_mpfr(mpfr_exp, x);
  const auto [k, r] = reduce(x, 0x1.71547652b82fep+0, 0x1.62e42feep-1, 0x1.a39ef35793c76p-33);
  double sum = 1 / factorial(13);
  for (int n = 12; n >= 0; --n) sum = sum * r + 1 / factorial(n);
  const double value = std::ldexp(sum, static_cast<int>(k));
  return {value, 4 * kUnit * value};
}

std::array<Approximation, 2> sin_cos_near(double x) {
  if (!(std::fabs(x) <= 0x1p19)) return {by_mpfr(mpfr_sin, x), by_mpfr(mpfr_cos, x)};
  const auto [k, r] = reduce(x, 0x1.45f306dc9c883p-1, 0x1.921fb544p+0, 0x1.0b4611a626331p-34);
  const double z = r * r;
  const double sine = r - r * (z * alternating<3, 17>(z));
  const double cosine = 1 - z * alternating<2, 16>(z);
  // Not zero where the product underflows: sin x is not x.
  const double of_sine = k != 0      ? 4 * kUnit
                         : sine == 0 ? 0
                                     : 4 * kUnit * std::fabs(sine) + 0x1p-1074;
  const Approximation s{sine, of_sine}, c{cosine, 4 * kUnit};
  switch (static_cast<long>(k) & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, {-sine, of_sine}};
    case 2:
      return {Approximation{-sine, of_sine}, {-cosine, c.error}};
    default:
      return {Approximation{-cosine, c.error}, s};
  }
}

Approximation log_near(double x) {
  return by_mpfr(mpfr_log, x);
}

}  // namespace crest::kernel
