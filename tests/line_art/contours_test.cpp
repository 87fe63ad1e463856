// SPDX-License-Identifier: GPL-3.0-or-later
// Exact contours: counts of reference meshes, balance, brute force, the specification's hard
// scenes.
#include "algorithms/line_art/contours.hpp"

#include <catch2/catch.hpp>
#include <numeric>

#include "io/clean/triangulate.hpp"
#include "io/formats/readers.hpp"
#include "kernel/arithmetic/rational.hpp"
#include "tests/line_art/scenes.hpp"
#include "tests/support/failures.hpp"
#include "tests/support/shared_data.hpp"

using namespace crest;
using namespace crest::line_art;
using namespace crest::tests;

namespace {

struct Reference {
  const char* mesh;
  Vec3 eye;
  bool perspective;
  std::array<std::size_t, 6> counts;  // edges, crossings, piercings, cusps, pieces, visible
};

std::array<std::size_t, 6> counts_of(const Contours& c) {
  return {c.counts.edges, c.counts.crossings, c.counts.piercings,
          c.counts.cusps, c.counts.pieces,    c.counts.visible};
}

/// The reference counts are those of fans: crest's reader cuts quads along their shorter diagonals.
Scene fans_of(const std::string& path) {
  const io::Soup soup = io::read_soup(path, {});
  std::vector<Triangle> faces;
  for (std::size_t c = 0; c < soup.cells.size(); ++c) {
    const auto corners = io::corners_of(soup, c);
    for (std::size_t k = 2; k < corners.size(); ++k)
      faces.push_back({corners[0], corners[k - 1], corners[k]});
  }
  return weld(soup.points, faces);
}

void check(const Reference& reference) {
  const auto path = shared_data(std::string("meshes/") + reference.mesh);
  if (!path) return;
  const Scene scene = fans_of(*path);
  INFO(reference.mesh << (reference.perspective ? " in perspective" : ""));
  CHECK(counts_of(seen(scene, reference.eye, reference.perspective)) == reference.counts);
}

/// N of a piece's middle, by one ray in rationals against all faces. Requires a generic view.
std::size_t brute_force(const Scene& scene, const Vec3& e, const ContourEdge& edge, double t) {
  using kernel::Rational, kernel::lift;
  using kernel::operator+, kernel::operator-, kernel::operator*;
  using Exact = kernel::Vector3<Rational>;
  const Exact a = lift<Rational>(scene.points[edge.a]), b = lift<Rational>(scene.points[edge.b]);
  const Exact x = a + Rational(t) * (b - a), d = lift<Rational>(e);
  std::size_t count = 0;
  for (const Triangle& f : scene.faces) {
    bool own = false;
    for (const Index v : f) own = own || v == edge.a || v == edge.b;
    if (own &&
        std::count_if(f.begin(), f.end(), [&](Index v) { return v == edge.a || v == edge.b; }) == 2)
      continue;
    const Exact p = lift<Rational>(scene.points[f[0]]), q = lift<Rational>(scene.points[f[1]]),
                r = lift<Rational>(scene.points[f[2]]);
    const auto side = [&](const Exact& u, const Exact& v) {
      return kernel::sign_of(kernel::determinant(d, Exact(u - x), Exact(v - x)));
    };
    const auto s = side(p, q);
    if (s == kernel::Sign::zero || side(q, r) != s || side(r, p) != s) continue;
    const Exact n = kernel::cross(Exact(q - p), Exact(r - p));
    if (kernel::sign_of(Rational(kernel::dot(n, Exact(p - x)))) ==
        kernel::sign_of(Rational(kernel::dot(n, d))))
      ++count;
  }
  return count;
}

}  // namespace

TEST_CASE("Contours have the counts of the reference meshes") {
  check({"rocker-arm.obj", {2, 1, 3}, false, {1542, 449, 0, 461, 1991, 721}});
  check({"rocker-arm.obj", {2, 1, 3}, true, {1471, 411, 0, 424, 1882, 691}});
  check({"stanford-bunny.obj", {1, 0.5, 4}, false, {2555, 1619, 0, 858, 4174, 894}});
  check({"armadillo.off", {-1, 0.5, -3}, false, {5444, 3211, 0, 1709, 8655, 2027}});
  check({"torus.obj", {2, 1, 3}, false, {240, 68, 0, 64, 308, 162}});
  check({"moebius.obj", {2, 1, 3}, false, {147, 64, 0, 24, 211, 112}});
  check({"suzanne.obj", {2, 1, 3}, false, {266, 83, 19, 60, 368, 133}});
  check({"cow.obj", {2, 1, 3}, false, {700, 246, 9, 178, 955, 385}});
  check({"teapot.obj", {2, 1, 3}, false, {495, 71, 7, 64, 573, 291}});
  check({"fandisk.off", {0, 0, 1}, false, {363, 3, 0, 6, 364, 217}});
}

TEST_CASE("Faces in front balance on every edge, in random and axis views") {
  // find_contours asserts the balance itself, on every edge.
  Draw d(11);
  int edges = 0, symbolic = 0;
  for (const Scene& scene : hard_scenes())
    for (int view = 0; view < 8; ++view) {
      Vec3 e = {0, 0, 0};
      if (view < 3)
        e[static_cast<std::size_t>(view)] = 1;
      else if (view < 6)
        for (double& x : e) x = d.integer(-2, 2);
      else
        for (double& x : e) x = d.uniform();
      if (e == Vec3{}) e = {1, 1, 0};
      Contours c;
      REQUIRE_NOTHROW(c = seen(scene, e, false));
      REQUIRE_NOTHROW(seen(scene, {30 * e[0], 30 * e[1], 30 * e[2] + 40}, true));
      edges += static_cast<int>(c.edges.size());
      symbolic += c.decisions.side.symbolic > 0;
    }
  CHECK(edges > 500);
  CHECK(symbolic > 20);
}

TEST_CASE("The number of faces in front is that of one ray against all") {
  Draw d(12);
  Failures failures;
  for (const Scene& scene : hard_scenes()) {
    const Vec3 e = {d.uniform(), d.uniform(), d.uniform()};
    const Contours c = seen(scene, e, false);
    if (c.decisions.side.symbolic + c.decisions.volume.symbolic > 0) continue;
    for (const ContourEdge& edge : c.edges)
      for (Index i = edge.first_piece; i < edge.first_piece + edge.pieces; ++i) {
        const Piece& p = c.pieces[i];
        if (p.to - p.from < 1e-9) continue;
        const std::size_t n = brute_force(scene, e, edge, 0.5 * (p.from + p.to));
        failures.expect(n == p.in_front, "N is the ray's on", scene.points[edge.a], e);
      }
  }
  CHECK(failures.report() == "");
}

TEST_CASE("A convex body's contour is all visible, without a crossing") {
  const Scene ball = sphere_scene(20, 30);
  const Contours c = seen(ball, {0.3, 0.2, 1}, false);
  CHECK(c.counts.crossings == 0);
  CHECK(c.counts.piercings == 0);
  CHECK(c.counts.hidden == 0);
  CHECK(c.counts.visible == c.counts.edges);
  CHECK(c.counts.edges > 20);
}

TEST_CASE("A step seen along its wall has a line, whichever way the wall faces") {
  for (const double side : {1.0, -1.0}) {
    const Scene step = step_scene(side);
    const Contours c = seen(step, {0, 0, 1}, false);
    std::size_t lines = 0;
    for (const ContourEdge& e : c.edges) {
      const bool at_wall = step.points[e.a][0] == 0 && step.points[e.b][0] == 0;
      if (!at_wall || e.end_on) continue;
      for (Index i = e.first_piece; i < e.first_piece + e.pieces; ++i) lines += c.pieces[i].drawn();
    }
    CHECK(lines >= 1);
  }
}

TEST_CASE("An edge that rests on a face is drawn whatever the numbers") {
  // The edge lies in the plane z = 0 of a large triangle; nothing is in front of it.
  const std::vector<Vec3> names = {{2, 3, 0},    {8, 3, 0},  {-20, -20, 0},
                                   {40, -20, 0}, {0, 40, 0}, {5, 3, -4}};
  std::array<Index, 6> number = {0, 1, 2, 3, 4, 5};
  int hidden_by_contact = 0, views = 0;
  do {
    std::vector<Vec3> points(6);
    for (std::size_t k = 0; k < 6; ++k) points[number[k]] = names[k];
    const auto [a, b, p, q, r, low] = number;
    const Scene scene = weld(points, {{p, q, r}, {a, b, low}});
    // Faces name their points in the order of the input, so numbers stay.
    const Contours c = seen(scene, {1, 2, 3}, false);
    for (const ContourEdge& e : c.edges) {
      if (e.a != std::min(a, b) || e.b != std::max(a, b)) continue;
      ++views;
      for (Index i = e.first_piece; i < e.first_piece + e.pieces; ++i) {
        CHECK(c.pieces[i].drawn());
        hidden_by_contact += c.pieces[i].in_front > 0;
      }
    }
  } while (std::next_permutation(number.begin(), number.end()));
  CHECK(views == 720);
  CHECK(hidden_by_contact > 100);
}

TEST_CASE("Other numbers change nothing in generic views") {
  Draw d(13);
  for (const Scene& scene : hard_scenes()) {
    const Vec3 e = {d.uniform(), d.uniform(), d.uniform()};
    const Contours c = seen(scene, e, false);
    if (c.decisions.side.symbolic + c.decisions.volume.symbolic > 0) continue;
    std::vector<Vec3> points(scene.points.rbegin(), scene.points.rend());
    std::vector<Triangle> faces;
    const auto last = static_cast<Index>(points.size() - 1);
    for (const Triangle& f : scene.faces) faces.push_back({last - f[0], last - f[1], last - f[2]});
    const Contours other = seen(weld(points, faces), e, false);
    CHECK(c.counts.edges == other.counts.edges);
    CHECK(c.counts.crossings == other.counts.crossings);
    CHECK(c.counts.pieces == other.counts.pieces);
    CHECK(c.counts.visible == other.counts.visible);
  }
}

TEST_CASE("Views that are none are refused in one line") {
  const Scene ball = sphere_scene(6, 8);
  CHECK_THROWS_WITH(seen(ball, {0, 0, 0}, false), Catch::Contains("camera"));
  CHECK_THROWS_WITH(seen(ball, {0, HUGE_VAL, 0}, false), Catch::Contains("camera"));
  CHECK_THROWS_WITH(seen(ball, {0, 0.5, 0.5}, true), Catch::Contains("is not in front of the eye"));
  CHECK_THROWS_WITH(weld({{0, 0, 0}, {0, 0, 0}, {1, 0, 0}}, {{0, 1, 2}}),
                    Catch::Contains("three corners apart"));
}
