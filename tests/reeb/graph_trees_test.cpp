// SPDX-License-Identifier: GPL-3.0-or-later
// Merge trees and contour trees.
#include <catch2/catch.hpp>
#include <map>
#include <set>
#include <stdexcept>

#include "algorithms/reeb/contour_tree.hpp"
#include "tests/reeb/graph_cases.hpp"
#include "tests/support/environment.hpp"

namespace crest::tests {
namespace {

using kernel::Index;
using kernel::kNone;

/// The reduced join tree by flooding, as vertex -> parent vertex.
std::map<Index, Index> flooded(const reeb::OrderedComplex& complex) {
  const std::size_t n = complex.rank.size();
  std::vector<std::set<Index>> neighbours(n);
  for (const auto& t : complex.triangles)
    for (std::size_t k = 0; k < 3; ++k) neighbours[t[k]].insert({t[(k + 1) % 3], t[(k + 2) % 3]});
  std::vector<Index> part(n, kNone), tip(n);  // part of a vertex; the last node of a part
  std::map<Index, Index> tree;
  for (const Index v : complex.order) {
    std::set<Index> parts;
    for (const Index w : neighbours[v])
      if (part[w] != kNone) parts.insert(part[w]);
    if (parts.size() == 1) {
      part[v] = *parts.begin();
      continue;
    }
    part[v] = v;
    tip[v] = v;
    tree[v] = kNone;
    for (const Index p : parts) {
      tree[tip[p]] = v;
      for (Index& x : part)
        if (x == p) x = v;
    }
  }
  // Roots are the last vertices of the components.
  std::map<Index, Index> last;
  for (const Index v : complex.order) last[part[v]] = v;
  for (const auto& [p, v] : last) {
    if (v == tip[p]) continue;
    tree[tip[p]] = v;
    tree[v] = kNone;
  }
  return tree;
}

std::map<Index, Index> as_map(const reeb::MergeTree& tree) {
  std::map<Index, Index> out;
  for (std::size_t i = 0; i < tree.vertices.size(); ++i)
    out[tree.vertices[i]] = tree.parent[i] == kNone ? kNone : tree.vertices[tree.parent[i]];
  return out;
}

reeb::MergeTree with_vertices(reeb::MergeTree tree, const reeb::ReebGraph& graph) {
  for (Index& v : tree.vertices) v = graph.nodes[v].vertex;
  return tree;
}

TEST_CASE("Join and split trees equal the flooded ones") {
  for (const SurfaceRow& row : surface_rows()) {
    const Surface s = row.make();
    for (std::uint64_t seed = 0; seed < scaled(6); ++seed) {
      INFO(row.name << ", seed " << seed);
      std::vector<double> values = noise_values(s, kSeed + seed);
      if (seed % 3 == 1) values = smooth_values(s, kSeed + seed);
      if (seed % 3 == 2) values = quantised(values, 0.25);
      const OrderedCase c(s, values);
      const reeb::MergeTree join = reeb::augmented_join_tree(c.complex());
      CHECK(as_map(reeb::reduced(join)) == flooded(c.complex()));
      VertexOrder down;
      down.order.assign(c.complex().order.rbegin(), c.complex().order.rend());
      down.rank.resize(down.order.size());
      for (Index i = 0; i < down.order.size(); ++i) down.rank[down.order[i]] = i;
      const reeb::MergeTree split = reeb::augmented_split_tree(c.complex());
      CHECK(as_map(reeb::reduced(split)) == flooded({s.triangles, down.rank, down.order}));
      const reeb::ReebGraph graph = reeb::reeb_graph(c.complex());
      CHECK(as_map(with_vertices(reeb::augmented_join_tree(graph), graph)) == as_map(join));
      CHECK(as_map(with_vertices(reeb::augmented_split_tree(graph), graph)) == as_map(split));
    }
  }
}

void check_tree(const Surface& s, const std::vector<double>& values) {
  const OrderedCase c(s, values);
  const reeb::ReebGraph graph = reeb::reeb_graph(c.complex());
  const reeb::ContourTree tree = reeb::contour_tree(c.complex());
  CHECK(graph.loops() == 0);
  std::vector<Index> vertices;
  for (const auto& n : graph.nodes) vertices.push_back(n.vertex);
  CHECK(tree.vertices == vertices);
  std::vector<std::array<Index, 2>> arcs;
  for (const auto& a : graph.arcs) arcs.push_back({a.lower, a.upper});
  CHECK(tree.arcs == arcs);
}

TEST_CASE("Contour trees equal Reeb graphs where these are trees") {
  using enum Sides;
  const std::vector<Surface> surfaces = {icosphere(3),
                                         strip(19, 21, open, open),
                                         projective_plane(2),
                                         wheel(30, true),
                                         disjoint(strip(7, 6, open, open), icosphere(2)),
                                         plate(17, 0, true)};
  for (const Surface& s : surfaces) {
    for (std::uint64_t seed = 0; seed < scaled(40); ++seed) {
      INFO("seed " << seed);
      check_tree(s, noise_values(s, kSeed + seed));
      check_tree(s, smooth_values(s, kSeed + seed));
      check_tree(s, quantised(noise_values(s, kSeed + seed), 0.25));
    }
    check_tree(s, std::vector<double>(s.points.size(), 1.0));
  }
}

TEST_CASE("Contour trees are refused where there may be loops") {
  for (const SurfaceRow& row : surface_rows()) {
    const Surface s = row.make();
    const OrderedCase c(s, smooth_values(s, kSeed));
    INFO(row.name);
    if (row.euler <= 0 || row.euler == 3)
      CHECK_THROWS_AS(reeb::contour_tree(c.complex()), std::invalid_argument);
    else
      CHECK_NOTHROW(reeb::contour_tree(c.complex()));
  }
}

}  // namespace
}  // namespace crest::tests
