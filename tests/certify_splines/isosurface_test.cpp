// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 13: leaves, true certificates, what the referee found.
#include <catch2/catch.hpp>
#include <cmath>

#include "certify/spline_isosurface/encode.hpp"
#include "certify/spline_isosurface/leaf_test.hpp"
#include "certify/verify.hpp"
#include "tests/certify_splines/reference_isosurface.hpp"
#include "tests/support/random.hpp"
#include "tests/support/verdicts.hpp"

using namespace crest::certify;
using namespace crest::tests;
using spline_isosurface::kind_of;
using spline_isosurface::LeafForm;
using spline_isosurface::LeafKind;

namespace {

std::function<double(double, double, double)> ball(double x0, double y0, double z0) {
  return [=](double x, double y, double z) {
    return (x - x0) * (x - x0) + (y - y0) * (y - y0) + (z - z0) * (z - z0);
  };
}
/// One cube, or with a layer eight.
SplineVolume random_volume(double level, Random& random, bool extended) {
  const std::uint32_t n = extended ? 2 : 3;
  return sampled_volume(
      {n, n, n}, level,
      [&](double, double, double) { return static_cast<double>(random() % 21) - 10; }, extended);
}

template <class Number>
LeafForm<Number> lifted(const ReferenceForm& form) {
  LeafForm<Number> leaf;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      if (j < 3) leaf.corners[i][j] = static_cast<double>(form.corners[i][j] - form.corners[0][j]);
      leaf.b[i][j] = Number(static_cast<double>(form.b[i][j]));
    }
  return leaf;
}

const std::array<Exact3, 4> kKuhn = {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}}};

}  // namespace

TEST_CASE("splines: spheres, closed, in every frame") {
  for (const int flip : {0, 1, 2}) {
    auto volume = sampled_volume({5, 5, 5}, 1.7, ball(1.9, 2.1, 2));
    if (flip > 0) volume.direction = {0, 1, 0, flip == 1 ? 1.0 : -1.0, 0, 0.5, 0, 0, 2};
    const auto c = reference_isosurface(volume);
    REQUIRE(c);
    CHECK(c->euler_characteristic == 2);
    CHECK(c->components == 1);
    CHECK(c->boundary_loops == 0);
    require_accepted(*c);
    auto turned = *c;
    for (auto& t : turned.triangles) std::swap(t[1], t[2]);
    CHECK(reason(turned) == "the triangles are not those of the signs");
  }
}

TEST_CASE("splines: isosurfaces of random volumes are accepted as the reference makes them") {
  Random random(kSeed);
  std::size_t made = 0, bisected = 0;
  for (std::uint64_t i = 0; i < scaled(12); ++i) {
    IsosurfaceOptions options;
    options.depth = 14;
    const auto volume = random_volume(i % 2 == 0 ? 0.5 : 0.37, random, i % 4 == 3);
    const auto c = reference_isosurface(volume, options);
    if (!c) continue;
    ++made;
    bisected += c->bisected.size();
    require_accepted(*c);
  }
  CHECK(made >= 8);
  CHECK(bisected > 0);
}

TEST_CASE("splines: without the faces' condition, or with the full gradient, nothing is accepted") {
  // A closed circle on the face z = 0 of a Kuhn simplex.
  const auto form = reference_form(kKuhn, [](const Exact3& x) {
    const Rational u = x[0] - Rational(7) / 10, v = x[1] - Rational(3) / 10;
    return Rational(Rational(1) / 100 - u * u - v * v + 5 * x[2]);
  });
  IsosurfaceOptions without;
  without.faces = false;
  CHECK(form.is_simple(without));
  CHECK_FALSE(form.is_simple({}));
  CHECK(kind_of(lifted<Rational>(form)) == LeafKind::neither);
  CHECK(kind_of(lifted<Rational>(form)) != LeafKind::simple);
  Random random(kSeed);
  std::size_t wrong = 0;
  for (std::uint64_t i = 0; i < scaled(6); ++i) {
    const auto volume = random_volume(0.5, random, false);
    IsosurfaceOptions options;
    options.depth = 14;
    const auto good = reference_isosurface(volume, options);
    options.faces = false;
    const auto c = reference_isosurface(volume, options);
    if (!c || !good || c->trees == good->trees) continue;
    ++wrong;
    CHECK(reason(*c).ends_with("is neither empty nor simple"));
  }
  CHECK(wrong > 0);
}

TEST_CASE("splines: zeros count as positive: touched from below is two zeros, from above none") {
  using Edge = std::array<Rational, 3>;
  const auto simple = [](const Edge& b) { return *spline_isosurface::is_simple_edge(b); };
  CHECK_FALSE(simple(Edge{-1, 1, -1}));
  CHECK(simple(Edge{1, -1, 1}));
  CHECK(simple(Edge{0, 0, 0}));
  CHECK(simple(Edge{0, -1, 0}) == false);
  // Against the zeros of b + e for a small e, counted by signs at many points and by the vertex.
  Random random(kSeed);
  for (int i = 0; i < 3000; ++i) {
    Edge b;
    for (Rational& x : b) x = static_cast<double>(random() % 7) - 3;
    const Rational e = Rational(1) / Rational(0x1p40);
    const Rational b0 = b[0] + e, b1 = b[1] + e, b2 = b[2] + e;
    int zeros = (b0 > 0) != (b2 > 0);
    const Rational bend = b0 - 2 * b1 + b2;
    if (zeros == 0 && bend != 0) {
      const Rational t = (b0 - b1) / bend;
      const Rational value = b0 * (1 - t) * (1 - t) + 2 * b1 * t * (1 - t) + b2 * t * t;
      zeros = t > 0 && t < 1 && (value > 0) != (b0 > 0) ? 2 : 0;
    }
    INFO(b[0] << " " << b[1] << " " << b[2]);
    CHECK(simple(b) == (zeros < 2));
    const std::array<crest::kernel::Interval, 3> near = {
        crest::kernel::Interval(static_cast<double>(b[0])), static_cast<double>(b[1]),
        static_cast<double>(b[2])};
    const crest::kernel::RoundUpward guard;
    const auto by_intervals = spline_isosurface::is_simple_edge(near);
    CHECK((!by_intervals || *by_intervals == simple(b)));
  }
}

TEST_CASE("splines: intervals and rationals agree on random leaves, and with the reference") {
  Random random(kSeed);
  std::map<LeafKind, int> kinds;
  for (int i = 0; i < 2000; ++i) {
    std::array<std::array<double, 4>, 4> b{};
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t l = k; l < 4; ++l)
        b[k][l] = b[l][k] =
            static_cast<double>(random() % (i % 2 == 0 ? 7 : 2001)) - (i % 2 == 0 ? 2 : 800);
    ReferenceForm form{kKuhn, {}};
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t l = 0; l < 4; ++l) form.b[k][l] = b[k][l];
    const auto kind = kind_of(lifted<Rational>(form));
    REQUIRE(kind);
    ++kinds[*kind];
    const bool empty = form.is_empty({0, 1, 2, 3});
    CHECK(*kind == (empty                ? LeafKind::empty
                    : form.is_simple({}) ? LeafKind::simple
                                         : LeafKind::neither));
    const crest::kernel::RoundUpward guard;
    const auto near = kind_of(lifted<crest::kernel::Interval>(form));
    CHECK((!near || *near == *kind));
  }
  CHECK(kinds.size() == 3);
}

TEST_CASE("splines: a sphere through a vertex, tangent to a face's plane, needs empty faces") {
  // s = |x - c|^2 + 3/4 with c at a cube's vertex: the sphere of radius 1 is tangent to planes of
  // the partition at vertices.
  const auto volume = sampled_volume({6, 6, 6}, 1.75, ball(2.5, 2.5, 2.5));
  IsosurfaceOptions options;
  options.depth = 12;
  const auto c = reference_isosurface(volume, options);
  REQUIRE(c);
  CHECK(c->euler_characteristic == 2);
  require_accepted(*c);
  options.empty_faces = false;
  CHECK_FALSE(reference_isosurface(volume, options));
}

TEST_CASE("splines: the level equal to a sample, and a plateau on the level") {
  const auto volume = sampled_volume({4, 4, 4}, 3, [](double x, double y, double z) {
    return x + 2 * y - z + (x == 1 && y == 2 ? 1 : 0);
  });
  IsosurfaceOptions options;
  options.depth = 12;
  const auto c = reference_isosurface(volume, options);
  REQUIRE(c);
  require_accepted(*c);
  options.depth = 3;
  const auto plateau =
      sampled_volume({5, 3, 3}, 2, [](double x, double, double) { return std::min(x, 2.0); });
  CHECK_FALSE(reference_isosurface(plateau, options));
  SplineIsosurfaceCertificate none;
  none.volume = plateau;
  CHECK(reason(none).ends_with("is neither empty nor simple"));
}

TEST_CASE("splines: a bracket holds the limit of its vertex, not another zero at a corner") {
  // Integers with the level on corners of the partition: edges (0, b1 > 0, -) occur.
  Random random(kSeed);
  std::size_t other_zeros = 0;
  for (std::uint64_t i = 0; i < scaled(12); ++i) {
    const auto volume = sampled_volume({3, 3, 3}, 0, [&](double, double, double) {
      return static_cast<double>(random() % 3) - 1;
    });
    IsosurfaceOptions options;
    options.depth = 10;
    const auto c = reference_isosurface(volume, options);
    if (!c) continue;
    require_accepted(*c);
    for (std::size_t v = 0; v < c->brackets.size(); ++v)
      for (const double end : {0.0, 1.0}) {
        auto moved = *c;
        moved.brackets[v] = {end, end};
        const bool same = c->brackets[v][0] <= end && end <= c->brackets[v][1];
        CHECK(verify(encode(moved)).accepted == same);
        ++other_zeros;
      }
  }
  CHECK(other_zeros > 0);
}

TEST_CASE("splines: leaves that do not conform, trees that are not whole, are rejected") {
  const auto volume = sampled_volume({6, 6, 6}, 1.75, ball(2.5, 2.5, 2.5));
  const auto made = reference_isosurface(volume);
  REQUIRE(made);
  REQUIRE(made->bisected.size() > 2);
  // One more tetrahedron bisected, far from the surface, without those beside it.
  auto alone = *made;
  alone.bisected.insert(alone.bisected.begin(), 0);
  alone.trees.insert(alone.trees.begin(), {1, 0, 0});
  REQUIRE(alone.bisected[1] != 0);
  CHECK(reason(alone).starts_with("a face of "));
  auto deeper = *made;
  const auto leaf = std::find(deeper.trees.begin(), deeper.trees.end(), 0);
  *leaf = 1;
  deeper.trees.insert(leaf + 1, {0, 0});
  CHECK(reason(deeper).starts_with("a face of "));
  auto less = *made;
  less.trees.pop_back();
  CHECK(reason(less).ends_with("is not complete"));
  auto more = *made;
  more.trees.push_back(0);
  CHECK(reason(more) == "there are more trees than tetrahedra");
  auto twice = *made;
  twice.bisected[1] = twice.bisected[0];
  CHECK(reason(twice) == "bisected tetrahedra are not ascending");
  auto beyond = *made;
  beyond.bisected.back() = 24 * 64;
  CHECK(reason(beyond) == "bisected tetrahedra are not ascending");
  auto deep = *made;
  deep.trees.clear();
  deep.bisected = {0};
  for (int i = 0; i < 61; ++i) deep.trees.push_back(1);
  for (int i = 0; i < 62; ++i) deep.trees.push_back(0);
  CHECK(reason(deep) == "the tree of tetrahedron 0 is too deep");
}

TEST_CASE("splines: numbers of an isosurface that are not its own are rejected") {
  const auto made = reference_isosurface(sampled_volume({5, 5, 5}, 1.6, ball(2.1, 2, 1.9)));
  REQUIRE(made);
  require_accepted(*made);
  auto c = *made;
  c.euler_characteristic += 2;
  CHECK(reason(c) == "Euler characteristic: 4 stated, 2 found");
  c = *made;
  ++c.components;
  CHECK(reason(c) == "components: 2 stated, 1 found");
  c = *made;
  ++c.boundary_loops;
  CHECK(reason(c) == "boundary loops: 1 stated, 0 found");
  c = *made;
  std::swap(c.triangles[0], c.triangles[1]);
  CHECK(reason(c) == "the triangles are not those of the signs");
  c = *made;
  c.brackets[7] = {std::nextafter(c.brackets[7][1], 1), 1};
  CHECK(reason(c) == "the bracket of vertex 7 does not hold its zero");
  c.brackets[7] = {0, std::nextafter(made->brackets[7][0], 0)};
  CHECK(reason(c) == "the bracket of vertex 7 does not hold its zero");
  c.brackets[7] = {0, 1};
  require_accepted(c);
  c.brackets.pop_back();
  CHECK(reason(c).starts_with("vertices: "));
  c = *made;
  c.volume.direction = {1, 0, 0, 0, 1, 0, 1, 1, 0};
  CHECK(reason(c) == "the grid's matrix is singular");
}
