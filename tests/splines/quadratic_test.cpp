// SPDX-License-Identifier: GPL-3.0-or-later
// Quadratic super splines: coefficients against the paper's equations and the table of weights,
// which conditions hold, what is reproduced, the largest jump of the gradient.
#include "algorithms/splines/quadratic.hpp"

#include <catch2/catch.hpp>
#include <map>

#include "algorithms/splines/smoothness_conditions.hpp"
#include "kernel/arithmetic/rational.hpp"
#include "kernel/geometry/input_error.hpp"
#include "tests/splines/volumes.hpp"
#include "tests/support/failures.hpp"

using namespace crest;
using namespace crest::splines;
using namespace crest::tests;
using kernel::Rational;
using splines::CubeCoefficients;
using splines::Stencil;

namespace {

std::size_t slot(const Lattice& p) {
  return static_cast<std::size_t>(p[0] + 5 * p[1] + 25 * p[2]);
}

/// All 65 places: the sums of two letters.
std::vector<Lattice> places() {
  std::map<Lattice, int> all;
  for (const auto& points : splines::kDomainPoints<2>)
    for (const Lattice& p : points) ++all[p + Lattice{2, 2, 2}];
  std::vector<Lattice> list;
  for (const auto& [p, count] : all) list.push_back(p);
  return list;
}

/// 128 times the weight of the sample at `offset` in the coefficient at p: the table of weights,
/// moved to the octant of p.
int table_weight(const Lattice& p, const Lattice& offset) {
  std::array<int, 3> side, u;  // which half of the cube, and the offset as seen from there
  for (std::size_t k = 0; k < 3; ++k) {
    side[k] = p[k] < 2 ? -1 : 1;
    u[k] = side[k] * offset[k];
  }
  std::vector<int> middle, outer, inner;  // axes with coordinate 2; 0 or 4; 1 or 3
  for (int k = 0; k < 3; ++k) {
    const int x = p[static_cast<std::size_t>(k)];
    (x == 2 ? middle : x % 4 == 0 ? outer : inner).push_back(k);
  }
  const auto at = [&](const std::vector<int>& axes, std::size_t i) {
    return u[static_cast<std::size_t>(axes[i])];
  };
  const auto in_octant = [&](const std::vector<int>& axes) {
    for (std::size_t i = 0; i < axes.size(); ++i)
      if (at(axes, i) < 0) return false;
    return true;
  };
  const int ones = std::abs(u[0]) + std::abs(u[1]) + std::abs(u[2]);
  if (outer.size() == 3) return in_octant(outer) ? 16 : 0;
  if (outer.size() == 2 && middle.size() == 1)
    return in_octant(outer) && at(middle, 0) == 0 ? 32 : 0;
  if (outer.size() == 1 && inner.size() == 2) {  // a_m
    if (!in_octant(outer) || !in_octant(inner)) return 0;
    const int sum = at(inner, 0) + at(inner, 1);
    return sum == 0 ? 32 : sum == 1 ? 16 : 0;
  }
  if (outer.size() == 1) {  // a_d
    if (!in_octant(outer)) return 0;
    const int sum = std::abs(at(middle, 0)) + std::abs(at(middle, 1));
    return sum == 0 ? 32 : sum == 1 ? 8 : 0;
  }
  if (inner.size() == 3)
    return in_octant(inner) ? std::array{40, 24, 8, -8}[static_cast<std::size_t>(ones)] : 0;
  if (inner.size() == 1) {  // a_g
    const auto sum = static_cast<std::size_t>(std::abs(at(middle, 0)) + std::abs(at(middle, 1)));
    if (at(inner, 0) < 0) return 0;
    return at(inner, 0) == 0 ? std::array{40, 12, 2}[sum] : std::array{24, 4, -2}[sum];
  }
  return std::array{40, 12, 2, -1}[static_cast<std::size_t>(ones)];
}

/// The equations as the paper prints them, from means of means.
CubeCoefficients<Rational> of_the_paper(const Stencil<Rational>& f) {
  CubeCoefficients<Rational> a;
  const auto sample = [&](int x, int y, int z) -> const Rational& {
    return f[static_cast<std::size_t>(13 + x + 3 * y + 9 * z)];
  };
  const auto at = [&](int x, int y, int z) -> Rational& { return a[slot({x, y, z})]; };
  const Rational half(0.5), quarter(0.25);
  for (const int s : {-1, 1})
    for (const int t : {-1, 1}) {
      const int p = 2 + 2 * s, q = 2 + 2 * t;
      at(2, p, q) =
          quarter * (sample(0, 0, 0) + sample(0, s, 0) + sample(0, 0, t) + sample(0, s, t));
      at(p, 2, q) =
          quarter * (sample(0, 0, 0) + sample(s, 0, 0) + sample(0, 0, t) + sample(s, 0, t));
      at(p, q, 2) =
          quarter * (sample(0, 0, 0) + sample(s, 0, 0) + sample(0, t, 0) + sample(s, t, 0));
      for (const int r : {-1, 1}) {
        Rational sum = 0;
        for (int i = 0; i < 8; ++i) sum += sample(i & 1 ? s : 0, i & 2 ? t : 0, i & 4 ? r : 0);
        at(p, q, 2 + 2 * r) = sum / 8;
      }
    }
  for (const int x : {0, 4})
    for (const int y : {0, 4})
      for (const int z : {0, 4}) {
        const int mx = (x + 2) / 2, my = (y + 2) / 2, mz = (z + 2) / 2;
        at(mx, my, z) = half * (at(2, y, z) + at(x, 2, z));
        at(mx, y, mz) = half * (at(2, y, z) + at(x, y, 2));
        at(x, my, mz) = half * (at(x, 2, z) + at(x, y, 2));
        // e: the edge along x, with the faces across z and y.
        at(mx, my, mz) = at(mx, my, z) + at(mx, y, mz) - half * (at(x, y, z) + at(2, y, z));
      }
  for (const int s : {0, 4}) {
    at(2, 2, s) = half * (at(1, 1, s) + at(3, 3, s));
    at(2, s, 2) = half * (at(1, s, 3) + at(3, s, 1));
    at(s, 2, 2) = half * (at(s, 1, 1) + at(s, 3, 3));
    const int g = (s + 2) / 2;
    at(2, 2, g) = quarter * (at(1, 1, g) + at(1, 3, g) + at(3, 1, g) + at(3, 3, g));
    at(2, g, 2) = quarter * (at(1, g, 1) + at(1, g, 3) + at(3, g, 1) + at(3, g, 3));
    at(g, 2, 2) = quarter * (at(g, 1, 1) + at(g, 1, 3) + at(g, 3, 1) + at(g, 3, 3));
  }
  Rational faces = 0, corners = 0;
  for (const int g : {1, 3}) faces += at(2, 2, g) + at(2, g, 2) + at(g, 2, 2);
  for (int i = 0; i < 8; ++i) corners += at(i & 1 ? 3 : 1, i & 2 ? 3 : 1, i & 4 ? 3 : 1);
  at(2, 2, 2) = faces / 3 - corners / 8;
  return a;
}

Stencil<Rational> random_stencil(Random& random) {
  Stencil<Rational> f;
  for (Rational& x : f) x = static_cast<int>(random() % 65536) - 32768;
  return f;
}

/// All coefficients of a spline, by lattice sums; fails where cubes disagree.
std::map<Lattice, Rational> all_coefficients(const splines::QuadraticSpline& spline) {
  std::map<Lattice, Rational> all;
  std::size_t disagree = 0;
  const auto& n = spline.cubes();
  for (int z = 0; z < n[2]; ++z)
    for (int y = 0; y < n[1]; ++y)
      for (int x = 0; x < n[0]; ++x) {
        const auto a = splines::cube_coefficients(spline.stencil<Rational>({x, y, z}));
        for (const Lattice& p : places()) {
          const auto [at, fresh] = all.try_emplace(p + Lattice{4 * x, 4 * y, 4 * z}, a[slot(p)]);
          disagree += !fresh && at->second != a[slot(p)];
        }
      }
  CHECK(disagree == 0);
  return all;
}

}  // namespace

TEST_CASE("coefficients are those of equations 8.1 to 8.5, and of the table of weights") {
  Random random(kSeed);
  Failures failures;
  for (std::uint64_t i = 0; i < scaled(50); ++i) {
    const auto f = random_stencil(random);
    const auto a = splines::cube_coefficients(f), paper = of_the_paper(f);
    Stencil<double> rounded;
    for (std::size_t k = 0; k < 27; ++k) rounded[k] = static_cast<double>(f[k]);
    const auto doubles = splines::cube_coefficients(rounded);
    for (const Lattice& p : places()) {
      Rational sum = 0;
      for (int k = 0; k < 27; ++k)
        sum +=
            table_weight(p, {k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1}) * f[static_cast<std::size_t>(k)];
      failures.expect(a[slot(p)] == paper[slot(p)], "as printed", p[0], p[1], p[2]);
      failures.expect(a[slot(p)] == sum / 128, "as the table says", p[0], p[1], p[2]);
      failures.expect(Rational(doubles[slot(p)]) == a[slot(p)], "exact in doubles", p[0], p[1],
                      p[2]);
    }
  }
  CHECK(failures.report() == "");
  CHECK(places().size() == 65);
}

TEST_CASE("the weights sum to 1, their magnitudes to at most 9/8, attained at the centre") {
  int largest = 0;
  for (const Lattice& p : places()) {
    int sum = 0, magnitudes = 0;
    for (int k = 0; k < 27; ++k) {
      const int w = table_weight(p, {k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1});
      sum += w;
      magnitudes += std::abs(w);
    }
    CHECK(sum == 128);
    largest = std::max(largest, magnitudes);
    if (p == Lattice{2, 2, 2}) CHECK(magnitudes == 144);
  }
  CHECK(largest == 144);
}

TEST_CASE("the 48 motions of the cube carry coefficients into coefficients") {
  Random random(kSeed + 1);
  const auto f = random_stencil(random);
  const auto a = splines::cube_coefficients(f);
  std::array<std::size_t, 3> axes = {0, 1, 2};
  std::size_t motions = 0, wrong = 0;
  do
    for (int flips = 0; flips < 8; ++flips, ++motions) {
      const auto moved = [&](const Lattice& p, int middle) {
        Lattice q;
        for (std::size_t k = 0; k < 3; ++k)
          q[k] = flips >> k & 1 ? 2 * middle - p[axes[k]] : p[axes[k]];
        return q;
      };
      Stencil<Rational> g;
      for (int k = 0; k < 27; ++k) {
        const Lattice q = moved({k % 3, k / 3 % 3, k / 9}, 1);
        g[static_cast<std::size_t>(q[0] + 3 * q[1] + 9 * q[2])] = f[static_cast<std::size_t>(k)];
      }
      const auto b = splines::cube_coefficients(g);
      for (const Lattice& p : places()) wrong += a[slot(p)] != b[slot(moved(p, 2))];
    }
  while (std::next_permutation(axes.begin(), axes.end()));
  CHECK(motions == 48);
  CHECK(wrong == 0);
}

TEST_CASE("all C1 conditions hold but those with the word C, and these fail by what is reported") {
  for (const std::size_t n : {4, 5}) {
    const splines::QuadraticSpline spline(random_volume<std::int16_t>({n, n, n}, 30000, kSeed + n));
    const auto a = all_coefficients(spline);
    std::map<std::pair<Junction, bool>, std::array<std::size_t, 2>> count;  // all, failed
    Rational largest = 0;  // of squares, index units
    const int cubes = static_cast<int>(n) - 2;
    for_each_condition({cubes, cubes, cubes}, 2, [&](const Condition& c) {
      Rational sum = 0;
      for (const auto& term : c.terms) sum += term.factor * a.at(term.at);
      auto& [all, failed] = count[{c.junction, c.letters[splines::kC] > 0}];
      ++all;
      failed += sum != 0;
      // 2 |r| |grad l|: factors 2 sqrt 2 and 2 (2 sqrt 2), the latter's r being half the sum.
      if (sum != 0) largest = std::max(largest, Rational(8 * sum * sum));
    });
    const auto all = [&](Junction j, bool c) { return count[{j, c}][0]; };
    const auto failed = [&](Junction j, bool c) { return count[{j, c}][1]; };
    CHECK(failed(Junction::inter_cube, false) == 0);
    CHECK(failed(Junction::intra_pyramid, false) == 0);
    CHECK(failed(Junction::inter_pyramid, false) == 0);
    CHECK(all(Junction::inter_cube, true) == 0);
    const auto volume = static_cast<std::size_t>(cubes * cubes * cubes);
    CHECK(all(Junction::intra_pyramid, true) == 24 * volume);
    CHECK(all(Junction::inter_pyramid, true) == 12 * volume);
    CHECK(failed(Junction::intra_pyramid, true) > 20 * volume);
    CHECK(failed(Junction::inter_pyramid, true) > 10 * volume);
    const double jump = splines::summarise(spline).gradient_jump;
    CHECK(Rational(jump) * Rational(jump) >= largest);
    CHECK(Rational(jump) * Rational(jump) <= largest * Rational(1 + 0x1p-40));
  }
}

TEST_CASE("quadratic polynomials are reproduced up to a constant") {
  // Samples at integers: 1, x, y, z, xy, xz, yz, x^2, y^2, z^2.
  const auto value = [](int k, const std::array<Rational, 3>& p) -> Rational {
    const std::array<Rational, 10> all = {1,           p[0],        p[1],        p[2],
                                          p[0] * p[1], p[0] * p[2], p[1] * p[2], p[0] * p[0],
                                          p[1] * p[1], p[2] * p[2]};
    return all[static_cast<std::size_t>(k)];
  };
  for (int k = 0; k < 10; ++k) {
    Stencil<Rational> f;
    for (int i = 0; i < 27; ++i)
      f[static_cast<std::size_t>(i)] = value(k, {i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1});
    const auto a = splines::cube_coefficients(f);
    for (std::size_t t = 0; t < splines::kTetrahedra; ++t) {
      const auto net = splines::tetrahedron_net(a, t);
      for (int i = 0; i < 20; ++i) {
        const std::array<Rational, 3> lattice = {Rational(i % 5, 7), Rational(i % 3 - 1, 3),
                                                 Rational(i - 10, 11)};
        const std::array<Rational, 3> p = {lattice[0] / 2, lattice[1] / 2, lattice[2] / 2};
        const Rational s = kernel::value_at(net, splines::barycentric(t, lattice));
        CHECK(s == value(k, p) + (k >= 7 ? Rational(1, 4) : Rational(0)));
      }
    }
  }
}

TEST_CASE("values and gradients of an exact quadratic, in a turned frame of unequal spacings") {
  SampledGrid grid;
  grid.size = {6, 5, 7};
  grid.spacing = {0.5, 2, 1.25};
  grid.origin = {3, -1, 2};
  grid.directions = {{{0.6, 0.8, 0}, {-0.8, 0.6, 0}, {0, 0, -1}}};
  // 3 + x - 2 y + 4 z + x y of the world.
  const auto f = [](const Vec3& p) { return 3 + p[0] - 2 * p[1] + 4 * p[2] + p[0] * p[1]; };
  std::vector<double> samples;
  for (int z = 0; z < 7; ++z)
    for (int y = 0; y < 5; ++y)
      for (int x = 0; x < 6; ++x) samples.push_back(f(grid.to_world({0.5 * x, 2.0 * y, 1.25 * z})));
  grid.samples = samples;
  // x y of the world has squares of the grid's coordinates: a constant more.
  const double constant = 0.25 * (0.6 * 0.8 * 0.25 - 0.6 * 0.8 * 4);
  for (const splines::Border border : {splines::Border::none, splines::Border::extend}) {
    const splines::QuadraticSpline spline(grid, border);
    const double margin = border == splines::Border::none ? 0.52 : 1;
    for (int i = 0; i < 30; ++i) {
      const Vec3 own = {0.5 * (margin + 0.08 * i), 2 * (margin + 0.05 * i),
                        1.25 * (margin + 0.09 * i)};
      const Vec3 p = grid.to_world(own);
      const auto s = spline.evaluate(p);
      CHECK(s.value == Approx(f(p) + constant).epsilon(1e-12));
      CHECK(s.gradient[0] == Approx(1 + p[1]).margin(1e-11));
      CHECK(s.gradient[1] == Approx(p[0] - 2).margin(1e-11));
      CHECK(s.gradient[2] == Approx(4).margin(1e-11));
    }
    CHECK(std::isnan(spline.evaluate(grid.to_world({-0.3, 4, 3})).value));
  }
}

TEST_CASE("volumes without a cube round an interior sample are refused") {
  SampledGrid grid;
  grid.size = {3, 3, 2};
  grid.samples = std::vector<float>(18, 1);
  CHECK_THROWS_AS(splines::QuadraticSpline(grid), kernel::InputError);
}
