// SPDX-License-Identifier: GPL-3.0-or-later
// What holds for every Reeb graph: Euler's relation, loops and genus, degrees; and the cuts.
#include <catch2/catch.hpp>

#include "algorithms/reeb/cuts.hpp"
#include "tests/reeb/graph_cases.hpp"
#include "tests/support/environment.hpp"

namespace crest::tests {
namespace {

using kernel::Index;
using reeb::NodeKind;

/// Loops a saddle swallows: the genus of the surface between just below and just above it.
Index absorbed(const reeb::ReebGraph& graph) {
  std::vector<Index> degree(graph.nodes.size(), 0);
  for (const auto& a : graph.arcs) {
    ++degree[a.lower];
    ++degree[a.upper];
  }
  Index sum = 0;
  for (std::size_t i = 0; i < degree.size(); ++i) {
    const auto& n = graph.nodes[i];
    if (n.kind == NodeKind::saddle) {
      CHECK((n.multiplicity + 2 - degree[i]) % 2 == 0);
      sum += (n.multiplicity + 2 - degree[i]) / 2;
    } else {
      CHECK(degree[i] == 1);
    }
  }
  return sum;
}

/// The hypotheses of theorem 6 (certify/reeb/SPEC.md), counted anew.
void check_cuts(const reeb::ReebGraph& graph, const std::vector<Index>& cuts) {
  CHECK(std::is_sorted(cuts.begin(), cuts.end()));
  CHECK(std::adjacent_find(cuts.begin(), cuts.end()) == cuts.end());
  std::vector<Index> parent(graph.nodes.size());
  std::iota(parent.begin(), parent.end(), Index{0});
  const auto find = [&](Index x) {
    while (parent[x] != x) x = parent[x];
    return x;
  };
  std::vector<int> euler(graph.nodes.size(), 0), saddles(graph.nodes.size(), 0);
  std::size_t next = 0;
  for (Index a = 0; a < graph.arcs.size(); ++a) {
    const auto& arc = graph.arcs[a];
    if (next < cuts.size() && cuts[next] == a) {
      ++next;
      euler[arc.lower] += arc.open_below ? 0 : 1;
      euler[arc.upper] += 1;
      continue;
    }
    CHECK(find(arc.lower) != find(arc.upper));  // a forest
    parent[find(arc.lower)] = find(arc.upper);
  }
  CHECK(next == cuts.size());
  std::vector<int> part_euler(graph.nodes.size(), 0);
  for (Index i = 0; i < graph.nodes.size(); ++i) {
    part_euler[find(i)] += euler[i] + graph.nodes[i].index;
    saddles[find(i)] += graph.nodes[i].kind == NodeKind::saddle;
  }
  for (Index i = 0; i < graph.nodes.size(); ++i) {
    CHECK(part_euler[i] <= 2);
    if (find(i) == i) CHECK((part_euler[i] >= 1 || saddles[i] <= 1));
  }
}

void check_properties(const SurfaceRow& row, const Surface& s, const std::vector<double>& values) {
  const OrderedCase c(s, values);
  const reeb::ReebGraph graph = reeb::reeb_graph(c.complex());
  int sum = 0;
  bool simple = true;
  for (const auto& n : graph.nodes) {
    sum += n.index;
    simple = simple && n.multiplicity == 1;
  }
  CHECK(sum == row.euler);
  const std::vector<Index> cuts = reeb::choose_cuts(graph);
  check_cuts(graph, cuts);
  CHECK(cuts.size() >= graph.loops());
  if (row.genus < 0) return;
  const auto genus = static_cast<Index>(row.genus);
  CHECK(graph.loops() == genus - absorbed(graph));
  if (simple) CHECK(graph.loops() == genus);
  if (graph.loops() == genus) CHECK(cuts.size() == genus);
}

TEST_CASE("Euler's relation, genus and cuts on every surface") {
  const auto number = GENERATE(range(0, static_cast<int>(surface_rows().size())));
  const SurfaceRow& row = surface_rows()[static_cast<std::size_t>(number)];
  const Surface s = row.make();
  for (std::uint64_t seed = 0; seed < scaled(40); ++seed) {
    INFO(row.name << ", seed " << seed);
    check_properties(row, s, noise_values(s, kSeed + seed));
    check_properties(row, s, smooth_values(s, kSeed + seed));
    check_properties(row, s, quantised(smooth_values(s, kSeed + seed), 2));
    check_properties(row, s, std::vector<double>(s.points.size(), 0.0));
  }
}

TEST_CASE("A high genus: all loops and as many cuts, smooth and noise") {
  const SurfaceRow row{"genus 16", -30, 16, [] { return plate(48, 16, true); }};
  const Surface s = row.make();
  for (std::uint64_t seed = 0; seed < scaled(10); ++seed) {
    INFO("seed " << seed);
    check_properties(row, s, noise_values(s, kSeed + seed));
    check_properties(row, s, smooth_values(s, kSeed + seed));
    check_properties(row, s, quantised(noise_values(s, kSeed + seed), 0.125));
  }
}

TEST_CASE("A saddle with many runs absorbs handles") {
  // A torus whose function has one minimum, one maximum and one monkey saddle: the seven-vertex
  // torus, all of whose vertices are neighbours.
  Surface s;
  s.points.resize(7);
  for (Index i = 0; i < 7; ++i) {
    s.triangles.push_back({i, (i + 1) % 7, (i + 3) % 7});
    s.triangles.push_back({i, (i + 3) % 7, (i + 2) % 7});
  }
  std::vector<double> values(7);
  std::iota(values.begin(), values.end(), 0.0);
  const SurfaceRow row{"seven-vertex torus", 0, 1, nullptr};
  int absorbing = 0;
  do {
    check_properties(row, s, values);
    absorbing += reeb::reeb_graph(OrderedCase(s, values).complex()).loops() == 0;
  } while (std::next_permutation(values.begin() + 1, values.end()));
  CHECK(absorbing > 0);
}

}  // namespace
}  // namespace crest::tests
