// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/second/interval.hpp"

namespace crest::recheck {
namespace {

const Float& least(const Float& a, const Float& b) {
  return a < b ? a : b;
}
const Float& greatest(const Float& a, const Float& b) {
  return a < b ? b : a;
}

Float lower_of(const Ball& b) {
  Float f;
  arb_get_lbound_arf(f.get(), b.get(), context.precision);
  return f;
}
Float upper_of(const Ball& b) {
  Float f;
  arb_get_ubound_arf(f.get(), b.get(), context.precision);
  return f;
}

Float sum(const Float& a, const Float& b, arf_rnd_t d) {
  return sum(a, b, context.precision, d);
}
Float difference(const Float& a, const Float& b, arf_rnd_t d) {
  return difference(a, b, context.precision, d);
}
Float product(const Float& a, const Float& b, arf_rnd_t d) {
  return product(a, b, context.precision, d);
}

Interval clamped(const Interval& x) {
  const Float one(1), minus(-1);
  return {greatest(x.lower(), minus), least(x.upper(), one)};
}

}  // namespace

Interval::Interval(const Float& lower, const Float& upper) : lower_(lower), upper_(upper) {
  if (!arf_is_finite(lower_.get()) || !arf_is_finite(upper_.get())) throw Undefined{};
}
Interval::Interval(const Ball& b) : Interval(lower_of(b), upper_of(b)) {}

Ball Interval::ball() const {
  Ball b;
  arb_set_interval_arf(b.get(), lower_.get(), upper_.get(), context.precision);
  b.finite();
  return b;
}
Float Interval::middle() const {
  Float m = sum(lower_, upper_, ARF_RND_DOWN);
  arf_mul_2exp_si(m.get(), m.get(), -1);
  return m;
}

Interval operator+(const Interval& a, const Interval& b) {
  return {sum(a.lower_, b.lower_, ARF_RND_FLOOR), sum(a.upper_, b.upper_, ARF_RND_CEIL)};
}
Interval operator-(const Interval& a, const Interval& b) {
  return {difference(a.lower_, b.upper_, ARF_RND_FLOOR),
          difference(a.upper_, b.lower_, ARF_RND_CEIL)};
}
Interval Interval::operator-() const {
  return Interval(0.0) - *this;
}

Interval operator*(const Interval& a, const Interval& b) {
  if (a.lower_.sign() >= 0 && b.lower_.sign() >= 0)
    return {product(a.lower_, b.lower_, ARF_RND_FLOOR), product(a.upper_, b.upper_, ARF_RND_CEIL)};
  const Float* bounds[4][2] = {{&a.lower_, &b.lower_},
                               {&a.lower_, &b.upper_},
                               {&a.upper_, &b.lower_},
                               {&a.upper_, &b.upper_}};
  Float lower = product(*bounds[0][0], *bounds[0][1], ARF_RND_FLOOR);
  Float upper = product(*bounds[0][0], *bounds[0][1], ARF_RND_CEIL);
  for (int i = 1; i < 4; ++i) {
    lower = least(lower, product(*bounds[i][0], *bounds[i][1], ARF_RND_FLOOR));
    upper = greatest(upper, product(*bounds[i][0], *bounds[i][1], ARF_RND_CEIL));
  }
  return {lower, upper};
}
void Interval::add_product(const Interval& a, const Interval& b) {
  *this = *this + a * b;
}

Interval hull(const Interval& a, const Interval& b) {
  return {least(a.lower(), b.lower()), greatest(a.upper(), b.upper())};
}
bool disjoint(const Interval& a, const Interval& b) {
  return a.upper() < b.lower() || b.upper() < a.lower();
}

Interval inverse(const Interval& x) {
  if (x.sign() == 0) throw Undefined{};
  return {lower_of(inverse(Ball(x.upper()))), upper_of(inverse(Ball(x.lower())))};
}
Interval sqrt(const Interval& x) {
  if (x.lower().sign() < 0) throw Undefined{};
  Float lower, upper;
  arf_sqrt(lower.get(), x.lower().get(), context.precision, ARF_RND_FLOOR);
  arf_sqrt(upper.get(), x.upper().get(), context.precision, ARF_RND_CEIL);
  return {lower, upper};
}
Interval log(const Interval& x) {
  if (x.lower().sign() <= 0) throw Undefined{};
  return {lower_of(log(Ball(x.lower()))), upper_of(log(Ball(x.upper())))};
}
Interval exp(const Interval& x) {
  return {lower_of(exp(Ball(x.lower()))), upper_of(exp(Ball(x.upper())))};
}
Interval sin(const Interval& x) {
  return clamped(Interval(sin(x.ball())));
}
Interval cos(const Interval& x) {
  return clamped(Interval(cos(x.ball())));
}

Interval power(const Interval& x, unsigned n) {
  const Ball a = power(Ball(x.lower()), n), b = power(Ball(x.upper()), n);
  if (n % 2 == 1 || x.lower().sign() >= 0) return {lower_of(a), upper_of(b)};
  if (x.upper().sign() <= 0) return {lower_of(b), upper_of(a)};
  return {Float(0), greatest(upper_of(a), upper_of(b))};
}
Interval scaled(const Interval& x, slong n, slong d) {
  const Interval r = x * Interval(Ball(static_cast<double>(n)));
  return d == 1 ? r : r * inverse(Interval(Ball(static_cast<double>(d))));
}

}  // namespace crest::recheck
