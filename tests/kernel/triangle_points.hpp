// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Rational points of the Taylor models' triangle, and what encloses a value there.
#include <mpfr.h>

#include <cmath>

#include "kernel/arithmetic/interval.hpp"
#include "kernel/arithmetic/mp_taylor_model.hpp"
#include "kernel/arithmetic/taylor_model.hpp"
#include "tests/support/degenerate_families.hpp"
#include "tests/support/failures.hpp"

namespace crest::tests {

using kernel::Rational;

struct TrianglePoint {
  Rational u, v;
  /// The linear function with these values at the corners.
  Rational linear(double at0, double at1, double at2) const {
    const Rational l1 = (2 * u + 1) / 3, l2 = (2 * v + 1) / 3;
    return (1 - l1 - l2) * Rational(at0) + l1 * Rational(at1) + l2 * Rational(at2);
  }
  Rational monomial(int i, int j) const {
    Rational r = 1;
    for (; i > 0; --i) r *= u;
    for (; j > 0; --j) r *= v;
    return r;
  }
};

inline TrianglePoint point_of_weights(int l0, int l1, int l2) {
  const Rational sum = l0 + l1 + l2;
  return {Rational(2 * l1 - l0 - l2) / (2 * sum), Rational(2 * l2 - l0 - l1) / (2 * sum)};
}

/// Corners, edges and the inside of the triangle.
inline TrianglePoint draw_triangle_point(Draw& d) {
  int l[3] = {d.integer(0, 40), d.integer(0, 40), d.integer(0, 40)};
  if (d.integer(0, 3) == 0) l[d.integer(0, 2)] = 0;
  if (l[0] + l[1] + l[2] == 0) l[0] = 1;
  return point_of_weights(l[0], l[1], l[2]);
}

/// Inside the edge from corner i to the next, or at its ends.
inline TrianglePoint draw_edge_point(Draw& d, int i) {
  int l[3] = {0, 0, 0};
  l[i] = d.integer(0, 40);
  l[(i + 1) % 3] = 40 - l[i];
  return point_of_weights(l[0], l[1], l[2]);
}

inline double between(Draw& d, double low, double high) {
  return low + (high - low) * (d.uniform() + 1) / 2;
}

template <int N>
Rational polynomial(const kernel::TaylorModel<N>& m, const TrianglePoint& at) {
  Rational sum = 0;
  for (std::size_t k = 0; k < m.c.size(); ++k)
    sum += Rational(m.c[k]) * at.monomial(m.kTable.exponents[k][0], m.kTable.exponents[k][1]);
  return sum;
}

// Is `value` one of the enclosed values at the point? Unbounded enclosures hold all.
template <int N>
bool encloses(const kernel::TaylorModel<N>& m, const TrianglePoint& at, const Rational& value) {
  if (!is_defined(m)) return true;
  const Rational off = value - polynomial(m, at);
  return (off < 0 ? Rational(-off) : off) <= m.radius;
}
template <int N>
bool encloses(const kernel::MpTaylorModel<N>& m, const TrianglePoint& at, const Rational& value) {
  kernel::MpInterval sum = m.remainder;
  for (std::size_t k = 0; k < m.c.size(); ++k) {
    const Rational x = at.monomial(m.kTable.exponents[k][0], m.kTable.exponents[k][1]);
    sum = sum + m.c[k] * kernel::MpInterval::from(x, 200);
  }
  return sum.contains(value);
}
inline bool encloses(const kernel::Range& r, const Rational& value) {
  return (std::isinf(r.low) || value >= r.low) && (std::isinf(r.high) || value <= r.high);
}
inline bool encloses(const kernel::Interval& x, const TrianglePoint&, const Rational& value) {
  return encloses(kernel::Range{x.inf(), x.sup()}, value);
}
inline bool encloses(const kernel::MpInterval& x, const TrianglePoint&, const Rational& value) {
  return x.contains(value);
}

using MpfrFunction = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);

/// f(x) to 300 bits, as a rational.
inline Rational precise(MpfrFunction f, const Rational& x) {
  mpfr_t y;
  mpfr_init2(y, 300);
  mpfr_set_q(y, x.backend().data(), MPFR_RNDN);
  f(y, y, MPFR_RNDN);
  Rational result;
  mpfr_get_q(result.backend().data(), y);
  mpfr_clear(y);
  return result;
}

}  // namespace crest::tests
