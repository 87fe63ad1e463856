// SPDX-License-Identifier: GPL-3.0-or-later
// Which C1 conditions cubic splines in normal form satisfy, in rationals.
#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "algorithms/splines/cubic_extension.hpp"
#include "algorithms/splines/cubic_net.hpp"
#include "algorithms/splines/integer_march.hpp"
#include "algorithms/splines/normal_form.hpp"
#include "algorithms/splines/sine_projection.hpp"
#include "algorithms/splines/smoothness_conditions.hpp"
#include "kernel/arithmetic/rational.hpp"
#include "kernel/geometry/input_error.hpp"
#include "tests/support/random.hpp"

using namespace crest;
using namespace crest::splines;
using namespace crest::tests;
using kernel::Rational;
using splines::CubicModel;
using splines::Domain;
using splines::Place;

namespace {

/// Random integers everywhere.
CubicModel random_model(const std::array<kernel::Index, 3>& cubes, std::uint64_t seed) {
  Random random(seed);
  const auto draw = [&] { return static_cast<double>(static_cast<int>(random() % 2001) - 1000); };
  CubicModel model = splines::make_model({{0, 0, 0}, {1, 1, 1}, cubes});
  auto vertices = cubes;
  for (auto& n : vertices) ++n;
  splines::for_each_place(vertices, [&](const Place& v) {
    for (double& x : model.vertices[model.domain.vertex(v)]) x = draw();
    for (std::size_t a = 0; a < 3; ++a)
      if (v[a] < static_cast<int>(cubes[a]))
        for (std::size_t i = 0; i < 2; ++i)
          model.slopes[model.domain.vertex(v)][2 * a + i] = draw();
  });
  for (auto& centre : model.centres)
    for (double& x : centre) x = draw();
  return model;
}

template <std::size_t N>
std::array<Rational, N> exact(const std::array<double, N>& numbers) {
  std::array<Rational, N> r;
  for (std::size_t i = 0; i < N; ++i) r[i] = Rational(numbers[i]);
  return r;
}

/// All coefficients, by the sums of their letters; fails where tetrahedra disagree on one.
std::map<Lattice, Rational> coefficients(const CubicModel& model) {
  std::map<Lattice, Rational> all;
  std::size_t disagree = 0;
  splines::for_each_place(model.domain.cubes, [&](const Place& cube) {
    const auto at = [&](const std::array<std::size_t, 3>& c) {
      return model.domain.vertex(splines::corner_of(cube, c[0] | c[1] << 1 | c[2] << 2));
    };
    const Lattice centre{2 * cube[0] + 1, 2 * cube[1] + 1, 2 * cube[2] + 1};
    for (std::size_t t = 0; t < splines::kTetrahedra; ++t) {
      const auto net = splines::cubic_net<Rational>(
          t, [&](const auto& c) { return exact(model.vertices[at(c)]); },
          [&](const auto& c) { return exact(model.slopes[at(c)]); },
          exact(model.centres[model.domain.cube(cube)]));
      for (std::size_t i = 0; i < net.c.size(); ++i) {
        const Lattice p = times(3, centre) + splines::kDomainPoints<3>[t][i];
        const auto [entry, is_new] = all.try_emplace(p, net.c[i]);
        disagree += is_new || entry->second == net.c[i] ? 0 : 1;
      }
    }
  });
  CHECK(disagree == 0);
  return all;
}

/// r at a corner of a cube.
Rational residual(const CubicModel& model, const Place& cube, std::size_t corner) {
  splines::CubeNumbers<Rational> q;
  for (std::size_t c = 0; c < 8; ++c) {
    const auto v = exact(model.vertices[model.domain.vertex(splines::corner_of(cube, c))]);
    q.f[c] = v[0];
    for (std::size_t d = 0; d < 3; ++d) q.h[c][d] = v[d + 1] / 2;
  }
  for (std::size_t e = 0; e < 12; ++e) {
    const auto t = exact(
        model.slopes[model.domain.vertex(splines::corner_of(cube, splines::lower_corner(e)))]);
    q.t[e] = {t[e / 4 * 2], t[e / 4 * 2 + 1]};
  }
  return splines::eightfold_residual(exact(model.centres[model.domain.cube(cube)]),
                                     splines::fourfold_targets(q), corner) /
         8;
}

/// Conditions per junction and word: how many there are, and how many fail.
using Count = std::map<std::pair<Junction, std::array<int, 4>>, std::array<std::size_t, 2>>;

Count count_failures(const CubicModel& model, std::size_t& unexplained) {
  const auto all = coefficients(model);
  std::array<int, 3> n;
  for (std::size_t d = 0; d < 3; ++d) n[d] = static_cast<int>(model.domain.cubes[d]);
  Count count;
  unexplained = 0;
  for_each_condition(n, 3, [&](const Condition& c) {
    Rational sum = 0;
    for (const auto& term : c.terms) sum += term.factor * all.at(term.at);
    auto& entry = count[{c.junction, c.letters}];
    ++entry[0];
    if (sum == 0) return;
    ++entry[1];
    // Across [A, B, C], with word AC: a(ACu) + a(ACv) - a(ACC) - (a(ACA) + a(ACB)) / 2 = -r(A),
    // here twice. The corner is the word less the centre.
    if (c.junction != Junction::inter_pyramid || c.letters[splines::kC] != 1) {
      ++unexplained;
      return;
    }
    std::size_t corner = 0;
    for (std::size_t d = 0; d < 3; ++d)
      if (c.word[d] - (2 * c.cube[d] + 1) > 2 * c.cube[d] + 1) corner |= std::size_t{1} << d;
    if (sum != -2 * residual(model, c.cube, corner)) ++unexplained;
  });
  return count;
}

}  // namespace

TEST_CASE("in normal form only the inter-pyramid conditions with one C may fail, each by r") {
  for (const auto& cubes : {std::array<kernel::Index, 3>{2, 2, 2}, {3, 3, 3}, {1, 2, 3}}) {
    const CubicModel model = random_model(cubes, kSeed);
    std::size_t unexplained;
    std::size_t failures = 0;
    for (const auto& [kind, numbers] : count_failures(model, unexplained)) {
      const auto& [junction, letters] = kind;
      const bool may_fail = junction == Junction::inter_pyramid && letters[splines::kC] == 1;
      CAPTURE(static_cast<int>(junction), letters);
      CHECK(numbers[0] > 0);
      if (may_fail)
        failures += numbers[1];
      else
        CHECK(numbers[1] == 0);
    }
    CHECK(unexplained == 0);
    // Random numbers: all 24 conditions with one C of each cube fail.
    CHECK(failures == 24 * model.domain.cube_count());
  }
}

TEST_CASE("2 x 2 x 2 cubes have 576, 1152 and 576 conditions of the three kinds") {
  // Inter-cube ones across 12 inner faces of 4 triangles, the others 24 and 12 triangles a cube;
  // six words each.
  std::map<Junction, std::size_t> count;
  for_each_condition({2, 2, 2}, 3, [&](const Condition& c) { ++count[c.junction]; });
  CHECK(count[Junction::inter_cube] == 12 * 4 * 6);
  CHECK(count[Junction::intra_pyramid] == 8 * 24 * 6);
  CHECK(count[Junction::inter_pyramid] == 8 * 12 * 6);
}

TEST_CASE("after projection and march all C1 conditions hold in rationals") {
  for (const auto& cubes :
       {std::array<kernel::Index, 3>{1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {1, 4, 2}}) {
    CubicModel model = random_model(cubes, kSeed + 1);
    splines::project_to_c1(model);
    splines::march_to_c1(model);
    std::size_t unexplained;
    for (const auto& [kind, numbers] : count_failures(model, unexplained)) CHECK(numbers[1] == 0);
  }
}

TEST_CASE("units of the march: multiples and bounds of every number") {
  for (const double scale : {1.0, 0x1p-900, 0x1p900, 3e-7}) {
    CubicModel model = random_model({4, 3, 5}, kSeed + 2);
    for (auto& v : model.vertices)
      for (double& x : v) x *= scale;
    for (auto& t : model.slopes)
      for (double& x : t) x *= scale;
    splines::project_to_c1(model);
    splines::march_to_c1(model);
    REQUIRE(model.unit > 0);
    std::size_t wrong = 0;
    const auto check = [&](double x, double unit) {
      const double multiple = x / unit;
      wrong += multiple == std::floor(multiple) && std::fabs(multiple) < 0x1p53 ? 0 : 1;
    };
    for (const auto& v : model.vertices)
      for (std::size_t i = 0; i < 4; ++i) check(v[i], (i == 0 ? 1 : 2) * model.unit);
    for (const auto& t : model.slopes)
      for (const double x : t) check(x, model.unit);
    for (const auto& c : model.centres)
      for (std::size_t i = 0; i < 4; ++i) check(c[i], model.unit / (i == 0 ? 8 : 4));
    CHECK(wrong == 0);
  }
}

TEST_CASE("centres need eighths and quarters of the unit") {
  CubicModel model = random_model({3, 3, 3}, kSeed + 3);
  splines::project_to_c1(model);
  splines::march_to_c1(model);
  std::size_t eighths = 0, quarters = 0;
  for (const auto& c : model.centres) {
    const double f = c[0] / model.unit * 4, g = c[1] / model.unit * 2;
    eighths += f != std::floor(f) ? 1 : 0;
    quarters += g != std::floor(g) ? 1 : 0;
  }
  CHECK(eighths > 0);
  CHECK(quarters > 0);
}

TEST_CASE("a spline of zeros is marched with unit 2^-46") {
  CubicModel model = splines::make_model({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}});
  splines::march_to_c1(model);
  CHECK(model.unit == 0x1p-46);
  for (const auto& c : model.centres) CHECK(c == splines::ValueAndSlope{});
}

TEST_CASE("the march refuses numbers out of its range") {
  for (const double x : {0x1p1001, 0x1p-1020, HUGE_VAL, std::nan("")}) {
    CubicModel model = splines::make_model({{0, 0, 0}, {1, 1, 1}, {1, 1, 1}});
    model.vertices[3][0] = x;
    CHECK_THROWS_AS(splines::march_to_c1(model), kernel::InputError);
  }
}

TEST_CASE("the projection changes nothing twice and is orthogonal to all it keeps") {
  const CubicModel before = random_model({4, 3, 5}, kSeed + 4);
  CubicModel after = before, kept = random_model({4, 3, 5}, kSeed + 5);
  splines::project_to_c1(after);
  splines::project_to_c1(kept);
  CubicModel again = after;
  splines::project_to_c1(again);
  double product = 0, change = 0, second = 0;
  for (std::size_t v = 0; v < before.vertices.size(); ++v)
    for (std::size_t i = 0; i < 4; ++i) {
      const double d = after.vertices[v][i] - before.vertices[v][i];
      change += d * d;
      product += d * kept.vertices[v][i];
      second = std::max(second, std::fabs(again.vertices[v][i] - after.vertices[v][i]));
    }
  CHECK(change > 1e6);
  CHECK(std::fabs(product) < 1e-9 * change);
  CHECK(second < 1e-9);
  // Slopes: their equations are not homogeneous, so the difference of two solutions is kept.
  double slopes = 0;
  CubicModel other = before;
  for (auto& t : other.slopes)
    for (double& x : t) x = -x;
  splines::project_to_c1(other);
  double slope_change = 0;
  for (std::size_t v = 0; v < before.slopes.size(); ++v)
    for (std::size_t i = 0; i < 6; ++i) {
      const double d = after.slopes[v][i] - before.slopes[v][i];
      slope_change += d * d;
      slopes += d * (after.slopes[v][i] - other.slopes[v][i]);
    }
  CHECK(slope_change > 1e6);
  CHECK(std::fabs(slopes) < 1e-9 * slope_change);
}
