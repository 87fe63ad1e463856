// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/geometry/monge_form.hpp"
#include "kernel/predicates/against_faces.hpp"
#include "kernel/predicates/collinear.hpp"
#include "kernel/predicates/extremality_sign.hpp"
#include "kernel/predicates/segment_type.hpp"
#include "kernel/predicates/umbilic_kind.hpp"
#include "tests/kernel/ladder_checks.hpp"

using namespace crest::kernel;
using namespace crest::tests;

namespace {

RidgeEndData draw_end(Draw& d, Family f) {
  return {draw(d, f), draw(d, f), draw(d, f), draw(d, f), draw(d, f)};
}
CubicDiscriminant draw_cubic(Draw& d, Family f) {
  return {draw(d, f), draw(d, f), draw(d, f), draw(d, f)};
}
Vec3 negated(const Vec3& v) {
  return {-v[0], -v[1], -v[2]};
}

}  // namespace

TEST_CASE("depths are those of the templates") {
  const CrossedTriangle t{};
  require_depth(CrossCoordinate{});
  require_depth(InterpolatedP{});
  require_depth(SegmentSide{t, {}, {}, true});
  CHECK(SegmentSide::depth >= (SegmentSide{t, {}, {}, false}.value<Depth>().count));
  require_depth(CubicDiscriminant{});
  require_depth(GapDifference{});
}

TEST_CASE("extremality sign: odd, never zero, symbolic only at zero") {
  for (Family family : kFamilies) {
    Draw d(10, family);
    for (int i = 0; i < 2000; ++i) {
      const Vec3 v = draw_vector(d, family);
      const double b = i % 3 == 0 ? 0.0 : draw(d, family);
      const OnFailure shown([&] { return "b, v = " + in_braces(b, v); });
      const Decision s = extremality_sign(b, v);
      REQUIRE(s.sign != Sign::zero);
      REQUIRE(extremality_sign(-b, negated(v)).sign == -s.sign);
      REQUIRE((s.stage == Stage::symbolic) == (b == 0));
      if (b != 0) REQUIRE(s.sign == sign_of(b));
    }
  }
}

TEST_CASE("crossing type: stages, laws, agreement", "[stress]") {
  const RidgeEndData flat{0, 0, 0, 0, 0}, cylinder{1, 1, 0, 0, 3};
  CHECK(crossing_type(flat, flat).sign == Sign::zero);
  CHECK(crossing_type(cylinder, cylinder).sign == Sign::zero);  // law 3
  CHECK(crossing_type({1, 1, 0, 0, 0}, {1, 1, 0, 0, 0}).sign == Sign::negative);
  CHECK(crossing_type({1, 1, 0, 2, 0}, {1, 1, 0, 2, 0}).stage == Stage::triage);
  StageCounts all;
  for (Family family : kFamilies) {
    Draw d(20, family);
    all += require_stages_agree<InterpolatedP>(scaled(150000), [&](std::uint64_t) {
      return InterpolatedP{draw_end(d, family), draw_end(d, family)};
    });
    for (int i = 0; i < 500; ++i) {
      const RidgeEndData p = draw_end(d, family), q = draw_end(d, family);
      const OnFailure shown([&] { return "ends " + in_braces(p, q); });
      REQUIRE(crossing_type(p, q).sign == crossing_type(q, p).sign);  // law 1
      RidgeEndData r = p;                                             // law 2: reversal
      r.b = -r.b;
      r.m = -r.m;
      REQUIRE(crossing_type(p, q).sign == crossing_type(r, q).sign);
      REQUIRE(bound_holds(InterpolatedP{p, q}));
    }
  }
  CHECK(all.interval > 0);
  CHECK(all.exact > 0);
}

TEST_CASE("segment type: stages, laws, agreement", "[stress]") {
  StageCounts all;
  for (Family family : kFamilies) {
    Draw d(40, family);
    CrossedTriangle t{};
    auto next = [&](std::uint64_t i) {
      t = {draw_vector(d, family), draw_vector(d, family), draw_vector(d, family),
           draw(d, family),        draw(d, family),        draw(d, family)};
      return SegmentSide{t, draw_vector(d, family), draw_vector(d, family), i % 2 == 1};
    };
    all += require_stages_agree<SegmentSide>(scaled(150000), next);
    for (std::uint64_t i = 0; i < 300; ++i) {
      const SegmentSide s = next(i);
      const OnFailure shown([&] { return "side " + in_words(s); });
      SegmentSide reversed = s;
      reversed.d1 = negated(s.d1);
      REQUIRE(segment_side(reversed).sign == -segment_side(s).sign);  // law 1
      REQUIRE(bound_holds(s));
    }
  }
  CHECK(all.interval > 0);
  CHECK(all.exact > 0);
  // Law 3: u along the segment. The triangle is symmetric, the segment parallel to v2 v3.
  const CrossedTriangle t{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 1, 1, 1};
  CHECK(segment_side({t, {1, -1, 0}, {0, 0, 1}, false}).sign == Sign::zero);
  CHECK(segment_side({t, {1, 1, 0}, {0, 0, 1}, false}).sign == Sign::positive);
  CHECK(segment_side({t, {1, -1, 0}, {0, 0, 1}, true}).sign == Sign::positive);
}

TEST_CASE("umbilic kind: roots of the cubic form, laws, agreement", "[stress]") {
  // x^3 - 3 x y^2 (monkey saddle): three real lines. x^3 + 3 x y^2: one. (x + y)^3: degenerate.
  CHECK(umbilic_kind({1, 0, -1, 0}).sign == Sign::negative);
  CHECK(umbilic_kind({1, 0, 1, 0}).sign == Sign::positive);
  CHECK(umbilic_kind({1, 1, 1, 1}).sign == Sign::zero);
  CHECK(umbilic_kind({0, 0, 0, 0}).sign == Sign::zero);
  StageCounts all;
  for (Family family : kFamilies) {
    Draw d(60, family);
    all += require_stages_agree<CubicDiscriminant>(
        scaled(150000), [&](std::uint64_t) { return draw_cubic(d, family); });
    for (int i = 0; i < 500; ++i) {
      const CubicDiscriminant c = draw_cubic(d, family);
      const OnFailure shown([&] { return "cubic " + in_words(c); });
      REQUIRE(umbilic_kind({-c.b0, -c.b1, -c.b2, -c.b3}).sign == umbilic_kind(c).sign);
      // Rotation by a quarter turn: (x, y) -> (y, -x).
      REQUIRE(umbilic_kind({-c.b3, c.b2, -c.b1, c.b0}).sign == umbilic_kind(c).sign);
      REQUIRE(bound_holds(c));
    }
  }
  CHECK(all.interval > 0);
  CHECK(all.exact > 0);
}

TEST_CASE("collinear: exact on thin triangles", "[stress]") {
  CHECK(collinear({0, 0, 0}, {1, 1, 1}, {3, 3, 3}));
  CHECK(!collinear({0, 0, 0}, {1, 1, 1}, {3, 3, 3.0000000000000004}));
  CHECK(collinear({0.1, 0.1, 0.1}, {0.1, 0.1, 0.1}, {5, 6, 7}));  // law 2
  // 0.1 + 0.1 is exactly twice 0.1, 0.1 + 0.2 is not three times 0.1.
  CHECK(collinear({0, 0, 0}, {0.1, 0.1, 0.1}, {0.2, 0.2, 0.2}));
  CHECK(!collinear({0, 0, 0}, {0.1, 0.1, 0.3}, {0.2, 0.2, 0.6000000000000001}));
  for (Family family : kFamilies) {
    Draw d(80, family);
    require_stages_agree<CrossCoordinate>(scaled(150000), [&](std::uint64_t) {
      return CrossCoordinate{draw(d, family), draw(d, family), draw(d, family),
                             draw(d, family), draw(d, family), draw(d, family)};
    });
    for (int i = 0; i < 500; ++i) {
      const Vec3 a = draw_vector(d, family), b = draw_vector(d, family), c = draw_vector(d, family);
      const OnFailure shown([&] { return "points " + in_braces(a, b, c); });
      const bool answer = collinear(a, b, c);
      REQUIRE(collinear(b, a, c) == answer);  // law 1
      REQUIRE(collinear(c, b, a) == answer);
    }
  }
}

TEST_CASE("normals against the faces: laws, and exact where the terms cancel") {
  CHECK(AlongNormal::depth >= (AlongNormal{}.value<Depth>().count));
  // The corner of a cube seen from outside: its three faces, counter-clockwise.
  const Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, o{0, 0, 0};
  std::vector<std::array<Vec3, 2>> sides = {{x, y}, {y, z}, {z, x}};
  CHECK_FALSE(against_faces({1, 1, 1}, o, sides));
  CHECK(against_faces({-1, -1, -1}, o, sides));
  CHECK_FALSE(against_faces({1e-320, 0, 0}, o, sides));  // one positive term, two of zero
  // The sum is exactly (1, 1, 1): at right angles to it both ways are against.
  CHECK(against_faces({1, -1, 0}, o, sides));
  CHECK(against_faces({-1, 1, 0}, o, sides));
  // By one unit in the last place.
  CHECK_FALSE(against_faces({1, -1 + 0x1p-53, 0}, o, sides));
  CHECK(against_faces({1, -1 - 0x1p-52, 0}, o, sides));
  CHECK_FALSE(against_faces({1e300, -1e300, 5e-324}, o, sides));
  CHECK(against_faces({1e300, -1e300, -5e-324}, o, sides));
  for (auto& [q, r] : sides) std::swap(q, r);
  CHECK(against_faces({1, 1, 1}, o, sides));
}
