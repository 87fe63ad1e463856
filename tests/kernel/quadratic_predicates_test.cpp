// SPDX-License-Identifier: GPL-3.0-or-later
// The decisions of the monotone tessellation: stages, laws, filter failures.
#include "kernel/predicates/boundary_saddle.hpp"
#include "kernel/predicates/critical_value_order.hpp"
#include "kernel/predicates/line_critical.hpp"
#include "tests/kernel/ladder_checks.hpp"

using namespace crest::kernel;
using namespace crest::tests;

namespace {

using enum ValueKind;

EdgeValues draw_edge_values(Draw& d, Family family) {
  return {draw(d, family), draw(d, family), draw(d, family)};
}
FaceValues draw_face(Draw& d, Family family) {
  FaceValues f;
  for (double& x : f.corner) x = draw(d, family);
  for (double& x : f.side) x = draw(d, family);
  return f;
}
EdgeValues negated(const EdgeValues& e) {
  return {-e.a, -e.b, -e.m};
}
FaceValues negated(FaceValues f) {
  for (double& x : f.corner) x = -x;
  for (double& x : f.side) x = -x;
  return f;
}
FaceValues doubled(FaceValues f) {
  for (double& x : f.corner) x *= 2;
  for (double& x : f.side) x *= 2;
  return f;
}

// A random node with a value: of a vertex, an edge or a face.
CriticalValue draw_critical_value(Draw& d, Family family) {
  for (;;) {
    const int kind = d.integer(0, 2);
    if (kind == 0) return CriticalValue::vertex(draw(d, family));
    if (kind == 1) {
      const EdgeValues e = draw_edge_values(d, family);
      if (const Sign s = line_critical(e).sign; s != Sign::zero) return CriticalValue::edge(e, s);
      continue;
    }
    const FaceValues f = draw_face(d, family);
    if (const Sign s = face_critical(f).sign; s != Sign::zero) return CriticalValue::face(f, s);
  }
}

Rational exact_critical_value(const CriticalValue& v) {
  auto at = [&](const auto& q) { return Rational(v.f.corner[0]) + q.numerator / q.denominator; };
  if (v.kind == vertex) return Rational(v.f.corner[0]);
  return v.kind == edge ? at(ValueFraction<Rational, edge>(v.f))
                        : at(ValueFraction<Rational, face>(v.f));
}

template <class Formula, class Make>
void check_formula(const char* name, double rate, Make&& make) {
  CAPTURE(name);
  require_depth(Formula{});
  StageCounts all;
  for (Family family : kFamilies) {
    Draw d(500, family);
    const StageCounts counts = require_stages_agree<Formula>(
        scaled(50000), [&](std::uint64_t) { return make(d, family); });
    if (family == Family::generic)  // the filter's failure rate is a promise
      CHECK(static_cast<double>(counts.interval + counts.exact) <=
            rate * static_cast<double>(counts.calls));
    all += counts;
    require_bound(scaled(500), [&] { return make(d, family); });
  }
  CHECK(all.calls > all.interval + all.exact);
  CHECK(all.interval > 0);
  CHECK(all.exact > 0);
}

}  // namespace

TEST_CASE("line-critical: every stage decides") {
  struct Case {
    EdgeValues e;
    Sign sign;
    Stage stage;
  };
  const double u = 0x1p-52;
  const Case cases[] = {
      {{0, 0, 1}, Sign::negative, Stage::triage},
      {{0, 0, -1}, Sign::positive, Stage::triage},
      {{0, 1, 0.5}, Sign::zero, Stage::triage},
      // Constant: every difference is exactly zero, which intervals keep.
      {{0.1, 0.1, 0.1}, Sign::zero, Stage::interval},
      // The derivative vanishes in an end.
      {{0, 4, 1}, Sign::zero, Stage::interval},
      {{4, 0, 1}, Sign::zero, Stage::interval},
      // 4 (m - a) - (b - a) cancels but for b's last bit, which b - a rounds away.
      {{-1, 3 + 2 * u, 0}, Sign::positive, Stage::exact},
      {{-1, 3 - 2 * u, 0}, Sign::zero, Stage::interval},
  };
  for (const Case& c : cases) {
    CAPTURE(c.e.a, c.e.b, c.e.m);
    const Decision d = line_critical(c.e);
    CHECK(d.sign == c.sign);
    CHECK(d.stage == c.stage);
  }
}

TEST_CASE("line-critical: laws 1 to 5 on all families") {
  Failures failures;
  for (Family family : kFamilies) {
    Draw d(510, family);
    for (std::uint64_t i = 0; i < scaled(20000); ++i) {
      const EdgeValues e = draw_edge_values(d, family);
      const Sign s = line_critical(e).sign;
      bool ok = line_critical({e.b, e.a, e.m}).sign == s && line_critical(negated(e)).sign == -s &&
                line_critical({2 * e.a, 2 * e.b, 2 * e.m}).sign == s;
      if (s != Sign::zero && i % 8 == 0) {
        const Rational v = exact_critical_value(CriticalValue::edge(e, s));
        ok = ok && (s == Sign::positive ? v < Rational(e.a) && v < Rational(e.b)
                                        : v > Rational(e.a) && v > Rational(e.b));
      }
      if (i % 8 == 0) {
        const Rational bend = 4 * abs(Rational(e.a) + Rational(e.b) - 2 * Rational(e.m));
        if (std::min(e.a, e.b) <= e.m && e.m <= std::max(e.a, e.b) &&
            bend <= abs(Rational(e.b) - Rational(e.a)))
          ok = ok && s == Sign::zero;
        if (family == Family::small_integers)
          ok = ok && line_critical({e.a + 7, e.b + 7, e.m + 7}).sign == s;
      }
      failures.expect(ok, "the laws hold for", e);
    }
  }
  CHECK(failures.report() == "");
}

TEST_CASE("face-critical and boundary saddle: laws on all families") {
  Failures failures;
  for (Family family : kFamilies) {
    Draw d(520, family);
    for (std::uint64_t i = 0; i < scaled(10000); ++i) {
      const FaceValues f = draw_face(d, family);
      const Sign inside = face_critical(f).sign, h = hessian({f}).sign;
      const Sign saddle = boundary_saddle(f).sign;
      bool ok = true;
      for (const FaceValues& g : {f.rotated(1), f.rotated(2), f.mirrored(), negated(f), doubled(f)})
        ok = ok && face_critical(g).sign == inside && hessian({g}).sign == h;
      for (const FaceValues& g : {f.mirrored(), negated(f), doubled(f)})
        ok = ok && boundary_saddle(g).sign == saddle;
      if (inside != Sign::zero) {
        ok = ok && inside == h;  // the sides sum to H
        bool some = false;
        for (std::size_t k = 0; k < 3; ++k) some |= line_critical(f.edge(k)).sign != Sign::zero;
        ok = ok && some;
      }
      failures.expect(ok, "the laws hold for", f);
      if (i % 16 == 0) {
        const Rational sum = CentreSide{f}.value<Rational>() +
                             CentreSide{f.rotated(1)}.value<Rational>() +
                             CentreSide{f.rotated(2)}.value<Rational>();
        failures.expect(sum == 4 * Hessian{f}.value<Rational>(), "the sides sum to 4 H for", f);
      }
    }
  }
  CHECK(failures.report() == "");
}

TEST_CASE("face-critical and boundary saddle: known triangles and every stage") {
  // x^2 + y^2 about the point (1/3, 1/3) or (1/4, 1/4), times 144, on the unit triangle.
  const FaceValues bowl = {{32, 80, 80}, {20, 8, 20}};
  CHECK(face_critical(bowl).sign == Sign::positive);
  CHECK(face_critical(bowl).stage == Stage::triage);
  // x y about (1/4, 1/4), times 16.
  const FaceValues saddle = {{1, -3, -3}, {-1, 1, -1}};
  CHECK(face_critical(saddle).sign == Sign::negative);
  // y^2 - x^2, times 4: the centre is a corner.
  const FaceValues corner = {{0, -4, 4}, {-1, 0, 1}};
  CHECK(face_critical(corner).sign == Sign::zero);
  CHECK(hessian({corner}).sign == Sign::negative);
  // (2x - 1)^2 - 4 y^2 and (2x - 1)^2 + 4 y^2: the centre (1/2, 0) on a side, where H decides.
  const FaceValues cross = {{1, 1, -3}, {0, -1, 0}}, bowl_on_side = {{1, 1, 5}, {0, 1, 2}};
  for (const FaceValues& f : {cross, bowl_on_side}) {
    CHECK(line_critical(f.edge(0)).sign == Sign::positive);
    CHECK(centre_side({f}).sign == Sign::zero);
    CHECK(face_critical(f).sign == Sign::zero);
    CHECK(boundary_saddle(f).sign == -hessian({f}).sign);
  }
  CHECK(boundary_saddle(cross).sign == Sign::positive);
  CHECK(boundary_saddle(bowl_on_side).sign == Sign::negative);
  // (2x - 1)^2: a line of critical points.
  const FaceValues line = {{1, 1, 1}, {0, 0, 1}};
  CHECK(hessian({line}).sign == Sign::zero);
  CHECK(face_critical(line).sign == Sign::zero);
  CHECK(boundary_saddle(line).sign == Sign::zero);
  CHECK(boundary_saddle(line).stage == Stage::interval);
  // (2x - 1)^2 - 4 y: the derivative across the edge decides.
  const FaceValues gutter = {{1, 1, -3}, {0, -2, -1}};
  CHECK(boundary_saddle(gutter).sign == Sign::positive);
  CHECK(boundary_saddle(gutter).stage == Stage::triage);
  // Constant in 0.1, which is no small integer: intervals see the zeros.
  const FaceValues constant = {{0.1, 0.1, 0.1}, {0.1, 0.1, 0.1}};
  CHECK(face_critical(constant).sign == Sign::zero);
  CHECK(face_critical(constant).stage == Stage::interval);
}

TEST_CASE("predicates of the tessellation: stages agree on the families", "[stress]") {
  const auto any = [](Draw& d, Family family) { return draw_face(d, family); };
  check_formula<EndSlope>("end slope", 1e-5, [](Draw& d, Family family) {
    EdgeValues e = draw_edge_values(d, family);
    // Nearly flat at the end.
    if (family == Family::mixed_scales && d.coin()) e.m = e.a + (e.b - e.a) / 4;
    return EndSlope{e};
  });
  check_formula<CentreSide>("centre side", 1e-4,
                            [&](Draw& d, Family f) { return CentreSide{any(d, f)}; });
  check_formula<Hessian>("hessian", 1e-4, [&](Draw& d, Family f) { return Hessian{any(d, f)}; });
  const auto pair = [&]<class Formula>(Draw& d, Family f) { return Formula{any(d, f), any(d, f)}; };
#define CREST_CHECK_PAIR(X, Y)                                                   \
  check_formula<ValueDifference<X, Y>>(#X " " #Y, 1e-4, [&](Draw& d, Family f) { \
    return pair.operator()<ValueDifference<X, Y>>(d, f);                         \
  })
  CREST_CHECK_PAIR(edge, vertex);
  CREST_CHECK_PAIR(face, vertex);
  CREST_CHECK_PAIR(edge, edge);
  CREST_CHECK_PAIR(face, edge);
  CREST_CHECK_PAIR(face, face);
#undef CREST_CHECK_PAIR
}

TEST_CASE("order of critical values: laws on all families") {
  for (Family family : kFamilies) {
    Draw d(530, family);
    for (std::uint64_t i = 0; i < scaled(1500); ++i) {
      const CriticalValue v[] = {draw_critical_value(d, family), draw_critical_value(d, family),
                                 draw_critical_value(d, family)};
      const OnFailure shown([&] { return "values " + in_braces(v[0], v[1], v[2]); });
      const Rational x[] = {exact_critical_value(v[0]), exact_critical_value(v[1]),
                            exact_critical_value(v[2])};
      for (std::uint32_t a = 0; a < 3; ++a)
        for (std::uint32_t b = 0; b < 3; ++b) {
          if (a == b) continue;
          const Decision c = critical_value_order(v[a], a, v[b], b);
          const Sign want = x[a] != x[b] ? sign_of(Rational(x[a] - x[b]))
                            : a < b      ? Sign::negative
                                         : Sign::positive;
          REQUIRE(c.sign == want);
          REQUIRE((c.stage == Stage::symbolic) == (x[a] == x[b]));
          if (const MaybeSign s = triage_critical_value_order(v[a], v[b]))
            REQUIRE(*s == sign_of(Rational(x[a] - x[b])));
          if (const MaybeSign s = interval_critical_value_order(v[a], v[b]))
            REQUIRE(*s == sign_of(Rational(x[a] - x[b])));
          REQUIRE(exact_critical_value_order(v[a], v[b]) == sign_of(Rational(x[a] - x[b])));
        }
    }
  }
}

TEST_CASE("order of critical values: law 3, from every side") {
  StageCounts counts;
  for (Family family : kFamilies) {
    Draw d(540, family);
    for (std::uint64_t i = 0; i < scaled(500); ++i) {
      const EdgeValues e = draw_edge_values(d, family);
      const FaceValues f = draw_face(d, family);
      const OnFailure shown([&] { return "edge and face " + in_braces(e, f); });
      if (const Sign s = line_critical(e).sign; s != Sign::zero) {
        const auto x = CriticalValue::edge(e, s), y = CriticalValue::edge({e.b, e.a, e.m}, s);
        REQUIRE(compare_critical_values(x, y).sign == Sign::zero);
        counts.add(critical_value_order(x, 0, y, 1).stage);
        const Sign end = compare_critical_values(x, CriticalValue::vertex(e.a)).sign;
        REQUIRE(end == -s);  // law 4
        const auto n = CriticalValue::edge(negated(e), -s);
        REQUIRE(compare_critical_values(n, CriticalValue::vertex(-e.a)).sign == -end);  // law 5
      }
      if (const Sign s = face_critical(f).sign; s != Sign::zero)
        for (const FaceValues& g : {f.rotated(1), f.rotated(2), f.mirrored()})
          REQUIRE(
              compare_critical_values(CriticalValue::face(f, s), CriticalValue::face(g, s)).sign ==
              Sign::zero);
    }
  }
  CHECK(counts.symbolic > 0);
}

TEST_CASE("critical values: enclosures and places hold in rationals") {
  for (Family family : kFamilies) {
    Draw d(550, family);
    for (std::uint64_t i = 0; i < scaled(1500); ++i) {
      const CriticalValue v = draw_critical_value(d, family);
      const OnFailure shown([&] { return "value " + in_words(v); });
      const Rational x = exact_critical_value(v);
      const ValueRange r = value_range(v);
      REQUIRE(Rational(r.low) <= x);
      REQUIRE(x <= Rational(r.high));
      double scale = 0;
      for (std::size_t k = 0; k < 3; ++k)
        scale = std::max({scale, std::fabs(v.f.corner[k]), std::fabs(v.f.side[k])});
      REQUIRE(r.high - r.low <= 0x1p-39 * scale + 0x1p-1073);
      if (v.kind == vertex) continue;
      const auto [s, t] = critical_place(v);
      REQUIRE((0 <= s && 0 <= t && s + t <= 1 + 0x1p-39));
      // There the gradient vanishes: along the edge g + 4 p s, in the face g + 4 p s + 4 q t.
      const FaceDerivatives<Rational> at(v.f);
      const Rational gradient = at.g + 4 * at.p * Rational(s) +
                                (v.kind == face ? Rational(4 * at.q * Rational(t)) : Rational(0));
      REQUIRE(abs(gradient) <= Rational(0x1p-35) * Rational(scale));
    }
  }
}
