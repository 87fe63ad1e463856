// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/second/periods.hpp"

namespace crest::recheck {
namespace {

constexpr std::size_t kLongest =
    65536;  // of a numerator or denominator: beyond it nothing is shown

bool is_short(const Rational& r) {
  return fmpz_bits(fmpq_numref(r.get())) + fmpz_bits(fmpq_denref(r.get())) < kLongest;
}

/// What is known of a part: its value a + b pi if it is such a constant, its growth if it has one.
struct Part {
  std::optional<Linear> value;
  std::optional<Rational> growth;
  bool rational() const { return value && value->b.is_zero(); }
  bool invariant() const { return growth && growth->is_zero(); }
};

std::optional<Rational> power(const Rational& base, int n) {
  if (n < 0 && base.is_zero()) return std::nullopt;
  const auto size = static_cast<std::size_t>(n < 0 ? -n : n);
  if ((fmpz_bits(fmpq_numref(base.get())) + fmpz_bits(fmpq_denref(base.get()))) * size > kLongest)
    return std::nullopt;
  Rational r;
  fmpq_pow_si(r.get(), base.get(), n);
  return r;
}

Part sum(const Part& a, const Part& b, slong sign) {
  Part r;
  const Rational s(sign);
  if (a.value && b.value)
    r.value = Linear{a.value->a + s * b.value->a, a.value->b + s * b.value->b};
  if (a.growth && b.growth) r.growth = *a.growth + s * *b.growth;
  return r;
}

Part multiple(const Part& a, const Rational& factor) {
  Part r;
  if (a.value) r.value = Linear{factor * a.value->a, factor * a.value->b};
  if (a.growth) r.growth = factor * *a.growth;
  return r;
}

Part invariant_if(bool invariant) {
  Part r;
  if (invariant) r.growth = Rational(0);
  return r;
}

Part product(const Part& a, const Part& b) {
  if (b.rational()) return multiple(a, b.value->a);
  if (a.rational()) return multiple(b, a.value->a);
  return invariant_if(a.invariant() && b.invariant());
}

Part quotient(const Part& a, const Part& b) {
  if (b.rational() && !b.value->a.is_zero()) return multiple(a, Rational(1) / b.value->a);
  return invariant_if(a.invariant() && b.invariant());
}

Part power_of(const Part& a, int n) {
  Part r = invariant_if(a.invariant());
  if (a.rational())
    if (const auto p = power(a.value->a, n)) r.value = Linear{*p, Rational(0)};
  return r;
}

Part limited(Part p) {
  if (p.value && !(is_short(p.value->a) && is_short(p.value->b))) p.value.reset();
  if (p.growth && !is_short(*p.growth)) p.growth.reset();
  return p;
}

Part analysed(const Expression& e, int variable, const Rational& q) {
  using Code = Step::Code;
  std::vector<Part> stack;
  for (const Step& s : e.steps()) {
    Part b, r;
    const bool binary = s.code == Code::add || s.code == Code::subtract ||
                        s.code == Code::multiply || s.code == Code::divide;
    const bool leaf = s.code == Code::number || s.code == Code::pi || s.code == Code::e ||
                      s.code == Code::variable;
    if (binary) {
      b = stack.back();
      stack.pop_back();
    }
    const Part a = leaf ? Part() : stack.back();
    if (!leaf) stack.pop_back();
    switch (s.code) {
      case Code::number:
        r = {Linear{e.number(s), Rational(0)}, Rational(0)};
        break;
      case Code::pi:
        r = {Linear{Rational(0), Rational(1)}, Rational(0)};
        break;
      case Code::e:
        r.growth = Rational(0);
        break;
      case Code::variable:
        r.growth = Rational(s.argument == variable ? 1 : 0);
        break;
      case Code::add:
        r = sum(a, b, 1);
        break;
      case Code::subtract:
        r = sum(a, b, -1);
        break;
      case Code::multiply:
        r = product(a, b);
        break;
      case Code::divide:
        r = quotient(a, b);
        break;
      case Code::negate:
        r = multiple(a, Rational(-1));
        break;
      case Code::power:
        r = power_of(a, s.argument);
        break;
      case Code::apply: {
        const bool circular =
            s.function.kind == Function::Kind::sin || s.function.kind == Function::Kind::cos;
        r = invariant_if(a.invariant() || (circular && a.growth && (*a.growth * q).is_integer()));
        break;
      }
    }
    stack.push_back(limited(r));
  }
  return stack.back();
}

}  // namespace

std::optional<Linear> linear_in_pi(const Expression& e) {
  return analysed(e, -1, Rational(0)).value;
}
bool is_invariant(const Expression& e, int variable, const Rational& q) {
  return analysed(e, variable, q).invariant();
}

}  // namespace crest::recheck
