// SPDX-License-Identifier: GPL-3.0-or-later
// Critical values as integer keys where the nodal values are few steps of a power of two, and the
// normal form of their data.
#include "kernel/predicates/critical_value_grid.hpp"

#include <algorithm>
#include <limits>

#include "kernel/predicates/face_critical.hpp"
#include "kernel/predicates/line_critical.hpp"
#include "tests/kernel/ladder_checks.hpp"

using namespace crest::kernel;
using namespace crest::tests;

namespace {

/// Whole numbers of steps; draws reach both ends often.
struct Steps {
  Draw d;
  int largest;
  double unit = 1, offset = 0;
  double operator()() {
    const int kind = d.integer(0, 3);
    const int step = kind == 0 ? 0 : kind == 1 ? largest : d.integer(0, largest);
    return offset + unit * step;
  }
};

CriticalValue draw_value(Steps& step) {
  for (;;) {
    const int kind = step.d.integer(0, 4);
    if (kind == 0) return CriticalValue::vertex(step());
    if (kind == 1) {
      const EdgeValues e = {step(), step(), step()};
      if (const Sign s = line_critical(e).sign; s != Sign::zero) return CriticalValue::edge(e, s);
      continue;
    }
    const FaceValues f = {{step(), step(), step()}, {step(), step(), step()}};
    if (const Sign s = face_critical(f).sign; s != Sign::zero) return CriticalValue::face(f, s);
  }
}

Rational exact_value(const CriticalValue& v) {
  const auto at = [&](const auto& q) -> Rational {
    return Rational(v.f.corner[0]) + q.numerator / q.denominator;
  };
  if (v.kind == ValueKind::vertex) return v.f.corner[0];
  return v.kind == ValueKind::edge ? at(ValueFraction<Rational, ValueKind::edge>(v.f))
                                   : at(ValueFraction<Rational, ValueKind::face>(v.f));
}

std::optional<ValueGrid> grid_of(const Steps& step) {
  const double ends[] = {step.offset, step.offset + step.unit * step.largest,
                         step.offset + step.unit};
  return ValueGrid::find(ends);
}

struct Keyed {
  CriticalValue node;
  Rational value;
  std::uint64_t key;
};

/// How often successive values are equal; requires law 1.
std::size_t require_law_1(std::vector<Keyed> all) {
  std::sort(all.begin(), all.end(),
            [](const Keyed& x, const Keyed& y) { return x.value < y.value; });
  std::size_t ties = 0;
  for (std::size_t i = 1; i < all.size(); ++i) {
    const bool equal = all[i].value == all[i - 1].value;
    ties += equal;
    const OnFailure shown([&] { return "values " + in_braces(all[i - 1].node, all[i].node); });
    REQUIRE((equal ? all[i].key == all[i - 1].key : all[i].key > all[i - 1].key));
  }
  return ties;
}

}  // namespace

TEST_CASE("values on a grid: law 1, keys order as rationals do") {
  std::size_t ties = 0;
  for (const int largest : {1, 2, 3, 4, 5, 15, 16, 255, 256, 1000, 1023, 1024})
    for (const double unit : {1.0, 0x1p-4, 0x1p-1000, 0x1p-990, 0x1p880}) {
      CAPTURE(largest, unit);
      Steps step{Draw(560), largest, unit, -7 * unit};
      const auto grid = grid_of(step);
      REQUIRE(grid);
      std::vector<Keyed> all;
      for (std::uint64_t i = 0; i < scaled(1000); ++i) {
        const CriticalValue v = draw_value(step);
        all.push_back({v, exact_value(v), grid->key(v)});
      }
      ties += require_law_1(std::move(all));
    }
  CHECK(ties > 10000);
}

TEST_CASE("values on a grid: all edges and many faces of a small one, all pairs") {
  for (const int largest : {1, 2, 3, 7}) {
    Steps step{Draw(561), largest};
    const ValueGrid grid = *grid_of(step);
    std::vector<Keyed> all;
    const auto add = [&](const CriticalValue& v) {
      all.push_back({v, exact_value(v), grid.key(v)});
    };
    for (int a = 0; a <= largest; ++a)
      for (int b = 0; b <= largest; ++b)
        for (int m = 0; m <= largest; ++m) {
          const EdgeValues e = {double(a), double(b), double(m)};
          if (const Sign s = line_critical(e).sign; s != Sign::zero) add(CriticalValue::edge(e, s));
        }
    for (std::uint64_t i = 0; i < scaled(20000); ++i) add(draw_value(step));
    CHECK(require_law_1(std::move(all)) > 10000);
  }
}

TEST_CASE("values on a grid: law 2, shifts and scales") {
  for (std::uint64_t i = 0; i < scaled(2000); ++i) {
    Steps at_zero{Draw(562 + i), 1000}, elsewhere{Draw(562 + i), 1000, 0x1p-20, 12345.0};
    const CriticalValue x = draw_value(at_zero), y = draw_value(elsewhere);
    const OnFailure shown([&] { return "values " + in_braces(x, y); });
    REQUIRE(x.kind == y.kind);
    REQUIRE(grid_of(at_zero)->key(x) == grid_of(elsewhere)->key(y));
  }
}

TEST_CASE("values on a grid: which values are on one") {
  using Values = std::vector<double>;
  const auto is_grid = [](const Values& x) { return ValueGrid::find(x).has_value(); };
  CHECK(is_grid({0, 0, 0}));
  CHECK(is_grid({0.1, 0.1}));
  CHECK(is_grid({0, 1024}));
  CHECK_FALSE(is_grid({0, 1, 1025}));
  CHECK_FALSE(is_grid({1025, 1, 0}));
  CHECK(is_grid({0, 2, 2048}));
  CHECK_FALSE(is_grid({0, 2, 2048, 3}));
  CHECK(is_grid({1e15, 1e15 + 0.125, 1e15 + 128}));
  CHECK_FALSE(is_grid({1e15, 1e15 + 0.125, 1e15 + 128.125}));
  CHECK_FALSE(is_grid({0.1, 0.2, 0.3}));
  CHECK(is_grid({0, 0x1p-1000}));
  CHECK_FALSE(is_grid({0, 0x1p-1001}));
  CHECK_FALSE(is_grid({0, std::numeric_limits<double>::denorm_min()}));
  CHECK(is_grid({0x1p900, 0x1p910}));
  CHECK(is_grid({0x1p909, 0x1p910}));
  CHECK_FALSE(is_grid({-0x1p1023, 0x1p1023}));  // the range is no double
  const Values a = {0, 1}, b = {1024}, c = {1025};
  CHECK(ValueGrid::find(a, b));
  CHECK_FALSE(ValueGrid::find(a, c));
}

TEST_CASE("critical values: the normal form does not depend on the corners' order") {
  std::size_t faces = 0;
  for (const Family family : kFamilies) {
    Draw d(570, family);
    const auto normal = [](const CriticalValue& v) { return normal_form(v).f; };
    for (std::uint64_t i = 0; i < scaled(500); ++i) {
      const double a = draw(d, family), b = draw(d, family), m = draw(d, family);
      const FaceValues edge = normal(CriticalValue::edge({a, b, m}, Sign::positive));
      REQUIRE(edge == normal(CriticalValue::edge({b, a, m}, Sign::positive)));
      if (a != m) REQUIRE(edge != normal(CriticalValue::edge({b, m, a}, Sign::positive)));
      FaceValues f;
      for (double& x : f.corner) x = draw(d, family);
      for (double& x : f.side) x = draw(d, family);
      const Sign s = face_critical(f).sign;
      if (s == Sign::zero) continue;
      ++faces;
      const OnFailure shown([&] { return "face " + in_words(f); });
      const CriticalValue v = CriticalValue::face(f, s);
      for (const FaceValues& g : {f.rotated(1), f.rotated(2), f.mirrored(), f.rotated(1).mirrored(),
                                  f.rotated(2).mirrored()})
        REQUIRE(normal(v) == normal(CriticalValue::face(g, s)));
      REQUIRE(exact_value(v) == exact_value(normal_form(v)));
      FaceValues other = f;
      other.side[0] = other.side[0] == 0 ? 1 : 0;
      REQUIRE(normal(v) != normal(CriticalValue::face(other, s)));
    }
  }
  CHECK(faces > 100);
  CHECK(normal_form(CriticalValue::edge({-0.0, 1, 2}, Sign::negative)).f ==
        normal_form(CriticalValue::edge({1, 0.0, 2}, Sign::negative)).f);
}
