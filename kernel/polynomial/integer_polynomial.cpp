// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/polynomial/integer_polynomial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crest::kernel {
namespace {

void shift_up(Integer& x, std::size_t bits) {
  mpz_mul_2exp(x.backend().data(), x.backend().data(), bits);
}
void add_product(Integer& sum, const Integer& a, const Integer& b) {
  mpz_addmul(sum.backend().data(), a.backend().data(), b.backend().data());
}

// Row n of Pascal's triangle.
std::vector<Integer> binomials(std::size_t n) {
  std::vector<Integer> row(n + 1);
  row[0] = 1;
  for (std::size_t k = 1; k <= n; ++k) row[k] = row[k - 1] * (n - k + 1) / k;
  return row;
}

}  // namespace

IntegerPolynomial::IntegerPolynomial(std::vector<Integer> c) : c_(std::move(c)) {
  while (!c_.empty() && c_.back().is_zero()) c_.pop_back();
}

void drop_twos(std::span<Integer> c) {
  mp_bitcnt_t zeros = std::numeric_limits<mp_bitcnt_t>::max();
  for (const Integer& x : c)
    if (!x.is_zero()) zeros = std::min(zeros, mpz_scan1(x.backend().data(), 0));
  if (zeros == 0 || zeros == std::numeric_limits<mp_bitcnt_t>::max()) return;
  for (Integer& x : c) mpz_tdiv_q_2exp(x.backend().data(), x.backend().data(), zeros);
}

std::optional<std::vector<Integer>> integers(std::span<const double> c) {
  int lowest = std::numeric_limits<int>::max();
  for (const double x : c) {
    if (!std::isfinite(x)) return std::nullopt;
    if (x != 0) lowest = std::min(lowest, std::ilogb(x) - 52);
  }
  std::vector<Integer> r(c.size());
  for (std::size_t i = 0; i < c.size(); ++i) {
    if (c[i] == 0) continue;
    const int e = std::ilogb(c[i]) - 52;
    r[i] = static_cast<std::int64_t>(std::scalbn(c[i], -e));
    shift_up(r[i], static_cast<std::size_t>(e - lowest));
  }
  drop_twos(r);
  return r;
}

std::optional<IntegerPolynomial> IntegerPolynomial::from(std::span<const double> c) {
  auto r = integers(c);
  if (!r) return std::nullopt;
  return IntegerPolynomial(std::move(*r));
}

IntegerPolynomial IntegerPolynomial::from(std::span<const Rational> c) {
  Integer common = 1;
  for (const Rational& x : c) common = lcm(common, Integer(denominator(x)));
  std::vector<Integer> r;
  r.reserve(c.size());
  for (const Rational& x : c)
    r.push_back(Integer(numerator(x)) * (common / Integer(denominator(x))));
  return IntegerPolynomial(std::move(r)).primitive();
}

// a_i = C(n, i) times the i-th difference of b at 0.
IntegerPolynomial IntegerPolynomial::from_bernstein(std::span<const Integer> b) {
  std::vector<Integer> a(b.begin(), b.end());
  if (a.empty()) return {};
  for (std::size_t level = 1; level < a.size(); ++level)
    for (std::size_t i = a.size() - 1; i >= level; --i) a[i] -= a[i - 1];
  const auto choose = binomials(a.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) a[i] *= choose[i];
  return IntegerPolynomial(std::move(a));
}

IntegerPolynomial IntegerPolynomial::derivative() const {
  std::vector<Integer> r;
  for (std::size_t i = 1; i < c_.size(); ++i) r.push_back(c_[i] * i);
  return IntegerPolynomial(std::move(r));
}

IntegerPolynomial IntegerPolynomial::primitive() const {
  Integer common = 0;
  for (const Integer& x : c_) {
    common = gcd(common, x);
    if (common == 1) return *this;
  }
  IntegerPolynomial r = *this;
  for (Integer& x : r.c_)
    mpz_divexact(x.backend().data(), x.backend().data(), common.backend().data());
  return r;
}

IntegerPolynomial IntegerPolynomial::scaled(long k) const {
  IntegerPolynomial r = *this;
  const std::size_t n = c_.size();
  for (std::size_t i = 0; i < n; ++i)
    shift_up(r.c_[i], static_cast<std::size_t>(k >= 0 ? k : -k) * (k >= 0 ? i : n - 1 - i));
  drop_twos(r.c_);
  return r;
}

IntegerPolynomial IntegerPolynomial::mirrored() const {
  IntegerPolynomial r = *this;
  for (std::size_t i = 1; i < c_.size(); i += 2)
    mpz_neg(r.c_[i].backend().data(), r.c_[i].backend().data());
  return r;
}

// With low = m 2^e and high - low = w 2^e: p(2^e y) scaled, then y = m + w x by Horner's shift.
IntegerPolynomial IntegerPolynomial::mapped(const Dyadic& low, const Dyadic& high) const {
  const Dyadic width = high - low;
  const long e = std::min(low.exponent, width.exponent);
  const Integer m = low.mantissa << static_cast<unsigned long>(low.exponent - e);
  const Integer w = width.mantissa << static_cast<unsigned long>(width.exponent - e);
  std::vector<Integer> r = scaled(e).c_;
  for (std::size_t level = 0; level + 1 < r.size(); ++level)
    for (std::size_t i = r.size() - 1; i-- > level;) add_product(r[i], m, r[i + 1]);
  Integer power = 1;
  for (Integer& x : r) {
    x *= power;
    power *= w;
  }
  drop_twos(r);
  return IntegerPolynomial(std::move(r));
}

Integer IntegerPolynomial::value_at(const Integer& mantissa, long exponent) const {
  Integer r = 0, term;
  const std::size_t n = c_.size(), down = static_cast<std::size_t>(-exponent);
  for (std::size_t i = n; i-- > 0;) {
    r *= mantissa;
    mpz_mul_2exp(term.backend().data(), c_[i].backend().data(), down * (n - 1 - i));
    r += term;
  }
  return r;
}

Sign IntegerPolynomial::sign_at(const Dyadic& x) const {
  if (x.exponent <= 0) return sign_of(value_at(x.mantissa, x.exponent));
  return sign_of(value_at(x.mantissa << static_cast<unsigned long>(x.exponent), 0));
}

Sign IntegerPolynomial::sign_at(const Rational& x) const {
  const Integer p = numerator(x), q = denominator(x);
  Integer r = 0, power = 1;
  for (std::size_t i = c_.size(); i-- > 0;) {
    r *= p;
    add_product(r, c_[i], power);
    power *= q;
  }
  return sign_of(r);
}

IntegerPolynomial operator+(const IntegerPolynomial& a, const IntegerPolynomial& b) {
  std::vector<Integer> r = a.c_;
  r.resize(std::max(a.c_.size(), b.c_.size()));
  for (std::size_t i = 0; i < b.c_.size(); ++i) r[i] += b.c_[i];
  return IntegerPolynomial(std::move(r));
}

IntegerPolynomial operator-(const IntegerPolynomial& a, const IntegerPolynomial& b) {
  std::vector<Integer> r = a.c_;
  r.resize(std::max(a.c_.size(), b.c_.size()));
  for (std::size_t i = 0; i < b.c_.size(); ++i) r[i] -= b.c_[i];
  return IntegerPolynomial(std::move(r));
}

IntegerPolynomial operator*(const IntegerPolynomial& a, const IntegerPolynomial& b) {
  if (a.is_zero() || b.is_zero()) return {};
  std::vector<Integer> r(a.c_.size() + b.c_.size() - 1);
  for (std::size_t i = 0; i < a.c_.size(); ++i)
    for (std::size_t k = 0; k < b.c_.size(); ++k) add_product(r[i + k], a.c_[i], b.c_[k]);
  return IntegerPolynomial(std::move(r));
}

// Coefficient k is the sum over i of C(n - i, k - i) a_i: the reversed polynomial at x + 1.
std::vector<Integer> scaled_bernstein_coefficients(const IntegerPolynomial& p) {
  std::vector<Integer> s(p.coefficients().begin(), p.coefficients().end());
  for (std::size_t last = s.size() - 1; last > 0; --last)
    for (std::size_t k = 1; k <= last; ++k) s[k] += s[k - 1];
  return s;
}

std::vector<Integer> bernstein_coefficients(const IntegerPolynomial& p) {
  std::vector<Integer> s = scaled_bernstein_coefficients(p);
  const auto choose = binomials(s.size() - 1);
  Integer common = 1;
  for (const Integer& c : choose) common = lcm(common, c);
  for (std::size_t k = 0; k < s.size(); ++k) s[k] *= common / choose[k];
  drop_twos(s);
  return s;
}

}  // namespace crest::kernel
