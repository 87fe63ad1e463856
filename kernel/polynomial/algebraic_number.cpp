// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/polynomial/algebraic_number.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "kernel/arithmetic/interval.hpp"
#include "kernel/polynomial/common_divisor.hpp"

namespace crest::kernel {
namespace {

IntegerPolynomial linear(const Rational& x) {
  return IntegerPolynomial({-Integer(numerator(x)), Integer(denominator(x))});
}

// Bits every refinement of a decision starts from: what doubles can tell is told before.
constexpr long kFirstBits = 48;

/// The coefficients times one power of two, the largest near 1, enclosed in doubles.
std::vector<Interval> enclosures(const IntegerPolynomial& q) {
  long largest = 0;
  for (const Integer& x : q.coefficients()) largest = std::max(largest, bit_length(x));
  std::vector<Interval> r;
  for (const Integer& x : q.coefficients()) {
    const Dyadic d{x, -largest};
    r.emplace_back(d.lower(), d.upper());
  }
  return r;
}

Interval range_of(const AlgebraicNumber& x) {
  if (!x.rational()) return {x.low().lower(), x.high().upper()};
  // The conversion truncates towards zero.
  const double near = x.rational()->convert_to<double>();
  if (!std::isfinite(near)) return Interval::undefined();
  if (Rational(near) == *x.rational()) return near;
  const double infinity = std::numeric_limits<double>::infinity();
  return {std::nextafter(near, -infinity), std::nextafter(near, infinity)};
}

/// The sign of q on the open interval if its Bernstein coefficients there have one sign.
MaybeSign hull_sign(const IntegerPolynomial& q, const Dyadic& low, const Dyadic& high) {
  Sign sign = Sign::zero;
  for (const Integer& c : scaled_bernstein_coefficients(q.mapped(low, high))) {
    const Sign s = sign_of(c);
    if (s == Sign::zero) continue;
    if (sign != Sign::zero && s != sign) return std::nullopt;
    sign = s;
  }
  return sign;
}

/// Whether q, of which x's polynomial has no root but x in its interval, is zero at x.
bool is_root(const IntegerPolynomial& q, const AlgebraicNumber& x) {
  const IntegerPolynomial g = common_divisor(q, x.polynomial());
  // g divides x's polynomial: no root at the ends, at most a simple one between them.
  return g.degree() > 0 && g.sign_at(x.low()) != g.sign_at(x.high());
}

Sign exact_sign_at(const IntegerPolynomial& q, AlgebraicNumber x) {
  if (is_root(q, x)) return Sign::zero;
  for (long bits = std::max(2 * x.width_bits(), kFirstBits);; bits *= 2) {
    if (x.rational()) return q.sign_at(*x.rational());
    if (const MaybeSign s = hull_sign(q, x.low(), x.high())) return *s;
    x.refine(bits);
  }
}

}  // namespace

AlgebraicNumber::AlgebraicNumber(Rational value)
    : p_(std::make_shared<IntegerPolynomial>(linear(value))), rational_(std::move(value)) {}

AlgebraicNumber::AlgebraicNumber(std::shared_ptr<const IntegerPolynomial> p, Dyadic low,
                                 Dyadic high)
    : p_(std::move(p)), low_(std::move(low)), high_(std::move(high)) {
  low_sign_ = p_->sign_at(low_);
  if (p_->degree() == 1) rational_ = Rational(-(*p_)[0], (*p_)[1]);
}

void AlgebraicNumber::set(const Dyadic& x) {
  rational_ = x.value();
}

void AlgebraicNumber::halve() {
  Dyadic m = middle(low_, high_);
  const Sign s = p_->sign_at(m);
  if (s == Sign::zero) return set(m);
  (s == low_sign_ ? low_ : high_) = std::move(m);
}

// One of the 2^k equal parts, chosen by the secant, or one of its neighbours.
bool AlgebraicNumber::guess(long parts_bits) {
  const long e = std::min({low_.exponent, high_.exponent, 0L});
  const auto mantissa = [&](const Dyadic& x) -> Integer {
    return x.mantissa << static_cast<unsigned long>(x.exponent - e);
  };
  const Integer a = mantissa(low_), width = mantissa(high_) - a;
  const Integer fa = p_->value_at(a, e), fb = p_->value_at(a + width, e);
  // round(2^k fa / (fa - fb))
  const Integer drop = abs(fa) + abs(fb);
  const Integer part =
      ((abs(fa) << static_cast<unsigned long>(parts_bits + 1)) + drop) / (2 * drop);
  const long fine = e - parts_bits;
  const Integer first = a << static_cast<unsigned long>(parts_bits);
  const auto at = [&](const Integer& k) { return Dyadic{first + k * width, fine}; };
  Dyadic x = at(part);
  const Sign s = p_->sign_at(x);
  if (s == Sign::zero) return set(x), true;
  const bool right = s == low_sign_;
  const Integer neighbour = right ? Integer(part + 1) : Integer(part - 1);
  if (neighbour < 0 || neighbour > (Integer(1) << static_cast<unsigned long>(parts_bits)))
    return false;
  Dyadic y = at(neighbour);
  const Sign t = p_->sign_at(y);
  if (t == Sign::zero) return set(y), true;
  if (t == s) return false;
  if (!right) std::swap(x, y);
  low_ = std::move(x);
  high_ = std::move(y);
  return true;
}

long AlgebraicNumber::width_bits() const {
  if (rational_) return std::numeric_limits<long>::max() / 4;
  const Dyadic width = high_ - low_;
  return -(width.exponent + bit_length(width.mantissa));
}

void AlgebraicNumber::refine(long bits) {
  long parts_bits = 2;
  while (!rational_ && width_bits() < bits) {
    if (guess(parts_bits)) {
      parts_bits *= 2;
      continue;
    }
    parts_bits = std::max(1L, parts_bits / 2);
    halve();
  }
}

AlgebraicNumber AlgebraicNumber::refined(long bits) const {
  AlgebraicNumber r = *this;
  r.refine(bits);
  return r;
}

// A root n / d of p in lowest terms has d dividing the leading coefficient a, so a x is an integer.
bool AlgebraicNumber::find_rational() {
  if (rational_) return true;
  const Integer a = p_->leading();
  refine(bit_length(a) + 1);
  if (rational_) return true;
  // |a| (high - low) < 1/2: at most one candidate, the integer next to a times the middle.
  const Rational scaled = Rational(a) * middle(low_, high_).value() + Rational(1, 2);
  Integer candidate;
  mpz_fdiv_q(candidate.backend().data(), mpq_numref(scaled.backend().data()),
             mpq_denref(scaled.backend().data()));
  const Rational x(candidate, a);
  if (compare(low_, x) != Sign::negative || compare(high_, x) != Sign::positive) return false;
  if (p_->sign_at(x) != Sign::zero) return false;
  rational_ = x;
  return true;
}

AlgebraicNumber::Bracket AlgebraicNumber::bracket() const {
  const double infinity = std::numeric_limits<double>::infinity();
  AlgebraicNumber x = *this;
  for (long bits = std::max(2 * x.width_bits(), kFirstBits); !x.rational(); bits *= 2) {
    const Bracket b{x.low().lower(), x.high().upper()};
    if (b.high <= std::nextafter(std::nextafter(b.low, infinity), infinity)) return b;
    x.refine(bits);
  }
  const Interval r = range_of(x);
  return {r.inf(), r.sup()};
}

Sign compare(const AlgebraicNumber& a, const Rational& b) {
  if (a.rational()) return sign_of(*a.rational() - b);
  if (compare(a.low(), b) != Sign::negative) return Sign::positive;
  if (compare(a.high(), b) != Sign::positive) return Sign::negative;
  // The only root in the interval is a: the sign changes there.
  const Sign s = a.polynomial().sign_at(b);
  if (s == Sign::zero) return Sign::zero;
  return s == a.polynomial().sign_at(a.low()) ? Sign::positive : Sign::negative;
}

Sign compare_refining(AlgebraicNumber& a, AlgebraicNumber& b) {
  bool different = false;
  for (long bits = kFirstBits / 2;; bits *= 2) {
    if (b.rational()) return compare(a, *b.rational());
    if (a.rational()) return -compare(b, *a.rational());
    if (compare(a.high(), b.low()) != Sign::positive) return Sign::negative;
    if (compare(b.high(), a.low()) != Sign::positive) return Sign::positive;
    if (bits > kFirstBits && !different) {
      // A common root between the larger low end and the smaller high end is a and b. The common
      // divisor has no root at the ends of either interval.
      const Dyadic& low = compare(a.low(), b.low()) == Sign::negative ? b.low() : a.low();
      const Dyadic& high = compare(a.high(), b.high()) == Sign::negative ? a.high() : b.high();
      const IntegerPolynomial g = a.shared_polynomial() == b.shared_polynomial()
                                      ? a.polynomial()
                                      : common_divisor(a.polynomial(), b.polynomial());
      if (g.degree() > 0 && g.sign_at(low) != g.sign_at(high)) return Sign::zero;
      different = true;
    }
    a.refine(bits);
    b.refine(bits);
  }
}

Sign compare(const AlgebraicNumber& a, const AlgebraicNumber& b) {
  AlgebraicNumber x = a, y = b;
  return compare_refining(x, y);
}

MaybeSign interval_sign_at(const IntegerPolynomial& q, const AlgebraicNumber& x) {
  if (q.is_zero()) return Sign::zero;
  const std::vector<Interval> c = enclosures(q);
  const Interval at = range_of(x);
  RoundUpward guard;
  Interval sum = c.back();
  for (std::size_t i = c.size() - 1; i-- > 0;) sum = sum * at + c[i];
  return certain_sign(sum);
}

Decision sign_at(const IntegerPolynomial& q, const AlgebraicNumber& x) {
  if (q.degree() < 1) return {q.is_zero() ? Sign::zero : sign_of(q.leading()), Stage::interval};
  if (const MaybeSign s = interval_sign_at(q, x)) return {*s, Stage::interval};
  if (x.rational()) return {q.sign_at(*x.rational()), Stage::exact};
  const AlgebraicNumber fine = x.refined(kFirstBits);
  if (const MaybeSign s = interval_sign_at(q, fine)) return {*s, Stage::interval};
  if (fine.rational()) return {q.sign_at(*fine.rational()), Stage::exact};
  return {exact_sign_at(q, fine), Stage::exact};
}

std::vector<std::vector<std::size_t>> increasing_groups(std::vector<AlgebraicNumber>& numbers) {
  std::vector<std::size_t> order(numbers.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto less = [&](std::size_t i, std::size_t k) {
    return i != k && compare_refining(numbers[i], numbers[k]) == Sign::negative;
  };
  std::stable_sort(order.begin(), order.end(), less);
  std::vector<std::vector<std::size_t>> groups;
  for (const std::size_t i : order)
    if (groups.empty() || less(groups.back().front(), i))
      groups.push_back({i});
    else
      groups.back().push_back(i);
  return groups;
}

}  // namespace crest::kernel
