// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/polynomial/real_roots.hpp"

#include <algorithm>
#include <cmath>

#include "kernel/arithmetic/approximate.hpp"
#include "kernel/polynomial/common_divisor.hpp"
#include "kernel/polynomial/descartes.hpp"

namespace crest::kernel {
namespace {

using Shared = std::shared_ptr<const IntegerPolynomial>;

/// Places on the open unit interval are images of places on the line: x = sign 2^scale t.
struct Side {
  bool negative;
  long scale;
  IntegerPolynomial on_unit(const IntegerPolynomial& p) const {
    return (negative ? p.mirrored() : p).scaled(scale);
  }
  Dyadic image(const Dyadic& t) const {
    return {negative ? -t.mantissa : t.mantissa, t.exponent + scale};
  }
  AlgebraicNumber number(const Shared& p, const Dyadic& low, const Dyadic& high) const {
    return negative ? AlgebraicNumber(p, image(high), image(low))
                    : AlgebraicNumber(p, image(low), image(high));
  }
};

/// Doubles near integers times one power of two: the error of truncation is below 2 u times the
/// largest, and what underflows is below 2^-1074.
std::optional<std::vector<UnitRange>> triage_places(const std::vector<Integer>& b) {
  long top = 0;
  for (const Integer& x : b) top = std::max(top, bit_length(x));
  std::vector<double> c;
  for (const Integer& x : b) {
    long e = 0;
    const double fraction = mpz_get_d_2exp(&e, x.backend().data());
    c.push_back(e - top < -1000 ? 0 : std::ldexp(fraction, static_cast<int>(e - top)));
  }
  // Magnitudes are below 1; a number below 2^-1000 was dropped.
  return triage_unit_places(c, 2.1 * kUnitRoundoff);
}

/// Appends the roots on one side if triage finds them.
bool triage_roots(const Shared& p, const Side& side, std::vector<RealRoot>& roots) {
  const auto places = triage_places(bernstein_coefficients(side.on_unit(*p)));
  if (!places) return false;
  for (const UnitRange& x : *places)
    roots.push_back({side.number(p, dyadic(x.low), dyadic(x.high)), 1});
  return true;
}

void exact_roots(const Shared& p, int multiplicity, const Side& side,
                 std::vector<RealRoot>& roots) {
  for (const UnitPlace& place : exact_unit_places(bernstein_coefficients(side.on_unit(*p)))) {
    const Dyadic low = place.low();
    roots.push_back(
        {place.point ? AlgebraicNumber(side.image(low).value()) : side.number(p, low, place.high()),
         multiplicity});
  }
}

void sort(std::vector<RealRoot>& roots) {
  std::vector<AlgebraicNumber> numbers;
  numbers.reserve(roots.size());
  for (const RealRoot& r : roots) numbers.push_back(r.value);
  std::vector<RealRoot> sorted;
  for (const auto& group : increasing_groups(numbers))
    sorted.push_back({std::move(numbers[group[0]]), roots[group[0]].multiplicity});
  roots = std::move(sorted);
}

}  // namespace

long root_bound(const IntegerPolynomial& p) {
  const long top = bit_length(p.leading());
  const int n = p.degree();
  long bound = 0;
  bool any = false;
  for (int i = 1; i <= n; ++i) {
    const Integer& c = p[static_cast<std::size_t>(n - i)];
    if (c.is_zero()) continue;
    // |c / leading| < 2^excess
    const long excess = bit_length(c) - top + 1;
    const long root = excess >= 0 ? (excess + i - 1) / i : -((-excess) / i);
    bound = any ? std::max(bound, root) : root;
    any = true;
  }
  return bound + 1;
}

RealRoots unit_roots(const IntegerPolynomial& p) {
  RealRoots r;
  r.everywhere = p.is_zero();
  if (p.degree() < 1) return r;
  const Side side{false, 0};
  const auto whole = std::make_shared<const IntegerPolynomial>(p.primitive());
  if (triage_roots(whole, side, r.roots)) {
    r.stage = Stage::triage;
    return r;
  }
  r.roots.clear();
  for (SquareFreeFactor& f : square_free_factors(p))
    exact_roots(std::make_shared<const IntegerPolynomial>(std::move(f.p)), f.multiplicity, side,
                r.roots);
  sort(r.roots);
  return r;
}

std::optional<RealRoots> unit_roots(std::span<const double> bernstein) {
  const auto b = integers(bernstein);
  if (!b) return std::nullopt;
  const auto places = triage_unit_places(bernstein, 0);
  if (!places) return unit_roots(IntegerPolynomial::from_bernstein(*b));
  RealRoots r;
  r.stage = Stage::triage;
  if (places->empty()) return r;
  const auto p =
      std::make_shared<const IntegerPolynomial>(IntegerPolynomial::from_bernstein(*b).primitive());
  for (const UnitRange& x : *places)
    r.roots.push_back({AlgebraicNumber(p, dyadic(x.low), dyadic(x.high)), 1});
  return r;
}

RealRoots real_roots(const IntegerPolynomial& p) {
  RealRoots r;
  r.everywhere = p.is_zero();
  if (p.degree() < 1) return r;
  int at_zero = 0;
  while (p[static_cast<std::size_t>(at_zero)].is_zero()) ++at_zero;
  const auto rest = std::make_shared<const IntegerPolynomial>(
      IntegerPolynomial({p.coefficients().begin() + at_zero, p.coefficients().end()}).primitive());
  const auto add_zero = [&] {
    if (at_zero > 0) r.roots.push_back({AlgebraicNumber(Rational(0)), at_zero});
  };
  if (rest->degree() == 0) {
    add_zero();
    return r;
  }
  const long bound = root_bound(*rest);
  const Side left{true, bound}, right{false, bound};
  if (triage_roots(rest, left, r.roots)) {
    std::reverse(r.roots.begin(), r.roots.end());
    add_zero();
    if (triage_roots(rest, right, r.roots)) {
      r.stage = Stage::triage;
      return r;
    }
  }
  r.roots.clear();
  add_zero();
  for (SquareFreeFactor& f : square_free_factors(*rest)) {
    const auto factor = std::make_shared<const IntegerPolynomial>(std::move(f.p));
    const long scale = root_bound(*factor);
    exact_roots(factor, f.multiplicity, {true, scale}, r.roots);
    exact_roots(factor, f.multiplicity, {false, scale}, r.roots);
  }
  sort(r.roots);
  return r;
}

}  // namespace crest::kernel
