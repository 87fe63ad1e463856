// SPDX-License-Identifier: GPL-3.0-or-later
// Containment: intervals against exact rationals, the argument and the vertex angles against MPFR.
#include <catch2/catch.hpp>
#include <cmath>

#include "certify/exact/argument.hpp"
#include "certify/exact/filtered.hpp"
#include "certify/ridges_mesh/angle_index.hpp"
#include "certify/ridges_mesh/vertex_angles.hpp"
#include "kernel/arithmetic/mp_interval.hpp"
#include "tests/certify/sample_meshes.hpp"
#include "tests/support/failures.hpp"

using namespace crest::certify;
using namespace crest::tests;
using crest::kernel::MpInterval;
using crest::kernel::Rational;
using crest::kernel::Sign;

namespace {

/// Zeros, small integers, and doubles of any size: 2^-300 .. 2^300.
double awkward(Random& random) {
  switch (random() % 4) {
    case 0:
      return 0;
    case 1:
      return static_cast<double>(random() % 7) - 3;
    default:
      return std::ldexp(uniform(random), static_cast<int>(random() % 600) - 300);
  }
}

/// A random interval at low precision, and a rational point inside.
std::pair<MpInterval, Rational> interval_and_point(Random& random) {
  const auto bits = static_cast<mpfr_prec_t>(20 + random() % 60);
  const double a = awkward(random), b = random() % 3 ? awkward(random) : a;
  const Rational t = Rational(random() % 9) / 8;
  // Inputs round outward at this precision; the hull of two points comes from a sum.
  const MpInterval one(a, bits), two(b, bits);
  const MpInterval zero_to_one = MpInterval::from(Rational(1) / 3, bits);
  const Rational third = Rational(1) / 3;
  if (random() % 2) return {one, Rational(a)};
  // (1/3 enclosed) a + b: wide for its precision, with a known point.
  return {zero_to_one * one + two, Rational(third * Rational(a) + Rational(b))};
}

}  // namespace

TEST_CASE("MpInterval encloses exact results, also when operands are one object") {
  Random random(kSeed);
  for (std::uint64_t i = 0; i < scaled(20000); ++i) {
    auto [a, x] = interval_and_point(random);
    auto [b, y] = interval_and_point(random);
    const OnFailure shown([&a = a, &b = b, &x = x, &y = y] {
      return "[a], x, [b], y = " + in_braces(a.lower(), a.upper(), x, b.lower(), b.upper(), y);
    });
    REQUIRE(a.contains(x));
    CHECK((a + b).contains(Rational(x + y)));
    CHECK((a - b).contains(Rational(x - y)));
    CHECK((a * b).contains(Rational(x * y)));
    if (y != 0) CHECK((a / b).contains(Rational(x / y)));
    CHECK((-a).contains(Rational(-x)));
    CHECK((a + a).contains(Rational(x + x)));
    CHECK((a - a).contains_zero());
    CHECK((a * a).contains(Rational(x * x)));
    if (x >= 0) {
      const MpInterval root = sqrt(a * a);
      CHECK(root.contains(x));
    }
    if (const auto sign = certain_sign(a)) CHECK(*sign == crest::kernel::sign_of(x));
    MpInterval c = a;
    c = c * b;
    CHECK(c.contains(Rational(x * y)));
    c = c - c;
    CHECK(c.contains_zero());
    c = std::move(a);
    CHECK(c.contains(x));
  }
}

TEST_CASE("MpInterval products of every combination of signs") {
  const auto hull = [](int low, int high) {
    // [low, high] from [0, 1] = sqrt-free operations: 1/[1, inf) does not serve; use a width.
    const MpInterval l(low, 53), h(high, 53);
    const MpInterval unit = MpInterval::pi(2);  // [3, 4]
    return l + (unit - MpInterval(3, 53)) * (h - l);
  };
  for (int a = -2; a <= 2; ++a)
    for (int b = a; b <= 2; ++b)
      for (int c = -2; c <= 2; ++c)
        for (int d = c; d <= 2; ++d) {
          const MpInterval p = hull(a, b) * hull(c, d);
          CHECK(p.lower() == std::min({a * c, a * d, b * c, b * d}));
          CHECK(p.upper() == std::max({a * c, a * d, b * c, b * d}));
          if (c > 0 || d < 0) {
            const MpInterval q = hull(a, b) / hull(c, d);
            for (const int x : {a, b})
              for (const int y : {c, d}) CHECK(q.contains(Rational(x) / y));
          } else {
            CHECK(std::isinf((hull(a, b) / hull(c, d)).upper()));
          }
        }
}

TEST_CASE("MpInterval atan2 encloses the argument over whole boxes, modulo 2 pi") {
  Random random(kSeed);
  for (std::uint64_t i = 0; i < scaled(20000); ++i) {
    auto [x, px] = interval_and_point(random);
    auto [y, py] = interval_and_point(random);
    if (px == 0 && py == 0) continue;
    const OnFailure shown([&x = x, &px = px, &y = y, &py = py] {
      return "[x], px, [y], py = " + in_braces(x.lower(), x.upper(), px, y.lower(), y.upper(), py);
    });
    const MpInterval angle = atan2(y, x);
    const MpInterval point = atan2(MpInterval::from(py, 500), MpInterval::from(px, 500));
    const MpInterval turn = MpInterval(2, 500) * MpInterval::pi(500);
    bool inside = false;
    for (const double k : {-1.0, 0.0, 1.0}) {
      const MpInterval p = point + MpInterval(k, 500) * turn;
      const auto below = certain_sign(p - angle);
      inside = inside || !below || *below == Sign::zero;
    }
    CHECK(inside);
  }
  // The boundary of the cut: both zeros count as +0, and the result is pi, not an interval of 2 pi.
  const MpInterval zero = MpInterval(1.5, 64) - MpInterval(1.5, 64);
  for (const auto& y : {zero, -zero, MpInterval(0.0, 64)}) {
    const MpInterval half = atan2(y, MpInterval(-2, 64));
    CHECK(std::fabs(half.lower()) > 3.14);
    CHECK(half.width() < 1e-15);
  }
  CHECK(atan2(zero, zero).width() > 6);
}

TEST_CASE("Argument stays within its error bound") {
  Random random(kSeed);
  const Argument argument;
  double worst = 0;
  const auto check = [&](double y, double x) {
    const OnFailure shown([&] { return "y, x = " + in_braces(y, x); });
    const MpInterval exact = atan2(MpInterval(y, 120), MpInterval(x, 120));
    const MpInterval off = MpInterval(argument(y, x), 120) - exact;
    const double error = std::max(std::fabs(off.lower()), std::fabs(off.upper()));
    worst = std::max(worst, error);
    CHECK(error <= Argument::kError);
  };
  for (std::uint64_t i = 0; i < scaled(100000); ++i) {
    double x = uniform(random), y = uniform(random);
    // Also at the seams of the table and of the octants, and far apart.
    if (i % 3 == 0)
      y = x * (static_cast<double>(random() % 33) / 32) * (1 + 1e-15 * uniform(random));
    if (i % 5 == 0) y = std::ldexp(y, -static_cast<int>(random() % 400));
    if (i % 2) std::swap(x, y);
    check(y, x);
  }
  for (const double x : {-1.0, 0.0, 1.0})
    for (const double y : {-1.0, 0.0, 1.0})
      if (x != 0 || y != 0) check(y, x);
  check(0x1p-500, 0x1p500);
  check(-0x1p500, -0x1p-500);
  INFO("largest error " << worst * 0x1p53 << " u");
  CHECK(worst > 0.5 * 0x1p-53);
}

TEST_CASE("Filtered: the error stays within the bound, and the bound is not idle") {
  Random random(kSeed);
  std::uint64_t decided = 0, all = 0;
  for (std::uint64_t i = 0; i < scaled(100000); ++i) {
    double a[6];
    for (double& x : a) x = i % 4 ? uniform(random) : awkward(random);
    if (i % 2) a[5] = a[0] * a[1] / (a[2] + 1e-3);  // near cancellation
    const OnFailure shown([&] { return "a = " + in_words(a); });
    const auto formula = [&](auto lift) {
      const auto d = lift(a[0]) * lift(a[1]) - lift(a[2]) * lift(a[5]);
      return (d * d - lift(a[3]) * d) * (lift(a[4]) - lift(a[3])) + d * lift(a[4]) * lift(a[4]);
    };
    const auto f = formula([](double x) { return filtered(x); });
    const Rational exact = formula([](double x) { return Rational(x); });
    if (!std::isfinite(f.magnitude)) continue;
    CHECK(abs(Rational(Rational(f.value) - exact)) <= Rational(f.bound()));
    ++all;
    if (const auto sign = certain_sign(f)) {
      ++decided;
      CHECK(*sign == crest::kernel::sign_of(exact));
    }
  }
  CHECK(decided > all / 3);
}

TEST_CASE("Filtered never decides across underflow or overflow") {
  Random random(kSeed);
  for (std::uint64_t i = 0; i < scaled(100000); ++i) {
    double a[4];
    for (double& x : a)
      x = std::ldexp(uniform(random), (random() % 2 ? 1 : -1) * static_cast<int>(random() % 1070));
    const OnFailure shown([&] { return "a = " + in_words(a); });
    const auto formula = [&](auto lift) {
      return (lift(a[0]) * lift(a[1]) - lift(a[2]) * lift(a[3])) * lift(a[3]) + lift(a[1]);
    };
    const auto sign = certain_sign(formula([](double x) { return filtered(x); }));
    if (sign) CHECK(*sign == crest::kernel::sign_of(formula([](double x) { return Rational(x); })));
  }
}

TEST_CASE("double angles enclose those of MPFR at every vertex") {
  std::size_t known = 0;
  for (const auto& [name, data] : all_samples()) {
    INFO(name);
    const Topology t = build_topology(data.faces, data.positions.size());
    const DoubleAngles angles = enclose_angles(data, t);
    const MpInterval turn = MpInterval(2, 256) * MpInterval::pi(256);
    for (std::uint32_t v = 0; v < data.positions.size(); ++v) {
      if (!(angles.error[v] < 0.5)) continue;
      ++known;
      const auto exact = enclose_vertex(data, t, v, AngleStage::rational);
      REQUIRE(exact);
      const auto check = [&](const MpInterval& x, double y) {
        const MpInterval off = x - MpInterval(y, 256);
        CHECK(std::max(std::fabs(off.lower()), std::fabs(off.upper())) <= angles.error[v]);
      };
      for (auto i = t.ring_start[v]; i < t.ring_start[v + 1]; ++i) {
        const std::uint32_t c = t.ring[i], k = i - t.ring_start[v];
        check(exact->sums[k], angles.before[c]);
        check(exact->sums[k + 1] - exact->sums[k], angles.angle[c]);
      }
      check(exact->sums.back(), angles.total[v]);
      // phi modulo 2 pi.
      const double k = std::nearbyint((exact->phi.lower() - angles.phi[v]) / (2 * M_PI));
      check(exact->phi - MpInterval(k, 256) * turn, angles.phi[v]);
    }
  }
  CHECK(known > 300);
}
