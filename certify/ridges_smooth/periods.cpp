// SPDX-License-Identifier: GPL-3.0-or-later
// A period of a parametrisation, by the two abstract evaluations of SPEC.md.
#include "certify/container/reject.hpp"
#include "certify/ridges_smooth/surface.hpp"

namespace crest::certify::smooth {
namespace {

using kernel::Rational;

/// Beyond this many bits a number counts as unknown: an expression can grow it without bound.
constexpr unsigned kMostBits = 4096;

bool is_small(const Rational& x) {
  return msb(abs(numerator(x)) + 1) < kMostBits && msb(denominator(x)) < kMostBits;
}

/// a + b pi with rational a and b, or unknown.
struct PiNumber {
  bool known = false;
  Rational a, b;

  static PiNumber of(Rational a, Rational b) {
    if (!is_small(a) || !is_small(b)) return {};
    return {true, std::move(a), std::move(b)};
  }
  PiNumber operator-() const { return {known, Rational(-a), Rational(-b)}; }
};
PiNumber operator+(const PiNumber& x, const PiNumber& y) {
  return x.known && y.known ? PiNumber::of(x.a + y.a, x.b + y.b) : PiNumber{};
}
PiNumber operator-(const PiNumber& x, const PiNumber& y) {
  return x + -y;
}
PiNumber operator*(const PiNumber& x, const PiNumber& y) {
  if (!x.known || !y.known) return {};
  if (y.b == 0) return PiNumber::of(x.a * y.a, x.b * y.a);
  return x.b == 0 ? y * x : PiNumber{};
}
PiNumber operator/(const PiNumber& x, const PiNumber& y) {
  if (!x.known || !y.known || y.b != 0 || y.a == 0) return {};
  return PiNumber::of(x.a / y.a, x.b / y.a);
}
PiNumber sqrt(const PiNumber&) {
  return {};
}
PiNumber exp(const PiNumber&) {
  return {};
}
PiNumber log(const PiNumber&) {
  return {};
}
PiNumber sin(const PiNumber&) {
  return {};
}
PiNumber cos(const PiNumber&) {
  return {};
}

bool is_defined(const PiNumber& x) {
  return x.known;
}

PiNumber number_of(const kernel::Constant& c) {
  if (c.kind == kernel::Constant::Kind::e) return {};
  if (c.kind == kernel::Constant::Kind::pi) return PiNumber::of(0, 1);
  return PiNumber::of(c.exact, 0);
}

/// What a value gains when the variable grows by the period 2 pi q: growth periods, or unknown.
struct Growth {
  bool known = false;
  Rational growth;
  bool constant = false;  ///< the rational number `value`, everywhere
  Rational value;
  Rational q;

  bool invariant() const { return known && growth == 0; }
  static Growth of(Rational growth, const Rational& q) {
    if (!is_small(growth)) return {};
    return {true, std::move(growth), false, 0, q};
  }
  static Growth number(Rational value, const Rational& q) {
    if (!is_small(value)) return of(0, q);
    return {true, 0, true, std::move(value), q};
  }
  Growth operator-() const { return {known, Rational(-growth), constant, Rational(-value), q}; }
};
Growth operator+(const Growth& x, const Growth& y) {
  if (!x.known || !y.known) return {};
  if (x.constant && y.constant) return Growth::number(x.value + y.value, x.q);
  return Growth::of(x.growth + y.growth, x.q);
}
Growth operator-(const Growth& x, const Growth& y) {
  return x + -y;
}
Growth operator*(const Growth& x, const Growth& y) {
  if (!x.known || !y.known) return {};
  if (x.constant && y.constant) return Growth::number(x.value * y.value, x.q);
  if (x.invariant() && y.invariant()) return Growth::of(0, x.q);
  if (y.constant) return Growth::of(x.growth * y.value, x.q);
  return x.constant ? y * x : Growth{};
}
Growth operator/(const Growth& x, const Growth& y) {
  if (!x.known || !y.known) return {};
  if (y.constant && y.value == 0) return {};
  if (x.constant && y.constant) return Growth::number(x.value / y.value, x.q);
  if (x.invariant() && y.invariant()) return Growth::of(0, x.q);
  return y.constant ? Growth::of(x.growth / y.value, x.q) : Growth{};
}
Growth of_invariant(const Growth& x) {
  return x.invariant() ? Growth::of(0, x.q) : Growth{};
}
Growth sqrt(const Growth& x) {
  return of_invariant(x);
}
Growth exp(const Growth& x) {
  return of_invariant(x);
}
Growth log(const Growth& x) {
  return of_invariant(x);
}
Growth sin(const Growth& x) {
  return x.known && denominator(Rational(x.growth * x.q)) == 1 ? Growth::of(0, x.q) : Growth{};
}
Growth cos(const Growth& x) {
  return sin(x);
}
bool is_defined(const Growth& x) {
  return x.known;
}

}  // namespace

void prove_period(const std::vector<kernel::Expression>& texts, std::size_t i) {
  const char* name = i == 0 ? "u" : "v";
  const auto bound = [&](std::size_t k) {
    return kernel::Evaluator<PiNumber>(texts[k], number_of, PiNumber::of(1, 0))({});
  };
  const PiNumber length = bound(4 + 2 * i) - bound(3 + 2 * i);
  require(length.known && length.a == 0 && length.b > 0,
          "surface: the domain's length in {} is not a rational multiple of pi", name);
  const Rational q = length.b / 2;
  const auto convert = [&](const kernel::Constant& c) {
    return c.kind == kernel::Constant::Kind::number ? Growth::number(c.exact, q) : Growth::of(0, q);
  };
  std::array<Growth, 2> variables = {Growth::of(0, q), Growth::of(0, q)};
  variables[i] = Growth::of(1, q);
  for (std::size_t k = 0; k < 3; ++k) {
    const Growth g = kernel::Evaluator<Growth>(texts[k], convert, Growth::number(1, q))(variables);
    require(g.invariant(), "surface: coordinate {} is not provably periodic in {}", k, name);
  }
}

}  // namespace crest::certify::smooth
