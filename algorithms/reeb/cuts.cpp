// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/reeb/cuts.hpp"

#include <algorithm>
#include <numeric>

#include "kernel/geometry/disjoint_sets.hpp"

namespace crest::reeb {
namespace {

/// A piece of the surface as far as it is put together: the sum of its indices, which is its Euler
/// characteristic once all its cuts are closed, and its saddles.
struct Piece {
  std::int32_t indices = 0;
  std::uint32_t saddles = 0;
  bool good() const { return indices >= 1 || saddles <= 1; }
};

class Chooser {
 public:
  explicit Chooser(const ReebGraph& graph)
      : graph_(graph),
        pieces_(graph.nodes.size()),
        cut_(graph.arcs.size(), false),
        to_root_(graph.nodes.size(), kNone) {
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      const ReebNode& node = graph.nodes[i];
      pieces_[i] = {node.index, node.kind == NodeKind::saddle ? 1u : 0u};
    }
  }

  std::vector<Index> run() {
    collect_arcs();
    cut_loops();
    grow_forest();
    for (std::size_t i = nodes_.size(); i-- > 0;) settle(nodes_[i]);
    std::vector<Index> cuts;
    for (Index a = 0; a < cut_.size(); ++a)
      if (cut_[a]) cuts.push_back(a);
    return cuts;
  }

 private:
  void collect_arcs();
  std::vector<Index> core() const;
  void cut_loops();
  void grow_forest();
  void settle(Index node);
  void cut(Index arc) {
    cut_[arc] = true;
    pieces_[graph_.arcs[arc].lower].indices += cone_indices(graph_.arcs[arc]).below;
    pieces_[graph_.arcs[arc].upper].indices += cone_indices(graph_.arcs[arc]).above;
  }
  Index across(Index arc, Index node) const {
    const ReebArc& a = graph_.arcs[arc];
    return a.lower == node ? a.upper : a.lower;
  }
  std::int32_t cone_at(Index arc, Index node) const {
    const ConeIndices cones = cone_indices(graph_.arcs[arc]);
    return graph_.arcs[arc].lower == node ? cones.below : cones.above;
  }

  const ReebGraph& graph_;
  std::vector<Piece> pieces_;  ///< by node: of the tree below it, without the arc to its root
  std::vector<bool> cut_;
  std::vector<Index> begin_, arcs_;  ///< the arcs at each node
  std::vector<Index> nodes_;         ///< parents before children
  std::vector<Index> to_root_;       ///< the arc to the parent
};

void Chooser::collect_arcs() {
  begin_.assign(graph_.nodes.size() + 1, 0);
  for (const ReebArc& a : graph_.arcs) {
    ++begin_[a.lower + 1];
    ++begin_[a.upper + 1];
  }
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  arcs_.resize(2 * graph_.arcs.size());
  std::vector<Index> next(begin_.begin(), begin_.end() - 1);
  for (Index i = 0; i < graph_.arcs.size(); ++i) {
    arcs_[next[graph_.arcs[i].lower]++] = i;
    arcs_[next[graph_.arcs[i].upper]++] = i;
  }
}

/// The arcs that are part of a loop or between loops: what is left when ends are taken off.
std::vector<Index> Chooser::core() const {
  std::vector<Index> degree(graph_.nodes.size()), ends;
  std::vector<bool> off(graph_.arcs.size(), false);
  for (Index v = 0; v < degree.size(); ++v) {
    degree[v] = begin_[v + 1] - begin_[v];
    if (degree[v] == 1) ends.push_back(v);
  }
  while (!ends.empty()) {
    const Index node = ends.back();
    ends.pop_back();
    for (Index k = begin_[node]; k < begin_[node + 1]; ++k) {
      if (off[arcs_[k]]) continue;
      off[arcs_[k]] = true;
      const Index other = across(arcs_[k], node);
      if (--degree[other] == 1) ends.push_back(other);
    }
  }
  std::vector<Index> left;
  for (Index a = 0; a < off.size(); ++a)
    if (!off[a]) left.push_back(a);
  return left;
}

/// Cuts in every loop the arc that passes by the most nodes (Kruskal's algorithm): in noise a long
/// contour soon meets a node, so these contours are short, and a checker walks them.
void Chooser::cut_loops() {
  if (graph_.loops() == 0) return;
  std::vector<Index> arcs = core();
  const auto span = [&](Index a) { return graph_.arcs[a].upper - graph_.arcs[a].lower; };
  std::sort(arcs.begin(), arcs.end(),
            [&](Index a, Index b) { return span(a) != span(b) ? span(a) < span(b) : a < b; });
  kernel::DisjointSets joined(static_cast<Index>(graph_.nodes.size()));
  for (const Index a : arcs)
    if (!joined.unite(graph_.arcs[a].lower, graph_.arcs[a].upper)) cut(a);
}

/// Breadth first, without the arcs that are cut.
void Chooser::grow_forest() {
  std::vector<bool> seen(graph_.nodes.size(), false);
  for (Index root = 0; root < graph_.nodes.size(); ++root) {
    if (seen[root]) continue;
    seen[root] = true;
    nodes_.push_back(root);
    for (std::size_t i = nodes_.size() - 1; i < nodes_.size(); ++i) {
      const Index node = nodes_[i];
      for (Index k = begin_[node]; k < begin_[node + 1]; ++k) {
        const Index arc = arcs_[k], other = across(arc, node);
        if (cut_[arc] || seen[other]) continue;
        seen[other] = true;
        to_root_[other] = arc;
        nodes_.push_back(other);
      }
    }
  }
}

/// Puts the pieces of a node's children together, all good if closed at the arc to the node, so
/// that the new one is too. A child that is a disk adds as much as the cone in its place would;
/// every other one adds less.
void Chooser::settle(Index node) {
  struct Child {
    Index arc;
    Piece piece;
    std::int32_t loss;
  };
  std::vector<Child> children;
  Piece sum = pieces_[node];
  if (to_root_[node] != kNone) sum.indices += cone_at(to_root_[node], node);
  for (Index k = begin_[node]; k < begin_[node + 1]; ++k) {
    const Index arc = arcs_[k], other = across(arc, node);
    if (cut_[arc] || arc == to_root_[node]) continue;
    const Piece& p = pieces_[other];
    children.push_back({arc, p, cone_at(arc, node) - p.indices});
    sum.indices += p.indices;
    sum.saddles += p.saddles;
  }
  if (!sum.good()) {
    std::sort(children.begin(), children.end(), [](const Child& a, const Child& b) {
      return a.loss != b.loss ? a.loss > b.loss : a.arc < b.arc;
    });
  }
  // First the children with a loss; if that does not do, all that have saddles.
  for (const Child& c : children) {
    if (sum.good()) break;
    if (c.loss <= 0 && c.piece.saddles == 0) continue;
    cut(c.arc);
    sum.indices += c.loss;
    sum.saddles -= c.piece.saddles;
  }
  if (to_root_[node] != kNone) sum.indices -= cone_at(to_root_[node], node);
  pieces_[node] = sum;
}

}  // namespace

std::vector<Index> choose_cuts(const ReebGraph& graph) {
  return Chooser(graph).run();
}

}  // namespace crest::reeb
