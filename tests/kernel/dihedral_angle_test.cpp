// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/predicates/dihedral_angle.hpp"

#include <stdexcept>

#include "kernel/predicates/collinear.hpp"
#include "tests/kernel/ladder_checks.hpp"

using namespace crest::kernel;
using namespace crest::tests;

namespace {

DihedralEdge draw_edge(Draw& d, Family f) {
  return {draw_vector(d, f), draw_vector(d, f), draw_vector(d, f), draw_vector(d, f)};
}
bool has_areas(const DihedralEdge& e) {
  return !collinear(e.v, e.w, e.left) && !collinear(e.w, e.v, e.right);
}
/// The edge along z; the left normal is the y-axis, the right one (x, y), turned from it.
DihedralEdge between(double x, double y) {
  return {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-y, x, 0}};
}
Sign above(double x, double y, const char* degrees) {
  return dihedral_angle(between(x, y), DecimalAngle(degrees)).sign;
}

constexpr std::array kAngles = {"0",   "0.001", "15",  "30",      "45",  "59.99",
                                "60",  "75",    "90",  "105",     "120", "90.5",
                                "135", "150",   "170", "179.999", "180"};

}  // namespace

TEST_CASE("dihedral angle: the depths are those of the templates") {
  require_depth(NormalProduct{});
  require_depth(SquaredCosineGap{});
}

TEST_CASE("dihedral angle: the nine angles with a rational squared cosine tie exactly") {
  // Normals (0, 1) and (x, y).
  CHECK(above(0, 1, "0") == Sign::zero);
  CHECK(above(1, 1, "45") == Sign::zero);
  CHECK(above(3, 0, "90") == Sign::zero);
  CHECK(above(-2, -2, "135") == Sign::zero);
  CHECK(above(0, -1, "180") == Sign::zero);
  // 60 and so on need a root in the plane, not in space: normals (1, 1, 0) and (0, 1, 1).
  const DihedralEdge sixty{{0, 0, 0}, {1, -1, 1}, {0, 0, -1}, {-1, 0, 0}};
  CHECK(dihedral_angle(sixty, DecimalAngle("60")).sign == Sign::zero);
  CHECK(dihedral_angle(sixty, DecimalAngle("60.000")).sign == Sign::zero);
  CHECK(dihedral_angle(sixty, DecimalAngle("60.0000000000000000000000000000001")).sign ==
        Sign::negative);
  CHECK(dihedral_angle(sixty, DecimalAngle("59.9999999999999999999999999999999")).sign ==
        Sign::positive);
  const DihedralEdge other{{0, 0, 0}, {1, -1, 1}, {0, 0, -1}, {1, 0, 0}};
  CHECK(dihedral_angle(other, DecimalAngle("120")).sign == Sign::zero);
  CHECK(dihedral_angle(other, DecimalAngle("120.0000000000000000000001")).sign == Sign::negative);
  // Normals (1, 1, 0) and (2, 1, 1): the cosine is 3 / sqrt(12).
  const DihedralEdge thirty{{0, 0, 0}, {1, -1, -1}, {0, 0, -1}, {1, -2, 0}};
  CHECK(dihedral_angle(thirty, DecimalAngle("30")).sign == Sign::zero);
  const DihedralEdge back{{0, 0, 0}, {1, -1, -1}, {0, 0, -1}, {-1, 2, 0}};
  CHECK(dihedral_angle(back, DecimalAngle("150")).sign == Sign::zero);
}

TEST_CASE("dihedral angle: a right angle, half a turn, and angles near them") {
  CHECK(above(1, 0, "89.99999999999999999999999999999999999999") == Sign::positive);
  CHECK(above(1, 0, "90.00000000000000000000000000000000000001") == Sign::negative);
  CHECK(above(1, 0x1p-60, "90") == Sign::negative);
  CHECK(above(1, -0x1p-60, "90") == Sign::positive);
  CHECK(above(0, -1, "179.9999999999999999999999999999") == Sign::positive);
  CHECK(above(0x1p-200, -1, "180") == Sign::negative);
  CHECK(above(0x1p-200, 1, "0") == Sign::positive);
  // arctan(1/2) = 26.565051177077989351572193720453...
  CHECK(above(1, 2, "26.565051177077989351572193720453") == Sign::positive);
  CHECK(above(1, 2, "26.565051177077989351572193720454") == Sign::negative);
  CHECK(above(-1, -2, "153.434948822922010648427806279546") == Sign::positive);
  CHECK(above(-1, -2, "153.434948822922010648427806279547") == Sign::negative);
}

TEST_CASE("dihedral angle: each stage decides, and none contradicts a later one", "[stress]") {
  StageCounts product, gap, all;
  for (Family family : kFamilies) {
    Draw d(900, family);
    product += require_stages_agree<NormalProduct>(
        scaled(20000), [&](std::uint64_t) { return NormalProduct{draw_edge(d, family)}; });
    gap += require_stages_agree<SquaredCosineGap>(scaled(20000), [&](std::uint64_t i) {
      return SquaredCosineGap{draw_edge(d, family), 0.25 * static_cast<double>(i % 5)};
    });
    require_bound(500, [&] { return NormalProduct{draw_edge(d, family)}; });
    require_bound(500, [&] { return SquaredCosineGap{draw_edge(d, family), 0.5 * d.uniform()}; });
    for (std::uint64_t i = 0; i < scaled(1500); ++i) {
      const DihedralEdge e = draw_edge(d, family);
      if (!has_areas(e)) continue;
      const DecimalAngle angle(kAngles[i % kAngles.size()]);
      const OnFailure shown([&] { return angle.text() + " degrees, edge " + in_words(e); });
      const Decision decision = dihedral_angle(e, angle);
      const Sign exact = exact_dihedral_angle(e, angle);
      all.add(decision.stage);
      REQUIRE(decision.sign == exact);
      if (const MaybeSign s = triage_dihedral_angle(e, angle)) REQUIRE(*s == exact);
      if (const MaybeSign s = interval_dihedral_angle(e, angle)) REQUIRE(*s == exact);
    }
  }
  CHECK(gap.interval > 0);
  CHECK(all.interval > 0);
  CHECK(all.exact > 0);
  // Inputs without cancellation: doubles decide nearly all.
  Draw d(910, Family::generic);
  const auto generic = require_stages_agree<SquaredCosineGap>(scaled(20000), [&](std::uint64_t) {
    return SquaredCosineGap{draw_edge(d, Family::generic), 0.3};
  });
  CHECK((generic.interval + generic.exact) * 1000 < generic.calls);
  // Far from the origin: the differences are exact, so doubles still decide.
  const double far = 0x1p30;
  const DihedralEdge away{
      {far, far, far}, {far, far, far + 1}, {far + 1, far, far}, {far - 1, far + 1, far}};
  CHECK(dihedral_angle(away, DecimalAngle("60")).stage == Stage::triage);
}

TEST_CASE("dihedral angle: laws") {
  for (Family family : kFamilies) {
    Draw d(920, family);
    for (int i = 0; i < 300; ++i) {
      const DihedralEdge e = draw_edge(d, family);
      if (!has_areas(e)) continue;
      const OnFailure shown([&] { return "edge " + in_words(e); });
      const DihedralEdge swapped{e.w, e.v, e.right, e.left};
      DihedralEdge scaled_up = e, mirrored{e.w, e.v, e.left, e.right};
      for (Vec3* p : {&scaled_up.v, &scaled_up.w, &scaled_up.left, &scaled_up.right})
        *p = {-8 * (*p)[1], 8 * (*p)[2], 8 * (*p)[0]};
      Sign before = Sign::positive;
      for (const char* text : {"0", "30", "45", "59.9", "60", "90", "121", "135", "150", "180"}) {
        const DecimalAngle angle(text);
        const Sign s = dihedral_angle(e, angle).sign;
        REQUIRE(dihedral_angle(swapped, angle).sign == s);    // law 1
        REQUIRE(dihedral_angle(scaled_up, angle).sign == s);  // law 2
        REQUIRE(dihedral_angle(mirrored, angle).sign == s);   // the other orientation
        REQUIRE(s <= before);                                 // law 3
        if (before == Sign::zero) REQUIRE(s == Sign::negative);
        before = s;
        if (angle.low() != angle.high()) REQUIRE(s != Sign::zero);  // law 4
      }
      REQUIRE(before != Sign::positive);  // law 5
      REQUIRE(dihedral_angle(e, DecimalAngle("0")).sign != Sign::negative);
    }
  }
}

TEST_CASE("decimal angles: texts, doubles around the squared cosine") {
  for (const char* text : {"0", "60", "060", "60.", ".5", "22.5", "180", "180.000", "0.0000"})
    CHECK_NOTHROW(DecimalAngle(text));
  for (const char* text : {"", ".", "6o", "-1", "+1", "1e1", "1,5", "1.2.3", " 1", "nan", "180.1",
                           "180.00000000000000000000000000000000000001", "400"})
    CHECK_THROWS_AS(DecimalAngle(text), std::invalid_argument);
  CHECK_THROWS_AS(DecimalAngle(std::string(101, '1')), std::invalid_argument);
  CHECK(DecimalAngle("060").degrees() == 60);
  CHECK(DecimalAngle("0.1").degrees() == 0.1);
  for (const char* text : kAngles) {
    const DecimalAngle angle(text);
    const double c = std::cos(angle.degrees() * 3.14159265358979323846 / 180);
    CHECK(angle.low() <= c * c + 1e-15);
    CHECK(angle.high() >= c * c - 1e-15);
    CHECK(angle.high() - angle.low() < 1e-15);
    CHECK(angle.cosine() == sign_of(90 - angle.degrees()));
  }
}
