// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Real algebraic numbers: rationals, or the one root of an integer polynomial in an open dyadic
// interval. Decisions about them are exact; they refine copies of the intervals, so a number can be
// shared by threads.
//
// Laws. (1) compare is antisymmetric and transitive, zero iff equal, whatever polynomials and
// intervals name the numbers. (2) sign_at(q r, x) = sign_at(q, x) sign_at(r, x). (3) sign_at(p, x)
// is zero for x's own polynomial p and all its multiples. (4) refined() is equal to the number.
#include <memory>
#include <optional>
#include <vector>

#include "kernel/arithmetic/stage.hpp"
#include "kernel/polynomial/integer_polynomial.hpp"

namespace crest::kernel {

class AlgebraicNumber {
 public:
  explicit AlgebraicNumber(Rational value);
  /// The root of p in the open (low, high). Requires: there is exactly one, it is simple, and low
  /// and high are no roots. p may have multiple roots elsewhere.
  AlgebraicNumber(std::shared_ptr<const IntegerPolynomial> p, Dyadic low, Dyadic high);

  /// The value if it is known to be rational (find_rational() settles it).
  const std::optional<Rational>& rational() const { return rational_; }
  /// Whether the number is rational, by the rational root theorem. Afterwards rational() tells.
  bool find_rational();

  /// A polynomial with this simple root.
  const IntegerPolynomial& polynomial() const { return *p_; }
  const std::shared_ptr<const IntegerPolynomial>& shared_polynomial() const { return p_; }
  /// Ends of an open interval that holds the number. Requires: rational() is empty.
  const Dyadic& low() const { return low_; }
  const Dyadic& high() const { return high_; }

  /// The interval becomes narrower than 2^-bits (quadratic interval refinement: the number of bits
  /// doubles a step), or the number is found to be rational.
  void refine(long bits);
  AlgebraicNumber refined(long bits) const;
  /// At least the interval's width is below 2^-width_bits().
  long width_bits() const;

  /// Doubles around the number, at most two steps apart; equal iff it is known to be a double.
  struct Bracket {
    double low, high;
  };
  Bracket bracket() const;

 private:
  void halve();
  bool guess(long parts_bits);
  void set(const Dyadic& x);
  std::shared_ptr<const IntegerPolynomial> p_;
  std::optional<Rational> rational_;
  Dyadic low_, high_;
  Sign low_sign_ = Sign::zero;
};

/// The sign of a - b.
Sign compare(const AlgebraicNumber& a, const AlgebraicNumber& b);
Sign compare(const AlgebraicNumber& a, const Rational& b);
/// The same; the numbers keep what refinement was needed.
Sign compare_refining(AlgebraicNumber& a, AlgebraicNumber& b);

/// The sign of q(x). Stages: interval (doubles over the interval), exact.
Decision sign_at(const IntegerPolynomial& q, const AlgebraicNumber& x);
/// q's sign by doubles over the present interval.
MaybeSign interval_sign_at(const IntegerPolynomial& q, const AlgebraicNumber& x);

/// The numbers' positions in increasing order, equal ones in one group in the order given. The
/// numbers are refined.
std::vector<std::vector<std::size_t>> increasing_groups(std::vector<AlgebraicNumber>& numbers);

}  // namespace crest::kernel
