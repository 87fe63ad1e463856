// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/splines/bisection.hpp"

#include <algorithm>
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

/// Calls visit(t) for the closed tetrahedra of a cube that hold a point, given from its centre.
template <class Visit>
void for_each_tetrahedron_at(const FinePoint& p, const Visit& visit) {
  const auto reach = [&](std::size_t k) { return std::abs(p[k]); };
  for (std::size_t t = 0; t < kTetrahedra; ++t) {
    const Tetrahedron& s = kTetrahedron[t];
    if (reach(s.face_axis) >= reach(s.edge_axis) && reach(s.edge_axis) >= reach(s.free_axis) &&
        s.face_sign * p[s.face_axis] >= 0 && s.edge_sign * p[s.edge_axis] >= 0)
      visit(t);
  }
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

FineCorners Forest::corners_of(Root root) const {
  const Cube cube = cube_of(root);
  FineCorners fine;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      fine[i][k] =
          std::int64_t{2 * cube[k] + 1 + kTetrahedron[root % kTetrahedra].corners[i][k]} * kUnit;
  return fine;
}

FineCorners Forest::corners_of(const Node& node) const {
  FineCorners fine;
  for (std::size_t i = 0; i < 4; ++i) fine[i] = points_[node.corners[i]];
  return fine;
}

const Forest::Planted* Forest::planted(const Cube& cube) const {
  const auto found = planted_.find(root_of(cube, 0));
  return found == planted_.end() ? nullptr : &found->second;
}

Index Forest::number_of(const FinePoint& lattice_point) {
  std::uint64_t key = 0;  // below 27 times the number of cubes
  for (std::size_t k = 3; k-- > 0;)
    key = key * (2 * static_cast<std::uint64_t>(cubes_[k]) + 1) +
          static_cast<std::uint64_t>(lattice_point[k] >> kFineBits);
  const auto [at, fresh] = lattice_points_.try_emplace(key, static_cast<Index>(points_.size()));
  if (fresh) points_.push_back(lattice_point);
  return at->second;
}

void Forest::plant(Root root) {
  Planted none;
  none.fill(kNone);
  const std::size_t t = root % kTetrahedra;
  planted_.try_emplace(root - t, none).first->second[t] = static_cast<Index>(trees_.size());
  queue_.push_back({static_cast<Index>(trees_.size()), static_cast<Index>(nodes_.size())});
  trees_.push_back({root, static_cast<Index>(nodes_.size())});
  Node node;
  const FineCorners corners = corners_of(root);
  for (std::size_t i = 0; i < 4; ++i) node.corners[i] = number_of(corners[i]);
  nodes_.push_back(node);
}

bool Forest::must_follow(const Node& leaf) const {
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = i + 1; k < 4; ++k)
      if (middles_.find(leaf.corners[i], leaf.corners[k]) != kNone) return true;
  return false;
}

void Forest::follow(Index tree, Index a, Index b, const std::array<double, 4>& middle) {
  struct Step {
    Index node;
    std::array<double, 4> l;  ///< the edge's middle, barycentric; no step rounds it
  };
  std::vector<Step> left = {{trees_[tree].node, middle}};
  while (!left.empty()) {
    const Step step = left.back();
    left.pop_back();
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
    if (at_k >= at_i) left.push_back({node.first_child + 1, second_part(node.tag, l, 2 * at_i)});
    if (at_i >= at_k) left.push_back({node.first_child, first_part(node.tag, l, 2 * at_k)});
  }
}

void Forest::follow(const Cube& cube, Index a, Index b, const FinePoint& middle) {
  const Planted* trees = planted(cube);
  FinePoint from_centre;
  std::array<double, 3> p;
  for (std::size_t k = 0; k < 3; ++k) {
    from_centre[k] = middle[k] - (2 * cube[k] + 1) * kUnit;
    p[k] = static_cast<double>(from_centre[k]) / static_cast<double>(kUnit);
  }
  for_each_tetrahedron_at(from_centre, [&](std::size_t t) {
    if (trees != nullptr && (*trees)[t] != kNone)
      return follow((*trees)[t], a, b, barycentric(t, p));
    const Root root = root_of(cube, t);
    const FineCorners corners = corners_of(root);
    if (!has(corners, points_[a]) || !has(corners, points_[b])) return;
    plant(root);
    trees = planted(cube);
  });
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

void Forest::bisect(const std::vector<Root>& roots, const Refine& refine) {
  for (const Root root : roots) plant(root);
  while (!queue_.empty()) {
    kernel::stop_point();
    const Place place = queue_.front();
    queue_.pop_front();
    if (nodes_[place.node].first_child != kNone) continue;
    split(place);
    const Index child = nodes_[place.node].first_child;
    for (const Index c : {child, child + 1})
      if (must_follow(nodes_[c]) || refine(place.tree, nodes_[c]))
        queue_.push_back({place.tree, c});
  }
}

}  // namespace crest::splines
