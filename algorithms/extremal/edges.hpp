// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The edges of the grid: which are critical, the type of their zeros, where these are.
#include <vector>

#include "algorithms/extremal/cells.hpp"
#include "algorithms/extremal/edge_net.hpp"

namespace crest::extremal {

enum class EdgeState : std::uint8_t {
  untested,  ///< an end is not active
  plain,     ///< g changes its sign an even number of times
  merely_critical,
  extremal,
  type_undecided,
  undecided,  ///< n was not followed
};

struct CriticalEdge {
  Index edge;
  double place;  ///< of a zero, from the lower end on
};
/// Edges that no cell decides, with what proves them, one after the other: a list an edge would
/// take more than all else that is recorded.
class BisectedEdges {
 public:
  std::vector<Index> edges;
  std::vector<std::uint8_t> trees;  ///< as in Transport
  std::vector<Short3> leaves;       ///< w

  void add(Index edge, const Transport& way) {
    edges.push_back(edge);
    trees.insert(trees.end(), way.tree.begin(), way.tree.end());
    for (const Leaf& leaf : way.leaves) leaves.push_back(leaf.w);
  }
  /// Where an edge's tree and leaves begin.
  struct Place {
    std::size_t edge, tree, leaf;
  };
  /// Of the edge after that one.
  Place after(Place p) const {
    ++p.edge;
    for (std::size_t missing = 1; missing > 0; ++p.tree)
      if (trees[p.tree] == 0) {
        --missing;
        ++p.leaf;
      } else {
        ++missing;
      }
    return p;
  }
  /// One edge of `other`, under this number.
  void add(Index edge, const BisectedEdges& other, const Place& from) {
    const Place to = other.after(from);
    const auto part = [](auto& list, const auto& more, std::size_t begin, std::size_t end) {
      list.insert(list.end(), more.begin() + static_cast<std::ptrdiff_t>(begin),
                  more.begin() + static_cast<std::ptrdiff_t>(end));
    };
    edges.push_back(edge);
    part(trees, other.trees, from.tree, to.tree);
    part(leaves, other.leaves, from.leaf, to.leaf);
  }
};

class Edges {
 public:
  /// Tests of edges that start in `counted` are counted.
  Edges(const Fields& fields, const Nodes& nodes, const Cells& cells,
        const kernel::GridBox& counted);

  EdgeState state(Index e) const { return states_[e]; }
  bool tested(Index e) const {
    return states_[e] != EdgeState::untested && states_[e] != EdgeState::undecided;
  }
  bool critical(Index e) const {
    return states_[e] >= EdgeState::merely_critical && states_[e] <= EdgeState::type_undecided;
  }
  const std::vector<CriticalEdge>& critical_edges() const { return critical_; }
  /// The place of a critical edge among critical_edges().
  std::size_t find(Index e) const;
  const BisectedEdges& bisected() const { return bisected_; }
  const std::vector<Index>& undecided() const { return undecided_; }
  /// Edges by depth of their bisection; those of cells: 0.
  const std::vector<std::size_t>& depths() const { return depths_; }
  std::size_t tests() const { return tests_; }

 private:
  struct Slice {
    std::vector<CriticalEdge> critical;
    BisectedEdges bisected;
    std::vector<Index> undecided;
    std::vector<std::size_t> depths = std::vector<std::size_t>(15);
    std::size_t tests = 0;
    void count(std::size_t depth, std::size_t n) {
      ++depths[depth];
      tests += n;
    }
  };
  void decide(const Node& v, std::size_t axis, Slice& slice);
  std::size_t deciding_cell(const Node& v, std::size_t axis) const;

  const Fields& fields_;
  const Nodes& nodes_;
  const Cells& cells_;
  const kernel::GridBox counted_;
  std::vector<EdgeState> states_;
  std::vector<CriticalEdge> critical_;
  BisectedEdges bisected_;
  std::vector<Index> undecided_;
  std::vector<std::size_t> depths_;
  std::size_t tests_ = 0;
};

}  // namespace crest::extremal
