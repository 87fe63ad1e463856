// SPDX-License-Identifier: GPL-3.0-or-later
// Signs of plane fields: the laws, ties, extreme sizes, depths of the formulas.
#include "kernel/predicates/planar_field.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "kernel/arithmetic/rational.hpp"
#include "tests/support/random.hpp"

using namespace crest::kernel;
using crest::tests::Random;

namespace {

/// Small integers, numbers of all sizes, and copies of one another: many ties.
double draw(Random& random) {
  const auto r = random();
  const double small = static_cast<double>(static_cast<int>(r % 7) - 3);
  switch (r / 7 % 4) {
    case 0:
      return small;
    case 1:
      return small * 0x1p-540;
    case 2:
      return small * 0x1p+520 / 3;
    default:
      return static_cast<double>(r >> 11) * 0x1p-53 - 0.5;
  }
}
Vec2 draw_vector(Random& random) {
  return {draw(random), draw(random)};
}

Sign exact_turn(const Vec2& a, const Vec2& b) {
  const Rational x = Rational(a[0]) * Rational(b[1]) - Rational(a[1]) * Rational(b[0]);
  return sign_of(x);
}

}  // namespace

TEST_CASE("Depths of the plane field's formulas") {
  CHECK(VectorTurn{}.value<Depth>().count <= VectorTurn::depth);
  CHECK(FieldTrace{}.value<Depth>().count <= FieldTrace::depth);
  CHECK(FieldDiscriminant{}.value<Depth>().count <= FieldDiscriminant::depth);
  CHECK(FlowAcross{}.value<Depth>().count <= FlowAcross::depth);
  CHECK(FlowAlong{}.value<Depth>().count <= FlowAlong::depth);
}

TEST_CASE("The turn of two vectors is the exact sign of their determinant, at every size") {
  Random random(1);
  int ties = 0, filtered = 0;
  const int n = static_cast<int>(20000 * crest::tests::multiplier());
  for (int i = 0; i < n; ++i) {
    const Vec2 a = draw_vector(random);
    Vec2 b = draw_vector(random);
    if (i % 5 == 0) b = {2 * a[0], 2 * a[1]};
    const Sign s = vector_turn(a, b);
    REQUIRE(s == exact_turn(a, b));
    REQUIRE(vector_turn(b, a) == -s);
    ties += s == Sign::zero;
    filtered += triage_vector_turn(a, b).has_value();
    // Nearly parallel: the rounded products are equal, their errors decide.
    const Vec2 c = {a[0], std::nextafter(a[1], 4.0)};
    REQUIRE(vector_turn(a, c) == exact_turn(a, c));
  }
  CHECK(ties > n / 20);
  CHECK(filtered > n / 2);
}

TEST_CASE("The symbolic turn is never zero and odd, and agrees with a displacement") {
  Random random(2);
  for (int i = 0; i < 5000; ++i) {
    const Vec2 a = {static_cast<double>(random() % 3) - 1, static_cast<double>(random() % 3) - 1};
    const Vec2 b = {static_cast<double>(random() % 3) - 1, static_cast<double>(random() % 3) - 1};
    const Sign s = symbolic_vector_turn(3, a, 8, b);
    REQUIRE(s != Sign::zero);
    REQUIRE(symbolic_vector_turn(8, b, 3, a) == -s);
    // The lower number is displaced more: x_i by e^?, y_i by far more, those of j far less.
    const double e = 1e-2;
    const Vec2 da = {a[0] + e * e, a[1] + e}, db = {b[0] + e * e * e * e * e, b[1] + e * e * e * e};
    const Sign displaced = exact_turn(da, db);
    if (exact_turn(a, b) != Sign::zero) REQUIRE(displaced == s);
    if (exact_turn(a, b) == Sign::zero && b[0] != 0) REQUIRE(displaced == s);
  }
}

TEST_CASE("Class of a zero: independent of the corners' order") {
  Random random(3);
  const auto number = [&] { return static_cast<double>(random() % 9) - 4; };
  for (int i = 0; i < 3000; ++i) {
    FieldOnTriangle t;
    for (std::size_t k = 0; k < 3; ++k) {
      t.p[k] = {number(), number()};
      t.v[k] = {number(), number()};
    }
    if (orientation(t.p[0], t.p[1], t.p[2]) != Sign::positive) continue;
    const Sign trace = trace_sign(t), discriminant = field_discriminant_sign(t);
    for (int turn = 0; turn < 2; ++turn) {
      std::rotate(t.p.begin(), t.p.begin() + 1, t.p.end());
      std::rotate(t.v.begin(), t.v.begin() + 1, t.v.end());
      REQUIRE(trace_sign(t) == trace);
      REQUIRE(field_discriminant_sign(t) == discriminant);
    }
    REQUIRE(flow_across(t.p[0], t.p[1], t.v[2]) == -flow_across(t.p[1], t.p[0], t.v[2]));
  }
  // v = J x for J = ((a, b), (c, d)) on the corners of a square's half.
  const auto linear = [](double a, double b, double c, double d) {
    return FieldOnTriangle{{{{0, 0}, {1, 0}, {0, 1}}}, {{{0, 0}, {a, c}, {b, d}}}};
  };
  CHECK(trace_sign(linear(1, 0, 0, -1)) == Sign::zero);
  CHECK(field_discriminant_sign(linear(1, 0, 0, 1)) == Sign::zero);
  CHECK(field_discriminant_sign(linear(-1, -2, 2, -1)) == Sign::negative);
  CHECK(field_discriminant_sign(linear(1, 0, 0, -1)) == Sign::positive);
  CHECK(trace_sign(linear(-1, -2, 2, -1)) == Sign::negative);
}
