// SPDX-License-Identifier: GPL-3.0-or-later
// Theorem 4 of certify/reeb/SPEC.md by brute force: on every triangle, at every critical level and
// between any two, the tiles join the boundary's nodes in sub- and superlevel sets as the conics
// do.
//
// That is enough: a monotone piece of the boundary that meets {f <= c} holds a node in it, and as a
// triangle is simply connected, two points of {f = c} lie in one component of it iff they do in
// {f <= c} and in {f >= c} (Mayer-Vietoris).
#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>

#include "algorithms/reeb/tile_complex.hpp"
#include "kernel/predicates/face_critical.hpp"
#include "tests/reeb/tessellation_oracle.hpp"
#include "tests/support/degenerate_families.hpp"
#include "tests/support/failures.hpp"

using namespace crest;
using namespace crest::tests;
using kernel::QuadraticMesh;
using reeb::Index;
using reeb::TileComplex;

namespace {

using Nodal = std::array<int, 6>;

// Disjoint triangles: face f has vertices 3f .. 3f + 2.
QuadraticMesh separate_triangles(const std::vector<Nodal>& all) {
  std::vector<kernel::Vec3> points;
  std::vector<kernel::Triangle> faces;
  std::vector<double> values;
  std::vector<std::array<double, 3>> midside;
  for (Index f = 0; f < all.size(); ++f) {
    faces.push_back({3 * f, 3 * f + 1, 3 * f + 2});
    for (std::size_t k = 0; k < 3; ++k) {
      points.push_back({k == 1 ? 1.0 : 0.0, k == 2 ? 1.0 : 0.0, static_cast<double>(f)});
      values.push_back(all[f][k]);
    }
    midside.push_back({static_cast<double>(all[f][3]), static_cast<double>(all[f][4]),
                       static_cast<double>(all[f][5])});
  }
  return {std::move(points), std::move(faces), std::move(values), midside};
}

struct Counts {
  std::uint64_t triangles = 0, levels = 0, pairs = 0, wrong = 0;
  Failures failures;
  std::array<std::array<std::uint64_t, 4>, 2> cases{};  // <F, L>
};

/// One face's nodes, numbered as the oracle's boundary, the face-critical node last.
struct FaceTiles {
  std::vector<Index> nodes;
  std::vector<Fraction> values;
  std::vector<std::array<std::size_t, 2>> edges;
  bool fan = false;
};

struct NodeNumbers {
  std::vector<Index> of_edge, of_face;
  NodeNumbers(const QuadraticMesh& mesh, const TileComplex& t)
      : of_edge(mesh.edge_count(), kernel::kNone), of_face(mesh.face_count(), kernel::kNone) {
    Index n = t.vertex_count;
    for (Index e : t.critical_edges) of_edge[e] = n++;
    for (Index f : t.critical_faces) of_face[f] = n++;
  }
};

FaceTiles face_tiles(const QuadraticMesh& mesh, const TileComplex& t, const NodeNumbers& numbers,
                     Index f, const QuadraticTriangle& oracle, Counts& counts) {
  FaceTiles result;
  for (std::size_t k = 0; k < 3; ++k) {
    result.nodes.push_back(mesh.faces()[f][k]);
    const Index n = numbers.of_edge[mesh.face_edges()[f][k]];
    if (n != kernel::kNone) result.nodes.push_back(n);
  }
  for (const BoundaryNode& n : oracle.boundary()) result.values.push_back(n.value);
  counts.wrong += result.nodes.size() != oracle.boundary().size();
  result.fan = numbers.of_face[f] != kernel::kNone;
  counts.wrong += result.fan != oracle.has_centre_inside();
  if (result.fan) {
    result.nodes.push_back(numbers.of_face[f]);
    result.values.push_back(oracle.centre_value());
  }
  auto local = [&](Index node) {
    const auto i = std::find(result.nodes.begin(), result.nodes.end(), node);
    counts.wrong += i == result.nodes.end();
    return static_cast<std::size_t>(i - result.nodes.begin()) % result.nodes.size();
  };
  for (Index i = t.tile_begin[f]; i < t.tile_begin[f + 1]; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      result.edges.push_back({local(t.tiles[i][k]), local(t.tiles[i][(k + 1) % 3])});
  return result;
}

// The components of the tiles' edges among the nodes of a sub- or superlevel set, which a
// piecewise-linear level set retracts to.
std::array<std::size_t, 7> components(const FaceTiles& face, const std::array<bool, 7>& in) {
  std::array<std::size_t, 7> root{};
  std::iota(root.begin(), root.end(), std::size_t{0});
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& [i, j] : face.edges)
      if (in[i] && in[j] && root[i] != root[j]) {
        root[i] = root[j] = std::min(root[i], root[j]);
        changed = true;
      }
  }
  return root;
}

void check_level(const FaceTiles& face, const QuadraticTriangle& oracle, const Fraction& c,
                 Counts& counts) {
  ++counts.levels;
  const std::size_t boundary = oracle.boundary().size();
  for (const bool below : {true, false}) {
    std::array<bool, 7> in{};
    for (std::size_t i = 0; i < face.values.size(); ++i)
      in[i] = below ? compare(face.values[i], c) <= 0 : compare(face.values[i], c) >= 0;
    const auto root = components(face, in);
    for (std::size_t i = 0; i < boundary; ++i) {
      if (!in[i]) continue;
      for (std::size_t j = i + 1; j < boundary; ++j) {
        if (!in[j]) continue;
        ++counts.pairs;
        counts.wrong += (root[i] == root[j]) != oracle.joined(i, j, c, below);
      }
      // f is monotone on the segment from the centre to any point.
      if (face.fan && in[boundary]) counts.wrong += root[i] != root[boundary];
    }
  }
}

void check_face(const QuadraticMesh& mesh, const TileComplex& t, const NodeNumbers& numbers,
                Index f, const Nodal& nodal, Counts& counts) {
  const QuadraticTriangle oracle(nodal);
  const FaceTiles face = face_tiles(mesh, t, numbers, f, oracle, counts);
  const std::size_t l = oracle.boundary().size() - 3;
  ++counts.triangles;
  ++counts.cases[face.fan][l];
  counts.failures.expect(!oracle.has_centre_inside() || l != 0, "<1,0> does not occur:", nodal);
  const auto saddles = std::count_if(oracle.boundary().begin(), oracle.boundary().end(),
                                     [](const BoundaryNode& n) { return n.saddle; });
  counts.failures.expect(face.fan || l != 2 || saddles != 2,
                         "<0,2> has no two boundary saddles:", nodal);
  counts.wrong += t.tile_begin[f + 1] - t.tile_begin[f] != l + (face.fan ? 3 : 1);
  // The order is that of the values, ties by number.
  std::vector<Fraction> levels = face.values;
  for (std::size_t i = 0; i < face.nodes.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const int x = compare(face.values[i], face.values[j]);
      const bool first = x < 0 || (x == 0 && face.nodes[i] < face.nodes[j]);
      counts.wrong += (t.rank[face.nodes[i]] < t.rank[face.nodes[j]]) != first;
    }
  std::sort(levels.begin(), levels.end(),
            [](const Fraction& a, const Fraction& b) { return compare(a, b) < 0; });
  for (std::size_t i = 0; i < levels.size(); ++i) {
    check_level(face, oracle, levels[i], counts);
    if (i > 0) check_level(face, oracle, mediant(levels[i - 1], levels[i]), counts);
  }
}

void check_triangles(const std::vector<Nodal>& all, Counts& counts) {
  const QuadraticMesh mesh = separate_triangles(all);
  const TileComplex t = reeb::tessellate(mesh);
  const NodeNumbers numbers(mesh, t);
  for (Index f = 0; f < all.size(); ++f) {
    const std::uint64_t before = counts.wrong;
    check_face(mesh, t, numbers, f, all[f], counts);
    counts.failures.expect(counts.wrong == before, "theorem 4 holds for nodal values", all[f]);
  }
}

// A product of two linear forms: crossing, parallel or equal lines, often through corners.
Nodal line_pair(Draw& d) {
  std::array<int, 3> u, v;
  for (int& x : u) x = d.integer(-3, 3);
  for (int& x : v) x = d.integer(-3, 3);
  if (d.integer(0, 3) == 0) v = u;
  Nodal n;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t l = (k + 1) % 3;
    n[k] = 4 * u[k] * v[k];
    n[3 + k] = (u[k] + u[l]) * (v[k] + v[l]);
  }
  return n;
}

Nodal draw_nodal(Draw& d, std::uint64_t i) {
  if (i % 4 == 0) return line_pair(d);
  const int size = i % 4 == 1 ? 4 : i % 4 == 2 ? 20 : 1000;
  Nodal n;
  for (int& x : n) x = d.integer(-size, size);
  return n;
}

}  // namespace

TEST_CASE("tiles: theorem 4 on all triangles with nodal values -2 .. 2") {
  std::vector<Nodal> all;
  for (int code = 0; code < 15625; ++code) {
    Nodal n;
    int rest = code;
    for (int& x : n) {
      x = rest % 5 - 2;
      rest /= 5;
    }
    all.push_back(n);
  }
  Counts counts;
  check_triangles(all, counts);
  CHECK(counts.triangles == 15625);
  CHECK(counts.levels > 100000);
  CHECK(counts.pairs > 1000000);
  CHECK(counts.failures.report() == "");
  // Every case of the paper's table occurs, and <1,0> does not.
  for (std::size_t f = 0; f < 2; ++f)
    for (std::size_t l = 0; l < 4; ++l) {
      CAPTURE(f, l);
      CHECK((counts.cases[f][l] > 0) == !(f == 1 && l == 0));
    }
}

TEST_CASE("tiles: theorem 4 on a million random triangles", "[stress]") {
  Draw d(301);
  Counts counts;
  const std::uint64_t n = scaled(1000000);
  for (std::uint64_t done = 0; done < n;) {
    std::vector<Nodal> batch;
    for (; batch.size() < 20000 && done < n; ++done) batch.push_back(draw_nodal(d, done));
    check_triangles(batch, counts);
  }
  CHECK(counts.triangles == n);
  CHECK(counts.failures.report() == "");
}

TEST_CASE("tiles: the oracle tells apart what wrong diagonals join") {
  // <0,2> with a boundary saddle on one side: exactly one diagonal agrees.
  std::uint64_t decided = 0;
  for (int code = 0; code < 15625; ++code) {
    Nodal n;
    int rest = code;
    for (int& x : n) {
      x = rest % 5 - 2;
      rest /= 5;
    }
    const QuadraticTriangle oracle(n);
    const auto& b = oracle.boundary();
    if (oracle.has_centre_inside() || b.size() != 5) continue;
    // Start the boundary at A, the first of two corners in a row: A, B, e', C, e.
    std::size_t a = 0;
    while (b[a].corner < 0 || b[(a + 1) % 5].corner < 0) ++a;
    std::array<int, 2> wrong{};
    for (int diagonal = 0; diagonal < 2; ++diagonal) {
      FaceTiles face;
      for (const BoundaryNode& node : b) face.values.push_back(node.value);
      auto add = [&](std::size_t i, std::size_t j) {
        face.edges.push_back({(a + i) % 5, (a + j) % 5});
      };
      for (std::size_t i = 0; i < 5; ++i) add(i, i + 1);
      add(2, 4);
      if (diagonal == 0)
        add(1, 4);
      else
        add(0, 2);
      Counts counts;
      for (const BoundaryNode& node : b) check_level(face, oracle, node.value, counts);
      wrong[static_cast<std::size_t>(diagonal)] = counts.wrong > 0;
    }
    CHECK(wrong[0] + wrong[1] < 2);
    if (wrong[0] + wrong[1] == 1) {
      ++decided;
      CHECK(b[(a + (wrong[0] ? 2 : 4)) % 5].saddle);
    }
  }
  CHECK(decided > 40);
}
