// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/reeb/persistence.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include "kernel/geometry/disjoint_sets.hpp"

namespace crest::reeb {
namespace {

/// A chain of arcs between two nodes with its lowest and highest node.
struct Chain {
  Index from, to, lowest, highest;
};

/// The arcs that lie on cycles or between them, as chains: leaves taken off, nodes of degree 2
/// passed through. At most 3 chains a loop.
class Core {
 public:
  explicit Core(const ReebGraph& graph) : graph_(graph), begin_(graph.nodes.size() + 2, 0) {
    for (const ReebArc& a : graph.arcs) {
      ++begin_[a.lower + 2];
      ++begin_[a.upper + 2];
    }
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    at_.resize(2 * graph.arcs.size());
    for (Index i = 0; i < graph.arcs.size(); ++i) {
      at_[begin_[graph.arcs[i].lower + 1]++] = i;
      at_[begin_[graph.arcs[i].upper + 1]++] = i;
    }
    gone_.assign(graph.arcs.size(), false);
    next_.assign(begin_.begin(), begin_.end() - 1);
    for (Index i = 0; i < graph.nodes.size(); ++i) degree_.push_back(begin_[i + 1] - begin_[i]);
    for (Index i = 0; i < graph.nodes.size(); ++i) take_off(i);
  }

  std::vector<Chain> chains() {
    std::vector<Chain> out;
    for (Index i = 0; i < degree_.size(); ++i)
      if (degree_[i] >= 3) walk_from(i, out);
    for (Index i = 0; i < degree_.size(); ++i) walk_from(i, out);  // cycles without a branch
    return out;
  }

 private:
  Index next_arc(Index node) {
    for (Index& k = next_[node]; k < begin_[node + 1]; ++k)
      if (!gone_[at_[k]]) return at_[k];
    return kNone;
  }
  Index across(Index arc, Index node) const {
    const ReebArc& a = graph_.arcs[arc];
    return a.lower == node ? a.upper : a.lower;
  }
  void take_off(Index node) {
    while (degree_[node] == 1) {
      const Index arc = next_arc(node);
      gone_[arc] = true;
      --degree_[node];
      node = across(arc, node);
      --degree_[node];
    }
  }
  void walk_from(Index start, std::vector<Chain>& out) {
    for (Index arc = next_arc(start); arc != kNone; arc = next_arc(start)) {
      Chain chain{start, start, start, start};
      do {
        gone_[arc] = true;
        chain.to = across(arc, chain.to);
        chain.lowest = std::min(chain.lowest, chain.to);
        chain.highest = std::max(chain.highest, chain.to);
        if (degree_[chain.to] != 2 || chain.to == start) break;
        arc = next_arc(chain.to);
      } while (true);
      out.push_back(chain);
    }
  }

  const ReebGraph& graph_;
  std::vector<Index> begin_, at_, degree_;
  std::vector<Index> next_;  ///< by node: no arc before this place is left
  std::vector<bool> gone_;
};

/// Spanning forest of the chains so far that maximizes their lowest nodes, as parent pointers.
class HighestForest {
 public:
  explicit HighestForest(std::size_t nodes)
      : parent_(nodes, kNone), key_(nodes, kNone), mark_(nodes, 0) {}

  /// Adds a chain. Returns the lowest node of the chain that leaves the forest because it is the
  /// lowest of a cycle, or kNone.
  Index add(const Chain& chain) {
    Index a = chain.from, b = chain.to, removed = kNone;
    const Index meet = common_ancestor(a, b);
    if (meet != kNone) {
      Index weakest = kNone;
      for (const Index start : {a, b}) {
        for (Index x = start; x != meet; x = parent_[x])
          if (weakest == kNone || key_[x] < key_[weakest]) weakest = x;
      }
      if (weakest == kNone || key_[weakest] >= chain.lowest) return chain.lowest;
      removed = key_[weakest];
      parent_[weakest] = kNone;
      if (root(b) != weakest) std::swap(a, b);
    }
    reroot(b);
    parent_[b] = a;
    key_[b] = chain.lowest;
    return removed;
  }

 private:
  Index root(Index x) const {
    while (parent_[x] != kNone) x = parent_[x];
    return x;
  }
  Index common_ancestor(Index a, Index b) {
    ++stamp_;
    for (Index x = a; x != kNone; x = parent_[x]) mark_[x] = stamp_;
    for (Index x = b; x != kNone; x = parent_[x])
      if (mark_[x] == stamp_) return x;
    return kNone;
  }
  void reroot(Index x) {
    Index above = kNone, key = kNone;
    while (x != kNone) {
      const Index next = std::exchange(parent_[x], above);
      const Index next_key = std::exchange(key_[x], key);
      above = x;
      key = next_key;
      x = next;
    }
  }

  std::vector<Index> parent_, key_, mark_;
  Index stamp_ = 0;
};

/// Merging parts as the level passes the nodes: part -> its first node.
class Sweep {
 public:
  Sweep(const ReebGraph& graph, std::span<const double> values, bool up)
      : graph_(graph), values_(values), up_(up), parts_(static_cast<Index>(graph.nodes.size())) {}

  /// Joins the parts of an arc at its later end; the younger one ends there, unless that end is
  /// all it is.
  void pass(const ReebArc& arc, std::vector<PersistencePair>& out) {
    const Index later = up_ ? arc.upper : arc.lower;
    const Index a = first(arc.lower), b = first(arc.upper);
    if (!parts_.unite(place(a), place(b))) return;
    const Index younger = up_ ? std::max(a, b) : std::min(a, b);
    if (younger == later) return;
    if (up_)
      out.push_back({PairKind::minimum, younger, later, rise(younger, later)});
    else
      out.push_back({PairKind::maximum, later, younger, rise(later, younger)});
  }
  double rise(Index lower, Index upper) const {
    return values_[graph_.nodes[upper].vertex] - values_[graph_.nodes[lower].vertex];
  }
  /// The first node of a node's part.
  Index first(Index node) { return place(parts_.find(place(node))); }

 private:
  /// Nodes in the order in which the level passes them, and back.
  Index place(Index node) const { return up_ ? node : parts_.size() - 1 - node; }

  const ReebGraph& graph_;
  std::span<const double> values_;
  bool up_;
  kernel::DisjointSets parts_;  ///< of places
};

}  // namespace

std::vector<PersistencePair> persistence_pairs(const ReebGraph& graph,
                                               std::span<const double> values) {
  std::vector<PersistencePair> pairs;
  std::vector<Index> by_upper(graph.arcs.size());
  std::iota(by_upper.begin(), by_upper.end(), Index{0});
  std::stable_sort(by_upper.begin(), by_upper.end(),
                   [&](Index a, Index b) { return graph.arcs[a].upper < graph.arcs[b].upper; });
  Sweep up(graph, values, true), down(graph, values, false);
  for (const Index i : by_upper) up.pass(graph.arcs[i], pairs);
  std::vector<Chain> chains = Core(graph).chains();
  std::sort(chains.begin(), chains.end(),
            [](const Chain& a, const Chain& b) { return a.highest < b.highest; });
  HighestForest forest(chains.empty() ? 0 : graph.nodes.size());
  for (const Chain& chain : chains) {
    const Index lowest = forest.add(chain);
    if (lowest == kNone) continue;
    pairs.push_back({PairKind::loop, lowest, chain.highest, up.rise(lowest, chain.highest)});
  }
  for (std::size_t i = graph.arcs.size(); i-- > 0;) down.pass(graph.arcs[i], pairs);
  std::vector<Index> highest(graph.nodes.size(), kNone);
  for (Index i = 0; i < graph.nodes.size(); ++i) highest[up.first(i)] = i;
  for (Index i = 0; i < graph.nodes.size(); ++i)
    if (highest[i] != kNone)
      pairs.push_back({PairKind::component, i, highest[i], up.rise(i, highest[i])});
  std::sort(pairs.begin(), pairs.end(), [](const PersistencePair& a, const PersistencePair& b) {
    return std::tuple(a.persistence, a.kind, a.lower, a.upper) <
           std::tuple(b.persistence, b.kind, b.lower, b.upper);
  });
  return pairs;
}

}  // namespace crest::reeb
