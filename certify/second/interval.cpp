// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/second/interval.hpp"

#include <cmath>

namespace crest::recheck {
namespace {

double below(double x) {
  return std::nextafter(x, -INFINITY);
}
double above(double x) {
  return std::nextafter(x, INFINITY);
}

/// Of a monotone function by its values at the bounds.
template <class Function>
Interval monotone(Function f, const Interval& x) {
  return {Interval(f(Ball(x.lower()))).lower(), Interval(f(Ball(x.upper()))).upper()};
}

Interval clamped(const Interval& x) {
  return {std::max(x.lower(), -1.0), std::min(x.upper(), 1.0)};
}

}  // namespace

Interval::Interval(double lower, double upper) : lower_(lower), upper_(upper) {
  if (!std::isfinite(lower) || !std::isfinite(upper)) throw Undefined{};
}
Interval::Interval(const Ball& b) {
  arf_t bound;
  arf_init(bound);
  arb_get_lbound_arf(bound, b.get(), context.precision);
  lower_ = arf_get_d(bound, ARF_RND_FLOOR);
  arb_get_ubound_arf(bound, b.get(), context.precision);
  upper_ = arf_get_d(bound, ARF_RND_CEIL);
  arf_clear(bound);
  *this = Interval(lower_, upper_);
}

Ball Interval::ball() const {
  Ball b;
  arf_t lower, upper;
  arf_init(lower);
  arf_init(upper);
  arf_set_d(lower, lower_);
  arf_set_d(upper, upper_);
  arb_set_interval_arf(b.get(), lower, upper, context.precision);
  arf_clear(lower);
  arf_clear(upper);
  return b;
}

Interval operator+(const Interval& a, const Interval& b) {
  if (a.is_zero()) return b;
  if (b.is_zero()) return a;
  return {below(a.lower_ + b.lower_), above(a.upper_ + b.upper_)};
}

Interval operator*(const Interval& a, const Interval& b) {
  double lower = INFINITY, upper = -INFINITY;
  for (const double x : {a.lower_, a.upper_})
    for (const double y : {b.lower_, b.upper_}) {
      const double product = x * y;
      const bool exact = x == 0 || y == 0;
      lower = std::min(lower, exact ? 0 : below(product));
      upper = std::max(upper, exact ? 0 : above(product));
    }
  return {lower, upper};
}

Interval inverse(const Interval& x) {
  if (x.sign() == 0) throw Undefined{};
  return {below(1 / x.upper()), above(1 / x.lower())};
}
Interval sqrt(const Interval& x) {
  if (x.lower() < 0) throw Undefined{};
  return {x.lower() == 0 ? 0 : below(std::sqrt(x.lower())), above(std::sqrt(x.upper()))};
}
Interval log(const Interval& x) {
  return monotone([](const Ball& b) { return log(b); }, x);
}
Interval exp(const Interval& x) {
  return monotone([](const Ball& b) { return exp(b); }, x);
}
Interval sin(const Interval& x) {
  return clamped(Interval(sin(x.ball())));
}
Interval cos(const Interval& x) {
  return clamped(Interval(cos(x.ball())));
}

Interval power(const Interval& x, unsigned n) {
  const Interval a(power(Ball(x.lower()), n)), b(power(Ball(x.upper()), n));
  if (n % 2 == 1 || x.lower() >= 0) return {a.lower(), b.upper()};
  if (x.upper() <= 0) return {b.lower(), a.upper()};
  return {0, std::max(a.upper(), b.upper())};
}

}  // namespace crest::recheck
