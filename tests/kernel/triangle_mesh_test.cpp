// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of a mesh against their definitions, and what it is refused for, in any number of
// threads.
#include "kernel/geometry/triangle_mesh.hpp"

#include <tbb/global_control.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>

#include "kernel/geometry/input_error.hpp"

using namespace crest::kernel;

namespace {

/// n x n squares, each of two triangles; folded: the last row is the first, and the last column.
struct Grid {
  std::vector<Vec3> points;
  std::vector<Triangle> faces;

  explicit Grid(Index n, bool folded = false) {
    const Index side = folded ? n : n + 1;
    const auto at = [&](Index i, Index j) { return (i % side) * side + j % side; };
    for (Index i = 0; i < side; ++i)
      for (Index j = 0; j < side; ++j) {
        const double x = i, y = j;
        points.push_back({x, y, folded ? 0.25 * x * (n - x) + 0.5 * y * (n - y) : x * y});
      }
    for (Index i = 0; i < n; ++i)
      for (Index j = 0; j < n; ++j) {
        faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
        faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
      }
  }
};

using Side = std::pair<Index, Index>;

void check_edges(const TriangleMesh& mesh) {
  std::map<Side, std::array<Index, 2>> edges;
  for (Index f = 0; f < mesh.face_count(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = mesh.faces()[f][k], w = mesh.faces()[f][(k + 1) % 3];
      auto& of = edges.try_emplace(std::minmax(v, w), std::array{kNone, kNone}).first->second;
      of[v < w ? 0 : 1] = f;
    }
  REQUIRE(mesh.edge_count() == edges.size());
  Index e = 0;
  for (const auto& [ends, faces] : edges) {
    const Edge& edge = mesh.edges()[e];
    REQUIRE((Side(edge.v0, edge.v1) == ends && edge.f0 == faces[0] && edge.f1 == faces[1]));
    for (const Index f : faces) {
      if (f == kNone) continue;
      const auto& sides = mesh.face_edges()[f];
      const auto k =
          static_cast<std::size_t>(std::find(sides.begin(), sides.end(), e) - sides.begin());
      REQUIRE(k < 3);
      REQUIRE(Side(std::minmax(mesh.faces()[f][k], mesh.faces()[f][(k + 1) % 3])) == ends);
    }
    ++e;
  }
}

void check_fans(const TriangleMesh& mesh) {
  std::vector<std::vector<Index>> faces(mesh.vertex_count());
  for (Index f = 0; f < mesh.face_count(); ++f)
    for (const Index v : mesh.faces()[f]) faces[v].push_back(f);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const auto ring = mesh.ring(v), fan = mesh.fan(v);
    REQUIRE(fan.size() == faces[v].size());
    REQUIRE(ring.size() == fan.size() + (mesh.on_boundary(v) ? 1 : 0));
    if (!mesh.on_boundary(v)) REQUIRE(fan[0] == faces[v][0]);
    for (std::size_t j = 0; j < fan.size(); ++j) {
      const Triangle& t = mesh.faces()[fan[j]];
      const auto k = static_cast<std::size_t>(std::find(t.begin(), t.end(), v) - t.begin());
      REQUIRE(k < 3);
      REQUIRE(ring[j] == t[(k + 1) % 3]);
      REQUIRE(ring[(j + 1) % ring.size()] == t[(k + 2) % 3]);
    }
  }
}

std::string refusal(const Grid& grid, std::size_t threads) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  try {
    const TriangleMesh mesh(grid.points, grid.faces);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a mesh's tables are those of their definitions") {
  for (const std::size_t threads : {1u, 2u}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    for (const bool folded : {false, true}) {
      const Grid grid(110, folded);  // more vertices and faces than a part of a loop has
      const TriangleMesh mesh(grid.points, grid.faces);
      check_edges(mesh);
      check_fans(mesh);
      CHECK(mesh.components() == 1);
      CHECK(mesh.boundary_loops() == (folded ? 0 : 1));
      CHECK(mesh.euler_characteristic() == (folded ? 0 : 1));
    }
    Grid holes(110);
    std::erase(holes.faces, holes.faces[2 * (110 * 3 + 3)]);
    std::erase(holes.faces, holes.faces[2 * (110 * 90 + 90)]);
    const TriangleMesh mesh(holes.points, holes.faces);
    check_edges(mesh);
    check_fans(mesh);
    CHECK(mesh.boundary_loops() == 3);
  }
}

TEST_CASE("a mesh is refused for what comes first, in any number of threads") {
  const Index n = 110, far = 2 * (n * 100 + 50), near = 2 * (n * 2 + 50);
  Grid flat(n), turned(n), three(n), lonely(n), fans(n);
  for (const Index f : {far, near}) {
    flat.points[flat.faces[f][2]] = flat.points[flat.faces[f][1]];
    std::swap(turned.faces[f][0], turned.faces[f][1]);
    const auto [a, b, c] = three.faces[f];
    three.points.push_back({three.points[a][0], three.points[a][1], 1e6});
    three.faces.push_back({a, b, static_cast<Index>(three.points.size() - 1)});
    lonely.points.push_back({0, 0, 1});
    // All but the two faces that meet in a vertex alone.
    const Index v = fans.faces[f][0];
    std::erase_if(fans.faces, [&, seen = 0](const Triangle& t) mutable {
      return (t[0] == v || t[1] == v || t[2] == v) && ++seen != 1 && seen != 6;
    });
  }
  const auto edge = [&](Index v, Index w) {
    return "edge " + std::to_string(v) + "-" + std::to_string(w);
  };
  const Grid whole(n);
  const auto [a, b, c] = whole.faces[near];
  for (const std::size_t threads : {1u, 2u, 3u}) {
    INFO(threads);
    CHECK(refusal(whole, threads) == "");
    const std::string zero = refusal(flat, threads);
    CHECK(zero.starts_with("face "));
    CHECK(std::stoul(zero.substr(5)) < far - n);
    CHECK(zero == refusal(flat, 1));
    CHECK(refusal(turned, threads).find("oriented inconsistently") != std::string::npos);
    CHECK(refusal(turned, threads) == refusal(turned, 1));
    CHECK(refusal(three, threads) ==
          edge(std::min(a, b), std::max(a, b)) + ": it has more than two faces; make it manifold");
    CHECK(refusal(lonely, threads) == "vertex " + std::to_string(whole.points.size()) +
                                          ": it belongs to no face; remove isolated vertices");
    CHECK(refusal(fans, threads) == "vertex " + std::to_string(whole.faces[near][0]) +
                                        ": several fans of faces meet in it; split it");
  }
}
