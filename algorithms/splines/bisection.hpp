// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Conforming bisection of a part of the partition: first at the middle of AB, which makes Kuhn
// simplices of the tetrahedra, then by Maubach's rule. A tetrahedron that was never bisected has no
// tree and costs nothing.
#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <unordered_map>
#include <unordered_set>
#include <vector>

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

struct FineEdge {
  FinePoint low, high;  ///< precedes(low, high)
  FineEdge(const FinePoint& a, const FinePoint& b)
      : low(precedes(a, b) ? a : b), high(precedes(a, b) ? b : a) {}
  friend bool operator==(const FineEdge&, const FineEdge&) = default;
};
struct FineEdgeHash {
  std::size_t operator()(const FineEdge& e) const {
    std::uint64_t h = 0;
    for (const FinePoint* p : {&e.low, &e.high})
      for (const std::int64_t x : *p) {
        h = (h ^ static_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15U;
        h ^= h >> 29;
      }
    return h;
  }
};

/// Tetrahedron `number` of a cube, as 24 cube + number.
using Root = std::uint64_t;

class Forest {
 public:
  static constexpr int kDeepest = 60;

  struct Node {
    FineCorners corners;
    std::int32_t first_child = -1;  ///< the second follows it
    std::uint8_t tag = 0;           ///< 0: the root's own rule
    std::uint8_t depth = 0;
  };
  using Tree = std::vector<Node>;  ///< the root first

  explicit Forest(const Cube& cubes) : cubes_(cubes) {}

  /// Bisects the leaves that `refine` asks to, and those that must follow for the leaves to be
  /// conforming, until none is left. `refine` is asked once a new leaf, of children and of roots
  /// that have to follow. Order, and so all numbers, depend on nothing but the roots' order.
  void bisect(const std::vector<Root>& roots, const std::function<bool(Root, const Node&)>& refine);

  /// By root, ascending.
  const std::map<Root, Tree>& trees() const { return trees_; }
  int depth() const { return depth_; }

  FineCorners corners_of(Root root) const;
  Cube cube_of(Root root) const;

 private:
  struct Place {
    Root root;
    std::int32_t node;
  };
  bool must_follow(const Node& leaf) const;
  void split(const Place& place);
  void follow(const FineEdge& edge);
  void follow(Root root, const FineEdge& edge, const FinePoint& middle);

  Cube cubes_;
  std::map<Root, Tree> trees_;
  std::unordered_set<FineEdge, FineEdgeHash> split_;
  std::deque<Place> queue_;
  int depth_ = 0;
};

}  // namespace crest::splines
