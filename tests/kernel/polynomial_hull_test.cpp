// SPDX-License-Identifier: GPL-3.0-or-later
// Hull signs: error bounds against exact errors and an error-tracking number, stages, laws.
#include <catch2/catch.hpp>
#include <limits>

#include "kernel/polynomial/hull_stages.hpp"
#include "kernel/polynomial/simplex_net.hpp"
#include "kernel/polynomial/simplex_parts.hpp"
#include "tests/support/degenerate_families.hpp"

using namespace crest::kernel;
using namespace crest::tests;

namespace {

/// 54 d^2 - m q^3 on a tetrahedron, d of degree 3, q of degree 2: the shape of a tensor mode.
struct Sextic {
  SimplexNet<double, 3, 3> d;
  SimplexNet<double, 3, 2> q;
  double m;
  template <class T>
  auto value() const {
    const auto a = lifted<T>(d);
    const auto b = lifted<T>(q);
    return T(54.0) * (a * a) - T(m) * (b * b * b);
  }
};

struct Plain {
  SimplexNet<double, 2, 2> b;
  template <class T>
  auto value() const {
    return lifted<T>(b);
  }
};

/// Values and errors of doubles by the standard model, in rationals: |x| <= magnitude, error.
struct Tracked {
  Rational magnitude = 0, error = 0;
  Tracked() = default;
  Tracked(double x) : magnitude(std::fabs(x)) {}  // NOLINT: exact
  Tracked(Rational m, Rational e) : magnitude(std::move(m)), error(std::move(e)) {}
  static Tracked rounded(const Rational& m, const Rational& e) {
    const Rational u(kUnitRoundoff);
    return {m, e + u * (m + e)};
  }
  friend Tracked operator+(const Tracked& a, const Tracked& b) {
    return rounded(a.magnitude + b.magnitude, a.error + b.error);
  }
  friend Tracked operator-(const Tracked& a, const Tracked& b) { return a + b; }
  friend Tracked operator*(const Tracked& a, const Tracked& b) {
    return rounded(a.magnitude * b.magnitude,
                   a.magnitude * b.error + a.error * b.magnitude + a.error * b.error);
  }
};

template <class N>
void fill(N& net, Draw& d, Family family) {
  for (double& x : net.c) x = draw(d, family);
}
Sextic draw_sextic(Draw& d, Family family) {
  Sextic f;
  fill(f.d, d, family);
  fill(f.q, d, family);
  f.m = draw(d, family);
  return f;
}

}  // namespace

TEST_CASE("bounded forms: the bound covers the exact error, on all families") {
  double worst = 0;
  for (const Family family : kFamilies) {
    Draw d(830 + static_cast<std::uint64_t>(family));
    for (std::uint64_t i = 0; i < scaled(20); ++i) {
      const Sextic f = draw_sextic(d, family);
      const auto fast = f.value<Bounded<double>>();
      const auto slow = f.value<Rational>();
      if (!std::isfinite(fast.error)) continue;
      std::size_t wrong = 0;
      for (std::size_t k = 0; k < slow.s.size(); ++k) {
        const Rational weight(SimplexBasis<3, 6>::weights[k]);
        const Rational error = abs(Rational(fast.s[k]) - slow.s[k]);
        wrong += error > weight * Rational(fast.error);
        wrong += abs(slow.s[k]) > weight * Rational(fast.magnitude);
        wrong += std::fabs(fast.s[k]) > SimplexBasis<3, 6>::weights[k] * fast.magnitude;
        worst =
            std::max(worst, Rational(error / (weight * Rational(fast.error))).convert_to<double>());
      }
      REQUIRE(wrong == 0);
    }
  }
  CHECK(worst > 0.001);
}

TEST_CASE("bounded forms: the bound is derived again by an error-tracking number") {
  // Inputs of magnitude 1: the tracked error is the worst the standard model allows.
  Sextic f;
  f.d.c.fill(1);
  f.q.c.fill(1);
  f.m = 1;
  const auto tracked = f.value<Tracked>();
  const auto fast = f.value<Bounded<double>>();
  Rational largest = 0;
  for (std::size_t k = 0; k < tracked.s.size(); ++k) {
    const Rational weight(SimplexBasis<3, 6>::weights[k]);
    REQUIRE(tracked.s[k].error <= weight * Rational(fast.error));
    REQUIRE(tracked.s[k].magnitude <= weight * Rational(fast.magnitude));
    largest = std::max(largest, Rational(tracked.s[k].error / weight));
  }
  // The one bound is the largest of all coefficients', not many times it.
  CHECK(Rational(fast.error) < 3 * largest);
}

TEST_CASE("hull signs: the stage that decides") {
  Sextic f;
  f.d.c.fill(1);
  f.q.c.fill(1);
  f.m = 1;
  CHECK(hull(f).hull == Hull::positive);
  CHECK(hull(f).stage == Stage::triage);
  f.m = 100;
  CHECK(hull(f).hull == Hull::negative);
  CHECK(hull(f).stage == Stage::triage);
  f.m = 54;
  CHECK(hull(f).hull == Hull::zero);
  CHECK(hull(f).stage != Stage::triage);
  f.m = 54 * (1 - 0x1p-48);
  CHECK(hull(f).hull == Hull::positive);
  CHECK(hull(f).stage == Stage::interval);
  // 54 d^2 with d of both signs times 1/3, which rounds: only rationals see zeros.
  f.d.c.fill(1.0 / 3);
  f.q.c.fill(1);
  f.m = 6;
  const HullDecision h = hull(f);
  CHECK(h.hull == exact_hull(f));
  CHECK(h.stage == Stage::exact);
  f.d.c[0] = 10;
  f.m = 7;
  CHECK(hull(f).hull == Hull::mixed);
  CHECK(hull(f).stage == Stage::triage);
}

TEST_CASE("hull signs: corners and zeros tell positive from not negative") {
  const auto of = [](std::array<double, 6> c) { return hull(Plain{{c}}).hull; };
  CHECK(of({1, 0, 0, 1, 0, 1}) == Hull::positive);
  CHECK(of({1, 0, 0, 1, 0, 0}) == Hull::not_negative);
  CHECK(of({0, 0, 0, 0, 0, 0}) == Hull::zero);
  CHECK(of({-1, 0, 0, -1, 0, -1}) == Hull::negative);
  CHECK(of({0, 0, -1, 0, 0, 0}) == Hull::not_positive);
  CHECK(of({1, 0, 0, 1, -0x1p-1074, 1}) == Hull::mixed);
  for (const Hull h : {Hull::negative, Hull::not_positive, Hull::zero, Hull::mixed})
    CHECK(negated(negated(h)) == h);
  CHECK(negated(Hull::positive) == Hull::negative);
  CHECK(negated(Hull::not_negative) == Hull::not_positive);
  // Infinities and NaN are decided by nobody's doubles.
  const double inf = std::numeric_limits<double>::infinity();
  for (const double bad : {inf, -inf, std::nan("")})
    CHECK_FALSE(triage_hull(Plain{{{1, 1, bad, 1, 1, 1}}}));
  CHECK_FALSE(triage_hull(Plain{{{0x1p1000, 1, 1, 1, 1, 1}}}));
  CHECK(of({0x1p1000, 1, 1, 1, 1, 1}) == Hull::positive);
}

TEST_CASE("hull signs: stages agree on the degenerate families, triage seldom fails") {
  StageCounts generic, all;
  for (const Family family : kFamilies) {
    Draw d(840 + static_cast<std::uint64_t>(family));
    for (std::uint64_t i = 0; i < scaled(80); ++i) {
      const Sextic f = draw_sextic(d, family);
      const Hull truth = exact_hull(f);
      const auto fast = triage_hull(f);
      const auto interval = interval_hull(f);
      CAPTURE(static_cast<int>(family), i);
      if (fast) REQUIRE(*fast == truth);
      if (interval) REQUIRE(*interval == truth);
      const HullDecision decision = hull(f);
      REQUIRE(decision.hull == truth);
      all.add(decision.stage);
      if (family == Family::generic) generic.add(decision.stage);
    }
  }
  CHECK(generic.interval + generic.exact == 0);
  CHECK(all.exact < all.calls / 3);
}

TEST_CASE("hull signs: lanes give what doubles give") {
  Draw d(850);
  for (std::uint64_t i = 0; i < scaled(50); ++i) {
    std::array<Sextic, Lanes::count> f;
    SimplexNet<Lanes, 3, 3> a;
    SimplexNet<Lanes, 3, 2> q;
    for (std::size_t lane = 0; lane < f.size(); ++lane) {
      const bool one_sign = d.coin();
      f[lane] = draw_sextic(d, lane % 3 == 0 ? Family::small_integers : Family::generic);
      if (one_sign)
        for (double& x : f[lane].d.c) x = 3 + x;
      f[lane].m = 1;
      for (std::size_t k = 0; k < a.c.size(); ++k) a.c[k].x[lane] = f[lane].d.c[k];
      for (std::size_t k = 0; k < q.c.size(); ++k) q.c[k].x[lane] = f[lane].q.c[k];
    }
    using B = Bounded<Lanes>;
    const auto x = lifted<B>(a);
    const auto y = lifted<B>(q);
    const LaneSigns signs = certain_signs(B(54.0) * (x * x) - B(1.0) * (y * y * y));
    for (std::size_t lane = 0; lane < f.size(); ++lane) {
      const auto h = triage_hull(f[lane]);
      REQUIRE(((signs.positive >> lane & 1) != 0) == (h == Hull::positive));
      REQUIRE(((signs.negative >> lane & 1) != 0) == (h == Hull::negative));
    }
  }
}

TEST_CASE("hull signs: law 2, raising and halving never lose an answer") {
  Draw d(860);
  struct Exact {
    SimplexNet<Rational, 3, 3> b;
    Hull hull() const {
      return *hull_of(form(b), [](const Rational& x) -> MaybeSign { return sign_of(x); });
    }
  };
  std::size_t kept = 0;
  for (std::uint64_t i = 0; i < scaled(200); ++i) {
    Exact f;
    for (Rational& x : f.b.c) x = d.integer(-1, 6);
    for (std::size_t k = 0; k < 4; ++k)
      if (d.coin()) f.b.c[SimplexBasis<3, 3>::corner(k)] = 0;
    if (d.coin())
      for (Rational& x : f.b.c) x = abs(x);
    const Hull h = f.hull();
    if (h == Hull::mixed) continue;
    ++kept;
    const auto parts = split(f.b, 0, 2, Rational(1, 2));
    for (const auto& part : {parts.near, parts.far}) {
      const Hull p = Exact{part}.hull();
      REQUIRE((p == h || (h == Hull::not_negative && (p == Hull::positive || p == Hull::zero))));
    }
    const Hull up =
        *hull_of(form(raised(f.b)), [](const Rational& x) -> MaybeSign { return sign_of(x); });
    REQUIRE(up == h);
  }
  CHECK(kept > 20);
}
