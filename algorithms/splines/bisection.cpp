// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/splines/bisection.hpp"

#include <algorithm>
#include <stdexcept>

namespace crest::splines {
namespace {

FinePoint middle_of(const FinePoint& a, const FinePoint& b) {
  return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
}

/// The edge that a leaf is bisected at.
FineEdge next_edge(const Forest::Node& leaf) {
  return leaf.tag == 0 ? FineEdge(leaf.corners[kA], leaf.corners[kB])
                       : FineEdge(leaf.corners[0], leaf.corners[leaf.tag]);
}

std::array<Forest::Node, 2> children_of(const Forest::Node& leaf) {
  const auto& x = leaf.corners;
  Forest::Node first, second;
  first.depth = second.depth = static_cast<std::uint8_t>(leaf.depth + 1);
  if (leaf.tag == 0) {
    const FinePoint m = middle_of(x[kA], x[kB]);
    first.corners = {x[kC], x[kD], m, x[kA]};
    second.corners = {x[kC], x[kD], m, x[kB]};
    first.tag = second.tag = 3;
    return {first, second};
  }
  const std::size_t k = leaf.tag;
  const FinePoint z = middle_of(x[0], x[k]);
  first.corners = second.corners = x;
  first.corners[k] = z;
  for (std::size_t i = 0; i < k; ++i) second.corners[i] = x[i + 1];
  second.corners[k] = z;
  first.tag = second.tag = static_cast<std::uint8_t>(k == 1 ? 3 : k - 1);
  return {first, second};
}

bool has(const FineCorners& corners, const FinePoint& p) {
  return std::find(corners.begin(), corners.end(), p) != corners.end();
}

/// Whether a point of the fine lattice is in a closed tetrahedron of the partition.
bool holds(const FinePoint& centre, std::size_t t, const FinePoint& p) {
  const Tetrahedron& s = kTetrahedron[t];
  const auto d = [&](std::size_t k) { return p[k] - centre[k]; };
  const std::int64_t face = s.face_sign * d(s.face_axis), edge = s.edge_sign * d(s.edge_axis),
                     free = d(s.free_axis);
  return face <= std::int64_t{1} << kFineBits && edge <= face && free <= edge && -free <= edge;
}

}  // namespace

Cube Forest::cube_of(Root root) const {
  const auto cube = static_cast<std::int64_t>(root / kTetrahedra);
  return {static_cast<int>(cube % cubes_[0]), static_cast<int>(cube / cubes_[0] % cubes_[1]),
          static_cast<int>(cube / cubes_[0] / cubes_[1])};
}

FineCorners Forest::corners_of(Root root) const {
  const Cube cube = cube_of(root);
  FineCorners fine;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      fine[i][k] = std::int64_t{2 * cube[k] + 1 + kTetrahedron[root % kTetrahedra].corners[i][k]} *
                   (std::int64_t{1} << kFineBits);
  return fine;
}

bool Forest::must_follow(const Node& leaf) const {
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = i + 1; k < 4; ++k)
      if (split_.contains(FineEdge(leaf.corners[i], leaf.corners[k]))) return true;
  return false;
}

/// Queues the leaves below a root that have the edge.
void Forest::follow(Root root, const FineEdge& edge, const FinePoint& middle) {
  const auto found = trees_.find(root);
  if (found == trees_.end()) {
    const FineCorners corners = corners_of(root);
    if (!has(corners, edge.low) || !has(corners, edge.high)) return;
    trees_[root].push_back({.corners = corners});
    queue_.push_back({root, 0});
    return;
  }
  const Tree& tree = found->second;
  std::vector<std::int32_t> left = {0};
  while (!left.empty()) {
    const std::int32_t at = left.back();
    left.pop_back();
    const Node& node = tree[static_cast<std::size_t>(at)];
    if (node.first_child < 0) {
      if (has(node.corners, edge.low) && has(node.corners, edge.high)) queue_.push_back({root, at});
      continue;
    }
    for (const std::int32_t child : {node.first_child + 1, node.first_child}) {
      // An edge of a leaf lies in the box of every node above it.
      const FineCorners& x = tree[static_cast<std::size_t>(child)].corners;
      bool apart = false;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [low, high] = std::minmax({x[0][k], x[1][k], x[2][k], x[3][k]});
        apart |= middle[k] < low || middle[k] > high;
      }
      if (!apart) left.push_back(child);
    }
  }
}

void Forest::follow(const FineEdge& edge) {
  const FinePoint middle = middle_of(edge.low, edge.high);
  constexpr std::int64_t side = std::int64_t{2} << kFineBits;
  std::array<std::array<int, 2>, 3> range;
  for (std::size_t k = 0; k < 3; ++k) {
    const int cube = static_cast<int>(middle[k] / side);
    range[k] = {middle[k] % side == 0 ? std::max(cube - 1, 0) : cube,
                std::min(cube, cubes_[k] - 1)};
  }
  for (int z = range[2][0]; z <= range[2][1]; ++z)
    for (int y = range[1][0]; y <= range[1][1]; ++y)
      for (int x = range[0][0]; x <= range[0][1]; ++x) {
        const FinePoint centre = {x * side + side / 2, y * side + side / 2, z * side + side / 2};
        const Root first =
            kTetrahedra *
            (static_cast<Root>(x) +
             static_cast<Root>(cubes_[0]) *
                 (static_cast<Root>(y) + static_cast<Root>(cubes_[1]) * static_cast<Root>(z)));
        for (std::size_t t = 0; t < kTetrahedra; ++t)
          if (holds(centre, t, middle)) follow(first + t, edge, middle);
      }
}

void Forest::split(const Place& place) {
  Tree& tree = trees_.at(place.root);
  const Node leaf = tree[static_cast<std::size_t>(place.node)];
  // Maubach: the closure ends, each leaf following after at most three more bisections.
  if (leaf.depth >= kDeepest) throw std::logic_error("bisection: deeper than the lattice is fine");
  tree[static_cast<std::size_t>(place.node)].first_child = static_cast<std::int32_t>(tree.size());
  for (const Node& child : children_of(leaf)) tree.push_back(child);
  depth_ = std::max(depth_, leaf.depth + 1);
  const FineEdge edge = next_edge(leaf);
  if (split_.insert(edge).second) follow(edge);
}

void Forest::bisect(const std::vector<Root>& roots,
                    const std::function<bool(Root, const Node&)>& refine) {
  for (const Root root : roots) {
    trees_[root].push_back({.corners = corners_of(root)});
    queue_.push_back({root, 0});
  }
  while (!queue_.empty()) {
    const Place place = queue_.front();
    queue_.pop_front();
    const auto node_of = [&](std::int32_t i) -> const Node& {
      return trees_.at(place.root)[static_cast<std::size_t>(i)];
    };
    if (node_of(place.node).first_child >= 0) continue;
    split(place);
    const std::int32_t child = node_of(place.node).first_child;
    for (const std::int32_t c : {child, child + 1})
      if (must_follow(node_of(c)) || refine(place.root, node_of(c)))
        queue_.push_back({place.root, c});
  }
}

}  // namespace crest::splines
