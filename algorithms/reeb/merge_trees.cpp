// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/reeb/merge_trees.hpp"

#include <algorithm>
#include <numeric>

#include "algorithms/reeb/strands.hpp"
#include "kernel/geometry/disjoint_sets.hpp"

namespace crest::reeb {
namespace {

/// Disjoint sets of nodes, each with its last node.
class Parts {
 public:
  explicit Parts(Index n) : sets_(n), last_(n) { std::iota(last_.begin(), last_.end(), Index{0}); }
  /// Adds the part of `below` to that of `node`, the last of both.
  void add(Index node, Index below, std::vector<Index>& tree) {
    const Index part = sets_.find(below);
    if (!sets_.unite(part, node)) return;
    tree[last_[part]] = node;
    last_[sets_.find(node)] = node;
  }

 private:
  kernel::DisjointSets sets_;
  std::vector<Index> last_;  ///< by a part's name
};

OrderedComplex upside_down(const OrderedComplex& complex, std::vector<Index>& rank,
                           std::vector<Index>& order) {
  order.assign(complex.order.rbegin(), complex.order.rend());
  rank.resize(order.size());
  for (Index i = 0; i < order.size(); ++i) rank[order[i]] = i;
  return {complex.triangles, rank, order};
}

MergeTree tree_of_graph(const ReebGraph& graph, bool join) {
  const auto n = static_cast<Index>(graph.nodes.size());
  const auto place = [&](Index node) { return join ? node : n - 1 - node; };
  MergeTree tree;
  tree.parent.assign(n, kNone);
  for (Index i = 0; i < n; ++i) tree.vertices.push_back(place(i));
  // The arcs by their later end.
  std::vector<Index> begin(n + std::size_t{2}, 0), from(graph.arcs.size());
  const auto later = [&](const ReebArc& a) { return place(join ? a.upper : a.lower); };
  for (const ReebArc& a : graph.arcs) ++begin[later(a) + 2];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  for (const ReebArc& a : graph.arcs) from[begin[later(a) + 1]++] = place(join ? a.lower : a.upper);
  Parts parts(n);
  for (Index i = 0; i < n; ++i)
    for (Index k = begin[i]; k < begin[i + 1]; ++k) parts.add(i, from[k], tree.parent);
  return tree;
}

}  // namespace

MergeTree augmented_join_tree(const OrderedComplex& complex) {
  VertexStars stars(complex.triangles, static_cast<Index>(complex.rank.size()));
  const StrandLists strands = find_strands(complex, stars, {});
  const auto count = static_cast<Index>(strands.stops.size() - 1);
  MergeTree tree;
  std::vector<Index> node_of_stop(count), stop_at(complex.rank.size(), kNone);
  for (Index s = 0; s < count; ++s) stop_at[complex.rank[strands.stops[s].vertex]] = s;
  for (const Index s : stop_at) {
    if (s == kNone) continue;
    node_of_stop[s] = static_cast<Index>(tree.vertices.size());
    tree.vertices.push_back(strands.stops[s].vertex);
  }
  std::vector<Index> bottom(strands.turned.size());
  for (Index s = 0; s < count; ++s) {
    const Index first = strands.upper[strands.stops[s].upper_begin].strand_begin;
    const Index last = strands.upper[strands.stops[s + 1].upper_begin].strand_begin;
    for (Index k = first; k < last; ++k) bottom[k] = node_of_stop[s];
  }
  tree.parent.assign(count, kNone);
  Parts parts(count);
  for (const Index s : stop_at) {
    if (s == kNone) continue;
    for (Index i = strands.stops[s].lower_begin; i < strands.stops[s + 1].lower_begin; ++i)
      parts.add(node_of_stop[s], bottom[strands.strand_above[i]], tree.parent);
  }
  return tree;
}

MergeTree augmented_split_tree(const OrderedComplex& complex) {
  std::vector<Index> rank, order;
  return augmented_join_tree(upside_down(complex, rank, order));
}

MergeTree augmented_join_tree(const ReebGraph& graph) {
  return tree_of_graph(graph, true);
}
MergeTree augmented_split_tree(const ReebGraph& graph) {
  return tree_of_graph(graph, false);
}

MergeTree reduced(const MergeTree& tree) {
  std::vector<std::uint8_t> children(tree.parent.size(), 0);
  for (const Index p : tree.parent)
    if (p != kNone && children[p] < 2) ++children[p];
  const auto kept = [&](Index i) { return children[i] != 1 || tree.parent[i] == kNone; };
  MergeTree out;
  std::vector<Index> place(tree.parent.size(), kNone);
  for (Index i = 0; i < tree.parent.size(); ++i) {
    if (!kept(i)) continue;
    place[i] = static_cast<Index>(out.vertices.size());
    out.vertices.push_back(tree.vertices[i]);
  }
  // Parents come later, so from the roots down: the next kept node at or above each.
  for (Index i = static_cast<Index>(tree.parent.size()); i-- > 0;)
    if (!kept(i)) place[i] = place[tree.parent[i]];
  for (Index i = 0; i < tree.parent.size(); ++i)
    if (kept(i)) out.parent.push_back(tree.parent[i] == kNone ? kNone : place[tree.parent[i]]);
  return out;
}

std::vector<std::array<Index, 2>> arcs_of(const ReebGraph& graph, const MergeTree& tree) {
  std::vector<std::array<Index, 2>> arcs;
  for (std::size_t i = 0; i < tree.vertices.size(); ++i) {
    if (tree.parent[i] == kernel::kNone) continue;
    // Positions in graph.nodes ascend with the values.
    const auto [low, high] = std::minmax(tree.vertices[i], tree.vertices[tree.parent[i]]);
    arcs.push_back({graph.nodes[low].vertex, graph.nodes[high].vertex});
  }
  return arcs;
}

}  // namespace crest::reeb
