// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/splines/bisection.hpp"

#include <algorithm>
#include <bit>
#include <stdexcept>
#include <utility>

#include "kernel/geometry/input_error.hpp"
#include "kernel/geometry/stop.hpp"

namespace crest::splines {

using kernel::Index;
using kernel::kNone;

namespace {

constexpr std::int64_t kUnit = std::int64_t{1} << kFineBits;

/// The places of the corners between which a leaf is bisected.
std::pair<std::size_t, std::size_t> bisected_edge(std::uint8_t tag) {
  return tag == 0 ? std::pair<std::size_t, std::size_t>{kA, kB}
                  : std::pair<std::size_t, std::size_t>{0, tag};
}

/// What a leaf's corners have, for the part that keeps the first end of the bisected edge, and for
/// the other; `middle`: what the middle has.
template <class T>
std::array<T, 4> first_part(std::uint8_t tag, const std::array<T, 4>& x, const T& middle) {
  if (tag == 0) return {x[kC], x[kD], middle, x[kA]};
  std::array<T, 4> part = x;
  part[tag] = middle;
  return part;
}
template <class T>
std::array<T, 4> second_part(std::uint8_t tag, const std::array<T, 4>& x, const T& middle) {
  if (tag == 0) return {x[kC], x[kD], middle, x[kB]};
  std::array<T, 4> part = x;
  for (std::size_t i = 0; i < tag; ++i) part[i] = x[i + 1];
  part[tag] = middle;
  return part;
}

template <class T>
bool has(const std::array<T, 4>& corners, const T& p) {
  return std::find(corners.begin(), corners.end(), p) != corners.end();
}

/// Tetrahedra of a cube, a bit each.
using Bits = std::uint32_t;
/// Those that hold no point p with |p_a| < |p_b|, and those that hold none with p_a < 0 (0) or
/// p_a > 0 (1).
struct Excluded {
  std::array<std::array<Bits, 3>, 3> by_order{};
  std::array<std::array<Bits, 2>, 3> by_sign{};
};
constexpr Excluded kExcluded = [] {
  Excluded excluded;
  for (std::size_t t = 0; t < kTetrahedra; ++t) {
    const Tetrahedron& s = kTetrahedron[t];
    const Bits bit = Bits{1} << t;
    excluded.by_order[s.face_axis][s.edge_axis] |= bit;
    excluded.by_order[s.edge_axis][s.free_axis] |= bit;
    excluded.by_sign[s.face_axis][s.face_sign < 0 ? 1 : 0] |= bit;
    excluded.by_sign[s.edge_axis][s.edge_sign < 0 ? 1 : 0] |= bit;
  }
  return excluded;
}();

/// The closed tetrahedra of a cube that hold a point, given from its centre.
Bits tetrahedra_at(const FinePoint& p) {
  Bits left = (Bits{1} << kTetrahedra) - 1;
  for (std::size_t a = 0; a < 3; ++a) {
    if (p[a] != 0) left &= ~kExcluded.by_sign[a][p[a] < 0 ? 0 : 1];
    for (std::size_t b = 0; b < 3; ++b)
      if (std::abs(p[a]) < std::abs(p[b])) left &= ~kExcluded.by_order[a][b];
  }
  return left;
}

}  // namespace

Root Forest::root_of(const Cube& cube, std::size_t tetrahedron) const {
  const auto at = [&](std::size_t k) { return static_cast<Root>(cube[k]); };
  const auto size = [&](std::size_t k) { return static_cast<Root>(cubes_[k]); };
  return kTetrahedra * (at(0) + size(0) * (at(1) + size(1) * at(2))) + tetrahedron;
}

Cube Forest::cube_of(Root root) const {
  const auto cube = static_cast<std::int64_t>(root / kTetrahedra);
  return {static_cast<int>(cube % cubes_[0]), static_cast<int>(cube / cubes_[0] % cubes_[1]),
          static_cast<int>(cube / cubes_[0] / cubes_[1])};
}

FineCorners Forest::corners_of(const Cube& cube, std::size_t tetrahedron) {
  FineCorners fine;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      fine[i][k] =
          (std::int64_t{2} * cube[k] + 1 + kTetrahedron[tetrahedron].corners[i][k]) * kUnit;
  return fine;
}

FineCorners Forest::corners_of(const Node& node) const {
  FineCorners fine;
  for (std::size_t i = 0; i < 4; ++i) fine[i] = points_[node.corners[i]];
  return fine;
}

Index Forest::number_of(const FinePoint& lattice_point) {
  Index& number = lattice_points_[{static_cast<int>(lattice_point[0] >> kFineBits),
                                   static_cast<int>(lattice_point[1] >> kFineBits),
                                   static_cast<int>(lattice_point[2] >> kFineBits)}];
  if (number == kNone) {
    number = static_cast<Index>(points_.size());
    points_.push_back(lattice_point);
  }
  return number;
}

void Forest::plant(const Cube& cube, std::size_t tetrahedron) {
  const auto tree = static_cast<Index>(trees_.size()), node = static_cast<Index>(nodes_.size());
  Index& number = planted_[cube];
  if (number == kNone) {
    number = static_cast<Index>(cubes_with_trees_.size());
    cubes_with_trees_.emplace_back().fill(kNone);
  }
  cubes_with_trees_[number][tetrahedron] = tree;
  queue_.push_back({tree, node});
  trees_.push_back({root_of(cube, tetrahedron), node});
  Node root;
  const FineCorners corners = corners_of(cube, tetrahedron);
  for (std::size_t i = 0; i < 4; ++i) root.corners[i] = number_of(corners[i]);
  nodes_.push_back(root);
}

bool Forest::must_follow(const Node& leaf) const {
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = i + 1; k < 4; ++k)
      if (middles_.find(leaf.corners[i], leaf.corners[k]) != kNone) return true;
  return false;
}

void Forest::follow(Index tree, Index a, Index b, const std::array<double, 4>& middle) {
  steps_.assign(1, {trees_[tree].node, middle});
  while (!steps_.empty()) {
    const Step step = steps_.back();
    steps_.pop_back();
    const Node& node = nodes_[step.node];
    if (node.first_child == kNone) {
      if (has(node.corners, a) && has(node.corners, b)) queue_.push_back({tree, step.node});
      continue;
    }
    const auto [i, k] = bisected_edge(node.tag);
    const double at_i = step.l[i], at_k = step.l[k];
    std::array<double, 4> l = step.l;
    l[i] = at_i - at_k;
    l[k] = at_k - at_i;
    if (at_k >= at_i) steps_.push_back({node.first_child + 1, second_part(node.tag, l, 2 * at_i)});
    if (at_i >= at_k) steps_.push_back({node.first_child, first_part(node.tag, l, 2 * at_k)});
  }
}

void Forest::follow(const Cube& cube, Index a, Index b, const FinePoint& middle) {
  const Planted* trees = planted(cube);
  FinePoint from_centre;
  std::array<double, 3> p;
  for (std::size_t k = 0; k < 3; ++k) {
    from_centre[k] = middle[k] - (std::int64_t{2} * cube[k] + 1) * kUnit;
    p[k] = static_cast<double>(from_centre[k]) / static_cast<double>(kUnit);
  }
  for (Bits left = tetrahedra_at(from_centre); left != 0; left &= left - 1) {
    const auto t = static_cast<std::size_t>(std::countr_zero(left));
    if (trees != nullptr && (*trees)[t] != kNone) {
      follow((*trees)[t], a, b, barycentric(t, p));
      continue;
    }
    const FineCorners corners = corners_of(cube, t);
    if (!has(corners, points_[a]) || !has(corners, points_[b])) continue;
    plant(cube, t);
    trees = planted(cube);
  }
}

void Forest::follow(Index a, Index b, Index at) {
  const FinePoint middle = points_[at];
  std::array<std::array<int, 2>, 3> range;
  for (std::size_t k = 0; k < 3; ++k) {
    const int cube = static_cast<int>(middle[k] / (2 * kUnit));
    range[k] = {middle[k] % (2 * kUnit) == 0 ? std::max(cube - 1, 0) : cube,
                std::min(cube, cubes_[k] - 1)};
  }
  for (int z = range[2][0]; z <= range[2][1]; ++z)
    for (int y = range[1][0]; y <= range[1][1]; ++y)
      for (int x = range[0][0]; x <= range[0][1]; ++x) follow({x, y, z}, a, b, middle);
}

void Forest::split(const Place& place) {
  const Node leaf = nodes_[place.node];
  // Maubach: the closure ends, each leaf following after at most three more bisections.
  if (leaf.depth >= kDeepest) throw std::logic_error("bisection: deeper than the lattice is fine");
  const auto [i, k] = bisected_edge(leaf.tag);
  const Index a = leaf.corners[i], b = leaf.corners[k];
  Index middle = middles_.find(a, b);
  const bool fresh = middle == kNone;
  if (fresh) {
    middle = static_cast<Index>(points_.size());
    FinePoint p;
    for (std::size_t r = 0; r < 3; ++r) p[r] = (points_[a][r] + points_[b][r]) / 2;
    points_.push_back(p);
    middles_.add(a, b, middle);
  }
  nodes_[place.node].first_child = static_cast<Index>(nodes_.size());
  Node child;
  child.depth = static_cast<std::uint8_t>(leaf.depth + 1);
  child.tag = static_cast<std::uint8_t>(leaf.tag <= 1 ? 3 : leaf.tag - 1);
  child.corners = first_part(leaf.tag, leaf.corners, middle);
  nodes_.push_back(child);
  child.corners = second_part(leaf.tag, leaf.corners, middle);
  nodes_.push_back(child);
  if (nodes_.size() > kNone - 2)
    throw kernel::InputError("isosurface: needs more than 4294967294 bisections; cut the volume");
  depth_ = std::max(depth_, leaf.depth + 1);
  if (fresh) follow(a, b, middle);
}

void Forest::bisect(const std::vector<Root>& roots, const Judge& judge) {
  for (const Root root : roots) plant(cube_of(root), root % kTetrahedra);
  while (!queue_.empty()) {
    kernel::stop_point();
    const Place place = queue_.front();
    queue_.pop_front();
    if (nodes_[place.node].first_child != kNone) continue;
    split(place);
    const Index child = nodes_[place.node].first_child;
    for (const Index c : {child, child + 1}) {
      Node& leaf = nodes_[c];
      if (!must_follow(leaf)) leaf.fate = judge(place.tree, leaf);
      if (leaf.fate == Fate::bisect) queue_.push_back({place.tree, c});
    }
  }
}

}  // namespace crest::splines
