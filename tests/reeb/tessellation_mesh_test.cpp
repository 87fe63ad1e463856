// SPDX-License-Identifier: GPL-3.0-or-later
// Tiles over whole surfaces: a manifold again, an exact order, independent of numbering.
#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>
#include <set>

#include "algorithms/reeb/tile_complex.hpp"
#include "kernel/arithmetic/rational.hpp"
#include "tests/support/closed_surfaces.hpp"
#include "tests/support/degenerate_families.hpp"

using namespace crest;
using namespace crest::tests;
using kernel::Index;
using kernel::QuadraticMesh;
using kernel::Rational;
using kernel::Triangle;
using reeb::TileComplex;

namespace {

std::vector<std::array<double, 3>> midsides(const QuadraticMesh& mesh,
                                            const std::vector<double>& of_edge) {
  std::vector<std::array<double, 3>> result;
  for (const auto& e : mesh.face_edges())
    result.push_back({of_edge[e[0]], of_edge[e[1]], of_edge[e[2]]});
  return result;
}

QuadraticMesh random_field(const Surface& s, Draw& d, Family family) {
  std::vector<double> values(s.points.size());
  for (double& x : values) x = draw(d, family);
  const QuadraticMesh linear(s.points, s.triangles, values);
  std::vector<double> edges(linear.edge_count());
  for (double& x : edges) x = draw(d, family);
  return {s.points, s.triangles, values, midsides(linear, edges)};
}

std::vector<Surface> surfaces() {
  return {torus_surface(7, 5), plate(6, 1, true), plate(6, 2, false),
          strip(6, 3, Sides::flipped, Sides::open), strip(7, 5, Sides::joined, Sides::flipped)};
}

// Values by Cramer's rule from the polynomial, in rationals.
Rational exact_value(const QuadraticMesh& mesh, const TileComplex& t, Index node) {
  if (node < t.vertex_count) return mesh.values()[node];
  const std::size_t i = node - t.vertex_count;
  if (i < t.critical_edges.size()) {
    const kernel::Edge& e = mesh.edges()[t.critical_edges[i]];
    const Rational a = mesh.values()[e.v0], b = mesh.values()[e.v1],
                   m = mesh.edge_values()[t.critical_edges[i]];
    const Rational da = 4 * m - 3 * a - b, db = 3 * b + a - 4 * m;
    REQUIRE(da * db < 0);
    return a + da * da / (2 * (da - db));
  }
  const Index f = t.critical_faces[i - t.critical_edges.size()];
  std::array<Rational, 3> v, m;
  for (std::size_t k = 0; k < 3; ++k) {
    v[k] = mesh.values()[mesh.faces()[f][k]];
    m[k] = mesh.edge_values()[mesh.face_edges()[f][k]];
  }
  const Rational g = 4 * m[0] - 3 * v[0] - v[1], h = 4 * m[2] - 3 * v[0] - v[2];
  const Rational p = 4 * (v[0] + v[1] - 2 * m[0]), r = 4 * (v[0] + v[2] - 2 * m[2]);
  const Rational q = 4 * (v[0] + m[1] - m[0] - m[2]), det = p * r - q * q;
  const Rational s = (h * q - g * r) / det, u = (g * q - h * p) / det;
  REQUIRE((s > 0 && u > 0 && s + u < 1));
  return v[0] + (g * s + h * u) / 2;
}

long characteristic(const QuadraticMesh& m) {
  return long(m.vertex_count()) - long(m.edge_count()) + long(m.face_count());
}

std::vector<Triangle> sorted_tiles(const TileComplex& t) {
  std::vector<Triangle> tiles = t.tiles;
  for (Triangle& x : tiles) std::rotate(x.begin(), std::min_element(x.begin(), x.end()), x.end());
  std::sort(tiles.begin(), tiles.end());
  return tiles;
}

}  // namespace

TEST_CASE("tiles: the same surface, oriented as the faces are") {
  Draw d(700);
  for (const Surface& s : surfaces())
    for (const Family family : {Family::generic, Family::small_integers}) {
      const QuadraticMesh mesh = random_field(s, d, family);
      const TileComplex t = reeb::tessellate(mesh);
      REQUIRE(t.node_count() > t.vertex_count);
      REQUIRE(t.tile_begin.size() == mesh.face_count() + 1);
      // The constructor requires a manifold.
      const QuadraticMesh tiles(std::vector<kernel::Vec3>(t.node_count()), t.tiles,
                                std::vector<double>(t.node_count()));
      CHECK(characteristic(tiles) == characteristic(mesh));
      const auto directed = [](const std::vector<Triangle>& faces) {
        std::multiset<std::pair<Index, Index>> edges;
        for (const Triangle& x : faces)
          for (std::size_t k = 0; k < 3; ++k) edges.emplace(x[k], x[(k + 1) % 3]);
        std::size_t repeated = 0;
        for (auto i = edges.begin(); i != edges.end(); ++i)
          repeated += i != edges.begin() && *i == *std::prev(i);
        return repeated;
      };
      if (directed(s.triangles) == 0) CHECK(directed(t.tiles) == 0);
    }
}

namespace {

/// Checks every place in the order in rationals; returns who decided.
kernel::StageCounts require_exact_order(const QuadraticMesh& mesh) {
  reeb::PredicateReport report;
  const TileComplex t = reeb::tessellate(mesh, &report);
  const Index n = t.node_count();
  REQUIRE(t.order.size() == n);
  REQUIRE(t.tied.size() == n);
  std::vector<Rational> values(n);
  for (Index i = 0; i < n; ++i) values[i] = exact_value(mesh, t, i);
  std::uint64_t tied = 0;
  for (Index r = 0; r < n; ++r) {
    REQUIRE(t.rank[t.order[r]] == r);
    if (r == 0) continue;
    const Index a = t.order[r - 1], b = t.order[r];
    REQUIRE((values[a] < values[b] || (values[a] == values[b] && a < b)));
    REQUIRE(t.tied[r] == (values[a] == values[b]));
    tied += t.tied[r];
  }
  REQUIRE(report.size() == 4);
  const kernel::StageCounts& order = report[3].second;
  CHECK(report[3].first == "critical_value_order");
  CHECK(order.calls == n - 1);
  CHECK(order.symbolic == tied);
  CHECK(report[0].second.calls == mesh.edge_count());
  return order;
}

}  // namespace

TEST_CASE("tiles: the order is that of the exact values, ties by number") {
  kernel::StageCounts sum;
  for (const Family family : kFamilies) {
    Draw d(710, family);
    for (const Surface& s : surfaces()) sum += require_exact_order(random_field(s, d, family));
  }
  CHECK(sum.symbolic > 1000);
  CHECK(sum.interval + sum.exact > 0);
}

TEST_CASE("tiles: the order of quantised values, on a grid and off it") {
  const Surface s = torus_surface(9, 8);
  const auto field = [&](Draw& d, int levels, double step, double first) {
    const auto value = [&] { return step * d.integer(0, levels - 1); };
    std::vector<double> values(s.points.size());
    for (double& x : values) x = value();
    values[0] = first;
    const QuadraticMesh linear(s.points, s.triangles, values);
    std::vector<double> edges(linear.edge_count());
    for (double& x : edges) x = value();
    return QuadraticMesh(s.points, s.triangles, values, midsides(linear, edges));
  };
  Draw d(715);
  for (int i = 0; i < 10; ++i) {
    CAPTURE(i);
    for (const auto& [levels, step] : {std::pair{3, 1.0}, {16, 0x1p-4}, {256, 1.0}, {1024, 0.5}}) {
      const auto on_grid = require_exact_order(field(d, levels, step, 0));
      CHECK(on_grid.integer + on_grid.symbolic == on_grid.calls);
      CHECK(on_grid.integer > 0);
      CHECK(on_grid.symbolic > 0);
    }
    // One value off the grid, decimal steps, too many steps.
    const kernel::StageCounts off_grid[] = {require_exact_order(field(d, 3, 1, 1.0 / 3)),
                                            require_exact_order(field(d, 16, 0.1, 0)),
                                            require_exact_order(field(d, 5000, 1, 0))};
    for (const auto& counts : off_grid) CHECK(counts.integer == 0);
    CHECK(off_grid[0].symbolic > 100);
    CHECK(off_grid[1].symbolic > 10);
    CHECK(off_grid[1].exact > 0);
  }
}

TEST_CASE("tiles: many exact ties between critical values are resolved by number") {
  // Every square of the torus carries the same function of decimal fractions.
  const Surface s = torus_surface(60, 50);
  const QuadraticMesh linear(s.points, s.triangles, std::vector<double>(s.points.size(), 0.3));
  std::vector<double> edges(linear.edge_count());
  for (Index e = 0; e < edges.size(); ++e) {
    const auto [a, b, f0, f1] = linear.edges()[e];
    const Index step = b - a;
    edges[e] = step % 60 == 0 ? 0.1 : step % 60 == 1 || step % 60 == 59 ? 0.7 : 1.1;
  }
  const QuadraticMesh mesh(s.points, s.triangles, linear.values(), midsides(linear, edges));
  reeb::PredicateReport report;
  const TileComplex t = reeb::tessellate(mesh, &report);
  CHECK(t.node_count() > 10000);
  std::set<Rational> different;
  for (Index i = 0; i < t.node_count(); ++i) different.insert(exact_value(mesh, t, i));
  CHECK(different.size() < 20);
  CHECK(report[3].second.symbolic == t.node_count() - different.size());
  for (Index r = 1; r < t.node_count(); ++r)
    if (t.tied[r]) REQUIRE(t.order[r - 1] < t.order[r]);
}

TEST_CASE("tiles: independent of the order of the faces and of their corners") {
  Draw d(720);
  for (const Surface& s : surfaces())
    for (const Family family : {Family::generic, Family::small_integers, Family::nearly_equal}) {
      const QuadraticMesh mesh = random_field(s, d, family);
      const TileComplex t = reeb::tessellate(mesh);
      std::vector<Index> from(mesh.face_count());
      std::iota(from.begin(), from.end(), 0u);
      for (std::size_t i = from.size(); i-- > 1;)
        std::swap(from[i], from[static_cast<std::size_t>(d.integer(0, static_cast<int>(i)))]);
      std::vector<Triangle> faces;
      for (Index f : from) {
        faces.push_back(mesh.faces()[f]);
        std::rotate(faces.back().begin(), faces.back().begin() + d.integer(0, 2),
                    faces.back().end());
      }
      const QuadraticMesh linear(s.points, faces, mesh.values());
      const QuadraticMesh other(s.points, faces, mesh.values(),
                                midsides(linear, mesh.edge_values()));
      const TileComplex u = reeb::tessellate(other);
      CHECK(u.critical_edges == t.critical_edges);
      REQUIRE(u.critical_faces.size() == t.critical_faces.size());
      for (std::size_t i = 0; i < u.critical_faces.size(); ++i)
        REQUIRE(from[u.critical_faces[i]] == t.critical_faces[i]);
      CHECK(u.order == t.order);
      CHECK(u.tied == t.tied);
      CHECK(sorted_tiles(u) == sorted_tiles(t));
      const auto a = reeb::node_places(mesh, t), b = reeb::node_places(other, u);
      for (Index i = 0; i < t.node_count(); ++i)
        REQUIRE((a[i].value == b[i].value && a[i].point == b[i].point));
    }
}

TEST_CASE("tiles: a linear function's tiles are its faces") {
  const Surface s = torus_surface(8, 6);
  std::vector<double> values(s.points.size());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<double>(i % 5) - 2;
  values[7] = -0.0;  // ties with +0
  values[3] = -1e308;
  values[4] = 5e-324;
  const QuadraticMesh mesh(s.points, s.triangles, values);
  const TileComplex t = reeb::tessellate(mesh);
  CHECK(t.tiles == mesh.faces());
  CHECK(t.tile_begin.empty());
  CHECK(t.node_count() == mesh.vertex_count());
  for (Index r = 1; r < t.node_count(); ++r) {
    const Index a = t.order[r - 1], b = t.order[r];
    REQUIRE((values[a] < values[b] || (values[a] == values[b] && a < b)));
    REQUIRE(t.tied[r] == (values[a] == values[b]));
  }
}

TEST_CASE("tiles: plain double agrees where nothing is degenerate, and only there") {
  Draw d(730);
  const QuadraticMesh mesh = random_field(torus_surface(60, 50), d, Family::generic);
  const TileComplex exact = reeb::tessellate(mesh), plain = reeb::tessellate(mesh, nullptr, false);
  CHECK(plain.tiles == exact.tiles);
  CHECK(plain.order == exact.order);
  // Midside values at which the derivative in one end all but vanishes.
  const Surface surface = torus_surface(60, 50);
  const QuadraticMesh linear(surface.points, surface.triangles, mesh.values());
  std::vector<double> edges;
  for (const kernel::Edge& e : linear.edges()) {
    const double a = mesh.values()[e.v0], b = mesh.values()[e.v1];
    edges.push_back(a + (b - a) / 4);
  }
  const QuadraticMesh flat(surface.points, surface.triangles, mesh.values(),
                           midsides(linear, edges));
  reeb::PredicateReport report;
  const bool differs =
      reeb::tessellate(flat, &report).tiles != reeb::tessellate(flat, nullptr, false).tiles;
  CHECK(report[0].second.interval + report[0].second.exact > 1000);
  CHECK(differs);
}

TEST_CASE("tiles: places and values of nodes") {
  for (const Family family : kFamilies) {
    CAPTURE(static_cast<int>(family));
    Draw d(740, family);
    const Surface s = plate(6, 1, true);
    const QuadraticMesh mesh = random_field(s, d, family);
    const TileComplex t = reeb::tessellate(mesh);
    const auto places = reeb::node_places(mesh, t);
    REQUIRE(places.size() == t.node_count());
    double scale = 0;
    for (double x : mesh.values()) scale = std::max(scale, std::fabs(x));
    for (double x : mesh.edge_values()) scale = std::max(scale, std::fabs(x));
    for (Index r = 0; r < t.node_count(); ++r) {
      const Index i = t.order[r];
      const Rational error = abs(Rational(places[i].value) - exact_value(mesh, t, i));
      REQUIRE(error <= Rational(scale) * Rational(0x1p-39) + Rational(5e-324));
      if (r > 0) REQUIRE(places[t.order[r - 1]].value <= places[i].value);
      if (i < t.vertex_count) {
        REQUIRE(places[i].value == mesh.values()[i]);
        REQUIRE(places[i].point == mesh.points()[i]);
      } else if (i < t.vertex_count + t.critical_edges.size()) {
        const kernel::Edge& e = mesh.edges()[t.critical_edges[i - t.vertex_count]];
        for (std::size_t k = 0; k < 3; ++k) {
          const auto [low, high] = std::minmax(mesh.points()[e.v0][k], mesh.points()[e.v1][k]);
          REQUIRE((low - 1e-15 <= places[i].point[k] && places[i].point[k] <= high + 1e-15));
        }
      }
    }
  }
}
