// SPDX-License-Identifier: GPL-3.0-or-later
// Proofs of periodicity by two abstract number types run through the expressions.
#include <optional>

#include "algorithms/smooth_ridges/surface.hpp"

namespace crest::smooth_ridges {
namespace {

using kernel::Constant;
using kernel::Expression;
using kernel::Rational;

/// Beyond this a power is no longer followed: rationals must not grow without bound.
bool is_short(const Rational& x) {
  constexpr unsigned kBits = 4096;
  const auto size = [](const boost::multiprecision::mpz_int& n) {
    return n == 0 ? 0 : msb(abs(n));
  };
  return size(numerator(x)) < kBits && size(denominator(x)) < kBits;
}

/// a + b pi, or unknown.
struct PiNumber {
  struct Value {
    Rational a, b;
  };
  std::optional<Value> known;

  static PiNumber of(const Rational& a, const Rational& b) {
    if (!is_short(a) || !is_short(b)) return {};
    return {Value{a, b}};
  }
  bool is_rational() const { return known && known->b == 0; }
  PiNumber operator-() const { return known ? of(-known->a, -known->b) : PiNumber{}; }
  friend PiNumber operator+(const PiNumber& x, const PiNumber& y) {
    if (!x.known || !y.known) return {};
    return of(x.known->a + y.known->a, x.known->b + y.known->b);
  }
  friend PiNumber operator-(const PiNumber& x, const PiNumber& y) { return x + -y; }
  friend PiNumber operator*(const PiNumber& x, const PiNumber& y) {
    if (!x.known || !y.known) return {};
    if (!x.is_rational()) return y.is_rational() ? y * x : PiNumber{};
    return of(x.known->a * y.known->a, x.known->a * y.known->b);
  }
  friend PiNumber operator/(const PiNumber& x, const PiNumber& y) {
    if (!x.known || !y.is_rational() || y.known->a == 0) return {};
    return of(x.known->a / y.known->a, x.known->b / y.known->a);
  }
  friend PiNumber sqrt(const PiNumber&) { return {}; }
  friend PiNumber exp(const PiNumber&) { return {}; }
  friend PiNumber log(const PiNumber&) { return {}; }
  friend PiNumber sin(const PiNumber&) { return {}; }
  friend PiNumber cos(const PiNumber&) { return {}; }
  friend bool is_defined(const PiNumber& x) { return x.known.has_value(); }
};

/// How a function f of the variable changes over the period p = 2 pi q: f + k p, or in a way not
/// known. A rational constant is remembered.
struct Growth {
  std::optional<Rational> k;      ///< 0: invariant
  std::optional<Rational> value;  ///< of a rational constant
  static inline thread_local Rational q;

  static Growth invariant() { return {Rational(0), {}}; }
  static Growth constant(const Rational& x) {
    if (!is_short(x)) return invariant();
    return {Rational(0), x};
  }
  static Growth by(const Rational& k) {
    if (!is_short(k)) return {};
    return {k, {}};
  }
  bool is_invariant() const { return k && *k == 0; }

  Growth operator-() const { return constant(-1) * *this; }
  friend Growth operator+(const Growth& f, const Growth& g) {
    if (f.value && g.value) return constant(*f.value + *g.value);
    return f.k && g.k ? by(*f.k + *g.k) : Growth{};
  }
  friend Growth operator-(const Growth& f, const Growth& g) { return f + -g; }
  friend Growth operator*(const Growth& f, const Growth& g) {
    if (f.value && g.value) return constant(*f.value * *g.value);
    if (f.value && g.k) return by(*f.value * *g.k);
    if (g.value && f.k) return by(*g.value * *f.k);
    return f.is_invariant() && g.is_invariant() ? invariant() : Growth{};
  }
  friend Growth operator/(const Growth& f, const Growth& g) {
    if (g.value && *g.value == 0) return {};
    if (g.value) return f * constant(1 / *g.value);
    return f.is_invariant() && g.is_invariant() ? invariant() : Growth{};
  }
  Growth function() const { return is_invariant() ? invariant() : Growth{}; }
  Growth circular() const {
    return k && denominator(Rational(*k * q)) == 1 ? invariant() : Growth{};
  }
  friend Growth sqrt(const Growth& f) { return f.function(); }
  friend Growth exp(const Growth& f) { return f.function(); }
  friend Growth log(const Growth& f) { return f.function(); }
  friend Growth sin(const Growth& f) { return f.circular(); }
  friend Growth cos(const Growth& f) { return f.circular(); }
  friend bool is_defined(const Growth& f) { return f.k.has_value(); }
};

PiNumber pi_number(const Expression& e) {
  const auto convert = [](const Constant& c) {
    if (c.kind == Constant::Kind::pi) return PiNumber::of(0, 1);
    return c.kind == Constant::Kind::number ? PiNumber::of(c.exact, 0) : PiNumber{};
  };
  return kernel::Evaluator<PiNumber>(e, convert, PiNumber::of(1, 0))({});
}

}  // namespace

bool provably_periodic(const std::vector<Expression>& coordinates, const Expression& lower,
                       const Expression& upper, std::size_t direction) {
  const PiNumber length = pi_number(upper) - pi_number(lower);
  if (!length.known || length.known->a != 0 || length.known->b <= 0) return false;
  Growth::q = length.known->b / 2;
  const auto convert = [](const Constant& c) {
    return c.kind == Constant::Kind::number ? Growth::constant(c.exact) : Growth::invariant();
  };
  std::array<Growth, 2> variables = {Growth::invariant(), Growth::invariant()};
  variables[direction] = Growth::by(1);
  for (const Expression& e : coordinates) {
    kernel::Evaluator<Growth> run(e, convert, Growth::constant(1));
    if (!run(variables).is_invariant()) return false;
  }
  return true;
}

}  // namespace crest::smooth_ridges
