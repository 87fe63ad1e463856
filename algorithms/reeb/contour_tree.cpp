// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/reeb/contour_tree.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "algorithms/reeb/strands.hpp"

namespace crest::reeb {
namespace {

/// A merge tree over nodes in ascending order, from which nodes with at most one child are taken.
class ShrinkingTree {
 public:
  explicit ShrinkingTree(std::vector<Index> parent)
      : parent_(std::move(parent)), children_(parent_.size(), 0), child_sum_(parent_.size(), 0) {
    for (Index i = 0; i < parent_.size(); ++i) {
      if (parent_[i] == kNone) continue;
      ++children_[parent_[i]];
      child_sum_[parent_[i]] ^= i;
    }
  }
  Index children(Index i) const { return children_[i]; }
  Index parent(Index i) const { return parent_[i]; }
  /// The xor of the children names the only one.
  void remove(Index i) {
    const Index up = parent_[i], down = child_sum_[i];
    if (children_[i] == 1) parent_[down] = up;
    if (up == kNone) return;
    child_sum_[up] ^= i;
    if (children_[i] == 1)
      child_sum_[up] ^= down;
    else
      --children_[up];
  }

 private:
  std::vector<Index> parent_, children_, child_sum_;
};

/// Euler characteristics of the components, by join trees' roots.
void require_no_loops(const OrderedComplex& complex, const MergeTree& join) {
  const std::size_t n = join.vertices.size();
  std::vector<Index> root(n), node_of(complex.rank.size(), kNone);
  for (std::size_t i = n; i-- > 0;) {
    root[i] = join.parent[i] == kNone ? static_cast<Index>(i) : root[join.parent[i]];
    node_of[join.vertices[i]] = static_cast<Index>(i);
  }
  std::vector<std::int64_t> euler(n, 0);
  VertexStars stars(complex.triangles, static_cast<Index>(complex.rank.size()));
  const StrandLists strands = find_strands(complex, stars, {});
  for (Index s = 0; s + 1 < strands.stops.size(); ++s) {
    const bool disk = strands.upper_count(s) == 0 && strands.stops[s].closed;
    const std::int64_t lower = strands.lower_count(s);
    euler[root[node_of[strands.stops[s].vertex]]] += disk ? 1 : 1 - lower;
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (root[i] == i && euler[i] < 1) {
      throw std::invalid_argument(
          "a contour tree needs a simply connected surface; this one has a component with Euler "
          "characteristic " +
          std::to_string(euler[i]) + " (take the Reeb graph)");
    }
  }
}

}  // namespace

ContourTree merged(const MergeTree& join, const MergeTree& split) {
  const auto n = static_cast<Index>(join.vertices.size());
  if (split.vertices.size() != n ||
      !std::equal(join.vertices.begin(), join.vertices.end(), split.vertices.rbegin()))
    throw std::invalid_argument("join and split tree have different nodes");
  std::vector<Index> down(n, kNone);
  for (Index i = 0; i < n; ++i)
    if (split.parent[i] != kNone) down[n - 1 - i] = n - 1 - split.parent[i];
  ShrinkingTree below(join.parent), above(std::move(down));
  ContourTree tree;
  tree.vertices = join.vertices;
  std::vector<Index> leaves;
  const auto is_leaf = [&](Index i) { return below.children(i) + above.children(i) == 1; };
  for (Index i = n; i-- > 0;)
    if (is_leaf(i)) leaves.push_back(i);
  while (!leaves.empty()) {
    const Index i = leaves.back();
    leaves.pop_back();
    if (!is_leaf(i)) continue;  // the last one of its component
    const bool is_minimum = below.children(i) == 0;
    const Index next = is_minimum ? below.parent(i) : above.parent(i);
    if (next == kNone) break;
    tree.arcs.push_back({std::min(i, next), std::max(i, next)});
    below.remove(i);
    above.remove(i);
    if (is_leaf(next)) leaves.push_back(next);
  }
  const auto roots =
      static_cast<std::size_t>(std::count(join.parent.begin(), join.parent.end(), kNone));
  if (tree.arcs.size() + roots != n)
    throw std::invalid_argument("no contour tree has this join and this split tree");
  std::sort(tree.arcs.begin(), tree.arcs.end());
  return tree;
}

ContourTree contour_tree(const OrderedComplex& complex) {
  const MergeTree join = augmented_join_tree(complex);
  require_no_loops(complex, join);
  return merged(join, augmented_split_tree(complex));
}

std::vector<std::array<Index, 2>> arcs_of(const ContourTree& tree) {
  std::vector<std::array<Index, 2>> arcs;
  for (const auto& [low, high] : tree.arcs)
    arcs.push_back({tree.vertices[low], tree.vertices[high]});
  return arcs;
}

}  // namespace crest::reeb
