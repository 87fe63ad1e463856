// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Univariate polynomials with integer coefficients: what root isolation and algebraic numbers
// compute with. Real polynomials come in by a positive factor, so that no sign changes.
#include <optional>
#include <span>
#include <vector>

#include "kernel/polynomial/dyadic.hpp"

namespace crest::kernel {

class IntegerPolynomial {
 public:
  /// Zero.
  IntegerPolynomial() = default;
  /// c[0] + c[1] x + ...; zero leading coefficients are dropped.
  explicit IntegerPolynomial(std::vector<Integer> c);

  /// c[0] + c[1] x + ... times a positive number; nothing unless all are finite. Memory:
  /// coefficients have at most 2 098 bits.
  static std::optional<IntegerPolynomial> from(std::span<const double> c);
  static IntegerPolynomial from(std::span<const Rational> c);
  /// From Bernstein coefficients on [0, 1], times a positive number.
  static IntegerPolynomial from_bernstein(std::span<const Integer> b);

  /// -1 for zero.
  int degree() const { return static_cast<int>(c_.size()) - 1; }
  bool is_zero() const { return c_.empty(); }
  const Integer& operator[](std::size_t i) const { return c_[i]; }
  const Integer& leading() const { return c_.back(); }
  std::span<const Integer> coefficients() const { return c_; }

  IntegerPolynomial derivative() const;
  /// Without the positive common divisor of the coefficients.
  IntegerPolynomial primitive() const;
  /// p(2^k x) times a power of two.
  IntegerPolynomial scaled(long k) const;
  /// p(-x).
  IntegerPolynomial mirrored() const;
  /// p(low + (high - low) x) times a power of two.
  IntegerPolynomial mapped(const Dyadic& low, const Dyadic& high) const;

  /// 2^(-exponent degree) p(mantissa 2^exponent). Requires: exponent <= 0.
  Integer value_at(const Integer& mantissa, long exponent) const;
  Sign sign_at(const Dyadic& x) const;
  Sign sign_at(const Rational& x) const;

  friend IntegerPolynomial operator+(const IntegerPolynomial& a, const IntegerPolynomial& b);
  friend IntegerPolynomial operator-(const IntegerPolynomial& a, const IntegerPolynomial& b);
  friend IntegerPolynomial operator*(const IntegerPolynomial& a, const IntegerPolynomial& b);
  friend bool operator==(const IntegerPolynomial& a, const IntegerPolynomial& b) {
    return a.c_ == b.c_;
  }

 private:
  std::vector<Integer> c_;
};

/// The doubles times one power of two; nothing unless all are finite.
std::optional<std::vector<Integer>> integers(std::span<const double> c);
/// Divides by the largest common power of two.
void drop_twos(std::span<Integer> c);

/// Bernstein coefficients on [0, 1] of a polynomial of degree >= 0, times a positive number.
std::vector<Integer> bernstein_coefficients(const IntegerPolynomial& p);
/// The same times binomials: coefficient k of x^k (1 - x)^(n - k). Cheaper, and the same signs.
std::vector<Integer> scaled_bernstein_coefficients(const IntegerPolynomial& p);

}  // namespace crest::kernel
