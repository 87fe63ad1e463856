// SPDX-License-Identifier: GPL-3.0-or-later
// Contracted graphs against the level sets of the function itself, ties and all.
#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "algorithms/reeb/contraction.hpp"
#include "tests/reeb/graph_cases.hpp"
#include "tests/support/random.hpp"

namespace crest::tests {
namespace {

using kernel::Index;
using kernel::kNone;

/// Value, index, arcs below, arcs above.
using NodeSign = std::tuple<double, int, int, int>;
using ArcSign = std::tuple<NodeSign, NodeSign, bool>;
struct Signs {
  std::multiset<NodeSign> nodes;
  std::multiset<ArcSign> arcs;
  bool operator==(const Signs&) const = default;
};

/// Signs of a graph given by arcs between nodes.
struct PlainArc {
  Index lower, upper;
  bool open_below, open_above;
};
Signs signs_of(std::vector<double> values, std::vector<int> indices, std::vector<PlainArc> arcs) {
  // Nodes in the middle of an arc go.
  for (Index i = 0; i < values.size(); ++i) {
    std::vector<std::size_t> below, above;
    for (std::size_t a = 0; a < arcs.size(); ++a) {
      if (arcs[a].upper == i) below.push_back(a);
      if (arcs[a].lower == i) above.push_back(a);
    }
    if (below.size() != 1 || above.size() != 1 || indices[i] != 0) continue;
    if (arcs[below[0]].open_above != arcs[above[0]].open_below) continue;
    arcs[below[0]].upper = arcs[above[0]].upper;
    arcs[below[0]].open_above = arcs[above[0]].open_above;
    arcs.erase(arcs.begin() + static_cast<std::ptrdiff_t>(above[0]));
    indices[i] = 1000;
  }
  std::vector<NodeSign> nodes;
  for (Index i = 0; i < values.size(); ++i) nodes.push_back({values[i], indices[i], 0, 0});
  for (const auto& a : arcs) {
    ++std::get<3>(nodes[a.lower]);
    ++std::get<2>(nodes[a.upper]);
  }
  Signs signs;
  for (const auto& n : nodes)
    if (std::get<1>(n) != 1000) signs.nodes.insert(n);
  for (const auto& a : arcs) signs.arcs.insert({nodes[a.lower], nodes[a.upper], a.open_below});
  return signs;
}

class LevelSets {
 public:
  LevelSets(const Surface& s, const std::vector<double>& values) : s_(s), f_(values) {
    for (const auto& t : s.triangles)
      for (std::size_t k = 0; k < 3; ++k) ++edges_[std::minmax(t[k], t[(k + 1) % 3])];
    for (const auto& [e, n] : edges_) list_.push_back({e.first, e.second});
  }

  Signs signs() {
    const std::set<double> all(f_.begin(), f_.end());
    const std::vector<double> levels(all.begin(), all.end());
    std::vector<double> values;
    std::vector<int> indices;
    std::vector<PlainArc> arcs;
    std::vector<Index> slab;  // by edge: the arc it crosses just below the level
    for (std::size_t i = 0; i < levels.size(); ++i) {
      const double c = levels[i];
      // What is at the level: vertices, then edges that cross it.
      const auto at =
          components([&](Index v) { return f_[v] == c; },
                     [&](const auto& e) {
                       return std::min(f_[e[0]], f_[e[1]]) < c && std::max(f_[e[0]], f_[e[1]]) > c;
                     });
      std::map<Index, Index> node;
      for (const Index x : at) {
        if (x != kNone && node.try_emplace(x, Index(values.size())).second) {
          values.push_back(c);
          indices.push_back(0);
        }
      }
      count_cells(c, at, node, indices);
      const auto touches = [&](std::size_t e) {
        for (const Index v : list_[e])
          if (f_[v] == c) return node[at[v]];
        return node[at[f_.size() + e]];
      };
      std::set<std::array<Index, 2>> ended;
      for (std::size_t e = 0; e < list_.size(); ++e)
        if (!slab.empty() && slab[e] != kNone) arcs[slab[e]].upper = touches(e);
      slab.assign(list_.size(), kNone);
      if (i + 1 == levels.size()) break;
      const auto above =
          components([](Index) { return false; },
                     [&](const auto& e) {
                       return std::min(f_[e[0]], f_[e[1]]) <= c && std::max(f_[e[0]], f_[e[1]]) > c;
                     });
      std::map<Index, Index> arc;
      for (std::size_t e = 0; e < list_.size(); ++e) {
        const Index x = above[f_.size() + e];
        if (x == kNone) continue;
        const auto [it, fresh] = arc.try_emplace(x, Index(arcs.size()));
        if (fresh) arcs.push_back({touches(e), kNone, false, false});
        slab[e] = it->second;
        if (edges_[{list_[e][0], list_[e][1]}] == 1)
          arcs[it->second].open_below = arcs[it->second].open_above = true;
      }
    }
    return signs_of(values, indices, arcs);
  }

 private:
  /// Components of a level set, elements being vertices and (after them) edges, through triangles.
  template <class OnVertex, class OnEdge>
  std::vector<Index> components(OnVertex on_vertex, OnEdge on_edge) const {
    const std::size_t n = f_.size();
    std::vector<Index> parent(n + list_.size(), kNone);
    for (Index v = 0; v < n; ++v)
      if (on_vertex(v)) parent[v] = v;
    for (std::size_t e = 0; e < list_.size(); ++e)
      if (on_edge(list_[e])) parent[n + e] = Index(n + e);
    const auto find = [&](Index x) {
      while (parent[x] != x) x = parent[x];
      return x;
    };
    for (const auto& t : s_.triangles) {
      Index last = kNone;
      const auto join = [&](Index x) {
        if (parent[x] == kNone) return;
        if (last != kNone) parent[find(x)] = find(last);
        last = x;
      };
      for (std::size_t k = 0; k < 3; ++k) {
        join(t[k]);
        join(Index(n + edge(t[k], t[(k + 1) % 3])));
      }
    }
    for (Index x = 0; x < parent.size(); ++x)
      if (parent[x] != kNone) parent[x] = find(x);
    return parent;
  }
  std::size_t edge(Index a, Index b) const {
    const std::array<Index, 2> e = {std::min(a, b), std::max(a, b)};
    return std::size_t(std::lower_bound(list_.begin(), list_.end(), e) - list_.begin());
  }
  /// Cells whose highest value is c count where their highest vertices are.
  void count_cells(double c, const std::vector<Index>& at, std::map<Index, Index>& node,
                   std::vector<int>& indices) const {
    const auto count = [&](std::initializer_list<Index> cell) {
      Index top = *cell.begin();
      for (const Index v : cell)
        if (f_[v] > f_[top]) top = v;
      if (f_[top] == c) indices[node[at[top]]] += cell.size() % 2 ? 1 : -1;
    };
    for (Index v = 0; v < f_.size(); ++v) count({v});
    for (const auto& e : list_) count({e[0], e[1]});
    for (const auto& t : s_.triangles) count({t[0], t[1], t[2]});
  }

  const Surface& s_;
  const std::vector<double>& f_;
  std::map<std::pair<Index, Index>, int> edges_;
  std::vector<std::array<Index, 2>> list_;
};

Signs contracted_signs(const Surface& s, const std::vector<double>& values) {
  const OrderedCase c(s, values);
  const reeb::ReebGraph graph = reeb::reeb_graph(c.complex());
  std::vector<std::uint8_t> tied(values.size(), 0);
  for (std::size_t r = 1; r < values.size(); ++r)
    tied[r] = values[c.complex().order[r]] == values[c.complex().order[r - 1]];
  const reeb::ContractedGraph out = reeb::contract(graph, c.complex().rank, tied);
  // Where the old parts went.
  for (Index i = 0; i < graph.nodes.size(); ++i) {
    CHECK((out.node_of_node[i] == kNone) != (out.arc_of_node[i] == kNone));
    if (out.node_of_node[i] == kNone) continue;
    CHECK(values[out.graph.nodes[out.node_of_node[i]].vertex] == values[graph.nodes[i].vertex]);
  }
  for (Index a = 0; a < graph.arcs.size(); ++a) {
    const Index lower = graph.arcs[a].lower, upper = graph.arcs[a].upper;
    const bool flat = values[graph.nodes[lower].vertex] == values[graph.nodes[upper].vertex];
    CHECK((out.arc_of_arc[a] == kNone) == flat);
    if (flat || out.node_of_node[lower] == kNone) continue;
    CHECK(out.graph.arcs[out.arc_of_arc[a]].lower == out.node_of_node[lower]);
  }
  std::vector<double> at;
  std::vector<int> indices;
  std::vector<PlainArc> arcs;
  for (const auto& n : out.graph.nodes) {
    at.push_back(values[n.vertex]);
    indices.push_back(n.index);
  }
  for (const auto& a : out.graph.arcs) {
    CHECK(a.lower < a.upper);
    arcs.push_back({a.lower, a.upper, a.open_below != 0, a.open_above != 0});
  }
  const Signs signs = signs_of(at, indices, arcs);
  CHECK(signs.nodes.size() == out.graph.nodes.size());  // nothing left to take out
  return signs;
}

TEST_CASE("Contracted graphs are those of the function itself, whatever the numbering") {
  Random random(kSeed);
  for (const SurfaceRow& row : surface_rows()) {
    const Surface s = row.make();
    for (std::uint64_t seed = 0; seed < scaled(4); ++seed) {
      for (const double step : {0.02, 0.2, 0.5, 2.0}) {
        INFO(row.name << ", seed " << seed << ", step " << step);
        const auto values = quantised(
            seed % 2 ? noise_values(s, kSeed + seed) : smooth_values(s, kSeed + seed, 5), step);
        const Signs truth = LevelSets(s, values).signs();
        CHECK(contracted_signs(s, values) == truth);
        // Renumbered.
        std::vector<Index> number(values.size());
        std::iota(number.begin(), number.end(), 0u);
        std::shuffle(number.begin(), number.end(), random);
        Surface other = turned_at_random(s, random);
        std::vector<double> moved(values.size());
        for (std::size_t v = 0; v < values.size(); ++v) moved[number[v]] = values[v];
        for (auto& t : other.triangles) t = {number[t[0]], number[t[1]], number[t[2]]};
        CHECK(contracted_signs(other, moved) == truth);
      }
    }
  }
}

TEST_CASE("The contracted graph of a constant function is a point for each component") {
  for (const SurfaceRow& row : surface_rows()) {
    const Surface s = row.make();
    const OrderedCase c(s, std::vector<double>(s.points.size(), 3.0));
    const reeb::ReebGraph graph = reeb::reeb_graph(c.complex());
    std::vector<std::uint8_t> tied(s.points.size(), 1);
    tied[0] = 0;
    const auto out = reeb::contract(graph, c.complex().rank, tied).graph;
    CHECK(out.nodes.size() == graph.components);
    CHECK(out.arcs.empty());
    int sum = 0;
    for (const auto& n : out.nodes) sum += n.index;
    CHECK(sum == row.euler);
  }
}

}  // namespace
}  // namespace crest::tests
