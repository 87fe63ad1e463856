// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Named families of integer polynomials on which root isolation goes wrong.
#include <vector>

#include "kernel/polynomial/integer_polynomial.hpp"
#include "tests/support/degenerate_families.hpp"

namespace crest::tests {

using kernel::Integer, kernel::IntegerPolynomial, kernel::Rational;

inline IntegerPolynomial polynomial(std::vector<Rational> c) {
  return IntegerPolynomial::from(c);
}
/// The product of (x - r)^m.
struct Rooted {
  Rational r;
  int m;
};
inline IntegerPolynomial with_roots(const std::vector<Rooted>& roots) {
  IntegerPolynomial p = polynomial({1});
  for (const Rooted& x : roots)
    for (int i = 0; i < x.m; ++i) p = p * polynomial({-x.r, 1});
  return p;
}
inline IntegerPolynomial wilkinson(int n) {
  std::vector<Rooted> roots;
  for (int k = 1; k <= n; ++k) roots.push_back({k, 1});
  return with_roots(roots);
}
/// x^n - 2 (a x - 1)^2: two roots closer than a^(-n/2).
inline IntegerPolynomial mignotte(int n, const Integer& a) {
  std::vector<Integer> c(static_cast<std::size_t>(n) + 1);
  c[0] = -2;
  c[1] = 4 * a;
  c[2] = -2 * a * a;
  c[static_cast<std::size_t>(n)] += 1;
  return IntegerPolynomial(std::move(c));
}
inline IntegerPolynomial chebyshev(int n) {
  IntegerPolynomial a = polynomial({1}), b = polynomial({0, 1});
  for (int k = 1; k < n; ++k) {
    IntegerPolynomial c = polynomial({0, 2}) * b - a;
    a = b;
    b = std::move(c);
  }
  return b;
}
inline IntegerPolynomial draw_polynomial(Draw& d, Family family, int degree) {
  std::vector<double> c;
  for (int i = 0; i <= degree; ++i) c.push_back(draw(d, family));
  return *IntegerPolynomial::from(c);
}
inline IntegerPolynomial draw_small(Draw& d, int degree, int size = 5) {
  std::vector<Integer> c;
  for (int i = 0; i <= degree; ++i) c.emplace_back(d.integer(-size, size));
  return IntegerPolynomial(std::move(c));
}
/// Products of small factors and their powers: multiple and common roots everywhere.
inline IntegerPolynomial draw_product(Draw& d) {
  IntegerPolynomial p = polynomial({d.coin() ? 1 : -3});
  for (int k = d.integer(1, 3); k > 0; --k) {
    const IntegerPolynomial f = draw_small(d, d.integer(1, 3), 2);
    if (f.is_zero()) continue;
    for (int m = d.integer(1, 3); m > 0; --m) p = p * f;
  }
  return p;
}

}  // namespace crest::tests
