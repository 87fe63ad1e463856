// SPDX-License-Identifier: GPL-3.0-or-later
// Persistence pairs against the reduction of a boundary matrix.
#include <catch2/catch.hpp>
#include <set>

#include "algorithms/reeb/persistence.hpp"
#include "tests/reeb/graph_cases.hpp"
#include "tests/support/environment.hpp"

namespace crest::tests {
namespace {

using kernel::Index;
using reeb::PairKind;
using Key = std::tuple<PairKind, Index, Index>;

/// Extended persistence of the graph: cells going up, then their cones going down (Cohen-Steiner,
/// Edelsbrunner, Harer, Extending persistence using Poincare and Lefschetz duality, 2009).
std::multiset<Key> reduced_pairs(const reeb::ReebGraph& graph) {
  struct Cell {
    bool cone, arc;
    Index number, node;  ///< the node at whose value it comes
  };
  std::vector<Cell> cells;
  const auto nodes = static_cast<Index>(graph.nodes.size());
  const auto arcs = static_cast<Index>(graph.arcs.size());
  for (Index i = 0; i < nodes; ++i) {
    cells.push_back({false, false, i, i});
    for (Index a = 0; a < arcs; ++a)
      if (graph.arcs[a].upper == i) cells.push_back({false, true, a, i});
  }
  for (Index i = nodes; i-- > 0;) {
    cells.push_back({true, false, i, i});
    for (Index a = 0; a < arcs; ++a)
      if (graph.arcs[a].lower == i) cells.push_back({true, true, a, i});
  }
  std::vector<Index> node_at(nodes), arc_at(arcs), node_cone(nodes), arc_cone(arcs);
  for (Index i = 0; i < cells.size(); ++i) {
    auto& at =
        cells[i].cone ? (cells[i].arc ? arc_cone : node_cone) : (cells[i].arc ? arc_at : node_at);
    at[cells[i].number] = i;
  }
  // The apex of the cones counts as never born: boundaries are relative to it.
  std::vector<std::set<Index>> columns(cells.size());
  std::vector<Index> owner(cells.size(), kernel::kNone);
  std::multiset<Key> pairs;
  const auto add = [](std::set<Index>& a, const std::set<Index>& b) {
    for (const Index x : b)
      if (!a.erase(x)) a.insert(x);
  };
  for (Index i = 0; i < cells.size(); ++i) {
    const Cell& c = cells[i];
    std::set<Index>& column = columns[i];
    if (c.arc) {
      const auto& ends = c.cone ? node_cone : node_at;
      column = {ends[graph.arcs[c.number].lower]};
      add(column, {ends[graph.arcs[c.number].upper]});
      if (c.cone) column.insert(arc_at[c.number]);
    } else if (c.cone) {
      column = {node_at[c.number]};
    }
    while (!column.empty() && owner[*column.rbegin()] != kernel::kNone)
      add(column, columns[owner[*column.rbegin()]]);
    if (column.empty()) continue;
    const Index low = *column.rbegin();
    owner[low] = i;
    const Cell& birth = cells[low];
    const Index a = std::min(birth.node, c.node), b = std::max(birth.node, c.node);
    if (a == b) continue;
    const PairKind kind = !birth.cone && !c.cone ? PairKind::minimum
                          : birth.cone           ? PairKind::maximum
                          : birth.arc            ? PairKind::loop
                                                 : PairKind::component;
    pairs.insert({kind, a, b});
  }
  return pairs;
}

void check_pairs(const Surface& s, const std::vector<double>& values) {
  const OrderedCase c(s, values);
  const reeb::ReebGraph graph = reeb::reeb_graph(c.complex());
  const auto pairs = reeb::persistence_pairs(graph, values);
  std::multiset<Key> ours;
  std::array<std::size_t, 4> counts{};
  double last = 0;
  for (const auto& p : pairs) {
    ours.insert({p.kind, p.lower, p.upper});
    ++counts[static_cast<std::size_t>(p.kind)];
    CHECK(p.lower < p.upper);
    CHECK(p.persistence ==
          values[graph.nodes[p.upper].vertex] - values[graph.nodes[p.lower].vertex]);
    CHECK(p.persistence >= last);
    last = p.persistence;
  }
  CHECK(ours == reduced_pairs(graph));
  std::array<std::size_t, 3> kinds{};
  for (const auto& n : graph.nodes) ++kinds[static_cast<std::size_t>(n.kind)];
  CHECK(counts[0] + counts[2] == kinds[0]);
  CHECK(counts[1] + counts[2] == kinds[2]);
  CHECK(counts[2] == graph.components);
  CHECK(counts[3] == graph.loops());
}

TEST_CASE("Persistence pairs equal those of the boundary matrix") {
  for (const SurfaceRow& row : surface_rows()) {
    const Surface s = row.make();
    for (std::uint64_t seed = 0; seed < scaled(4); ++seed) {
      INFO(row.name << ", seed " << seed);
      check_pairs(s, noise_values(s, kSeed + seed));
      check_pairs(s, smooth_values(s, kSeed + seed));
      check_pairs(s, quantised(noise_values(s, kSeed + seed), 0.25));
    }
  }
}

TEST_CASE("Persistence pairs of a surface of genus 16") {
  const Surface s = plate(36, 16, true);
  for (std::uint64_t seed = 0; seed < scaled(4); ++seed) {
    INFO("seed " << seed);
    check_pairs(s, smooth_values(s, kSeed + seed));
    check_pairs(s, noise_values(s, kSeed + seed));
  }
}

}  // namespace
}  // namespace crest::tests
