// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Conforming bisection of a part of the partition: first at the middle of AB, which makes Kuhn
// simplices of the tetrahedra, then by Maubach's rule. A tetrahedron that was never bisected has no
// tree and costs nothing.
#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <vector>

#include "algorithms/splines/edge_numbers.hpp"
#include "algorithms/splines/index_blocks.hpp"
#include "algorithms/splines/partition.hpp"
#include "algorithms/splines/quadratic.hpp"

namespace crest::splines {

/// A point of the lattice in 2^-20 steps: corners of leaves down to depth 60.
using FinePoint = std::array<std::int64_t, 3>;
inline constexpr int kFineBits = 20;
using FineCorners = std::array<FinePoint, 4>;

/// By z, then y, then x.
constexpr bool precedes(const FinePoint& a, const FinePoint& b) {
  return a[2] != b[2] ? a[2] < b[2] : a[1] != b[1] ? a[1] < b[1] : a[0] < b[0];
}

/// Tetrahedron `number` of a cube, as 24 cube + number.
using Root = std::uint64_t;

/// What becomes of a leaf: it is bisected, or stays and is known to be one of the others.
enum class Fate : std::uint8_t { bisect, empty, settled, undecided };

class Forest {
 public:
  static constexpr int kDeepest = 60;

  struct Node {
    std::array<kernel::Index, 4> corners;       ///< their numbers
    kernel::Index first_child = kernel::kNone;  ///< the second follows it
    std::uint8_t tag = 0;                       ///< 0: the root's own rule
    std::uint8_t depth = 0;
    Fate fate = Fate::bisect;  ///< of a leaf: what was said of it
  };
  struct Tree {
    Root root;
    kernel::Index node;  ///< the root's
  };
  /// What is to become of a leaf of a tree, by the tree's number.
  using Judge = std::function<Fate(kernel::Index tree, const Node& leaf)>;

  explicit Forest(const Cube& cubes)
      : cubes_(cubes),
        planted_(cubes),
        lattice_points_({2 * cubes[0] + 1, 2 * cubes[1] + 1, 2 * cubes[2] + 1}) {}

  /// Bisects the roots, the leaves that `judge` says, and those that must follow for the leaves to
  /// be conforming, until none is left. `judge` is asked once a new leaf that need not follow.
  /// Order, and so all numbers, depend on nothing but the roots' order.
  void bisect(const std::vector<Root>& roots, const Judge& judge);

  /// In the order in which they were first bisected.
  const std::vector<Tree>& trees() const { return trees_; }
  const Node& node(kernel::Index i) const { return nodes_[i]; }
  const FinePoint& corner(kernel::Index number) const { return points_[number]; }
  FineCorners corners_of(const Node& node) const;
  /// For the 24 tetrahedra of a cube the numbers of their trees, kNone where there is none; or null
  /// if the cube has no tree.
  using Planted = std::array<kernel::Index, kTetrahedra>;
  const Planted* planted(const Cube& cube) const {
    const kernel::Index number = planted_.find(cube);
    return number == kernel::kNone ? nullptr : &cubes_with_trees_[number];
  }
  int depth() const { return depth_; }

  static FineCorners corners_of(const Cube& cube, std::size_t tetrahedron);
  FineCorners corners_of(Root root) const { return corners_of(cube_of(root), root % kTetrahedra); }
  Cube cube_of(Root root) const;
  Root root_of(const Cube& cube, std::size_t tetrahedron) const;

 private:
  struct Place {
    kernel::Index tree, node;
  };
  kernel::Index number_of(const FinePoint& lattice_point);
  void plant(const Cube& cube, std::size_t tetrahedron);
  bool must_follow(const Node& leaf) const;
  void split(const Place& place);
  /// Queues the leaves that have the edge a b.
  void follow(kernel::Index a, kernel::Index b, kernel::Index middle);
  void follow(const Cube& cube, kernel::Index a, kernel::Index b, const FinePoint& middle);
  void follow(kernel::Index tree, kernel::Index a, kernel::Index b,
              const std::array<double, 4>& middle);

  Cube cubes_;
  std::vector<FinePoint> points_;
  std::vector<Node> nodes_;
  std::vector<Tree> trees_;
  IndexBlocks planted_;  ///< of cubes: which of these is its
  std::vector<Planted> cubes_with_trees_;
  IndexBlocks lattice_points_;  ///< corners of roots
  EdgeNumbers middles_;         ///< of edges that are bisected: their middles
  std::deque<Place> queue_;
  struct Step {
    kernel::Index node;
    std::array<double, 4> l;  ///< an edge's middle, barycentric; no step rounds it
  };
  std::vector<Step> steps_;  ///< of the walk through a tree, kept for the next one
  int depth_ = 0;
};

}  // namespace crest::splines
