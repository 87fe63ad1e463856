// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/extremal/point_nodes.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "kernel/geometry/parallel.hpp"

namespace crest::extremal {
namespace {

using Range = tbb::blocked_range<std::size_t>;
constexpr int kDeepest = 14;

Node corner(const OctreeLeaf& leaf, int i) {
  return {leaf.low[0] + (i & 1) * leaf.size, leaf.low[1] + (i >> 1 & 1) * leaf.size,
          leaf.low[2] + (i >> 2) * leaf.size};
}

}  // namespace

/// A cube round the points and what lies within h of them; if the depth allows it, so wide that
/// some leaves are h/4 exactly, where the paper's criteria begin: else they are up to twice as
/// fine.
Grid PointTree::grid_of(const PointField& field, int depth) {
  Vec3 low = field.points()[0], high = low;
  for (const Vec3& p : field.points())
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  double side = 0;
  for (std::size_t k = 0; k < 3; ++k) side = std::max(side, high[k] - low[k]);
  // Not a symmetric place: planes of symmetric points would run along nodes.
  const double least = side + 2.2 * field.h(), finest = std::ldexp(field.h() / 4, depth);
  double width = finest;
  while (width / 2 >= least) width /= 2;
  const double unit = (finest < least ? least : width) / (1 << depth);
  const Vec3 origin = 0.5 * (low + high) - (0.5 + 0x1p-7) * ((1 << depth) * unit) * Vec3{1, 1, 1};
  return Grid({2, 2, 2}, {unit, unit, unit}, origin);
}

PointTree::PointTree(const PointField& field, int depth)
    : field_(field),
      grid_(grid_of(field, depth)),
      tree_(depth, [&](const std::vector<OctreeLeaf>& boxes) { return find(boxes); }) {
  const auto& leaves = tree_.leaves();
  boxes_.resize(leaves.size());
  const auto before = [](const AskedLeaf& a, const AskedLeaf& b) { return a.low < b.low; };
  tbb::parallel_sort(asked_.begin(), asked_.end(), before);
  kernel::parallel_for(Range(0, leaves.size(), 64), [&](const Range& r) {
    for (std::size_t i = r.begin(); i < r.end(); ++i) {
      boxes_[i].nonzero = leaves[i].content == Content::empty;
      if (leaves[i].content != Content::open) continue;
      const AskedLeaf leaf = {packed(leaves[i].low), leaves[i].size, {}};
      const auto at = std::lower_bound(asked_.begin(), asked_.end(), leaf, before);
      const bool known = at != asked_.end() && at->low == leaf.low && at->size == leaf.size;
      boxes_[i] = known ? at->box : prove(leaves[i], within(leaves[i]));
    }
  });
  asked_ = {};
  decide_nodes();
  collect_edges();
  kernel::parallel_for(Range(0, edges_.size(), 64), [&](const Range& r) {
    for (std::size_t i = r.begin(); i < r.end(); ++i) decide_edge(edges_[i]);
  });
}

std::pair<Vec3, Vec3> PointTree::placed(const OctreeLeaf& leaf) const {
  const double half = 0.5 * leaf.size;
  return {grid_.position(as_vector(leaf.low) + Vec3{half, half, half}), half * grid_.spacing};
}

PointField::Box PointTree::prove(const OctreeLeaf& leaf, const std::vector<Index>& among) const {
  const auto [centre, half] = placed(leaf);
  // A large box is to be split: its children tell.
  return large(leaf) && leaf.size > 1 ? field_.box(centre, half, among)
                                      : field_.box_in_parts(centre, half, among);
}

/// Where the surface may be: boxes are split until they are at most h/4, then by the paper's
/// criteria. The cone test fails on most boxes of h/2.5 wherever they are: their parts tell
/// (octree.hpp).
std::vector<Content> PointTree::find(const std::vector<OctreeLeaf>& boxes) {
  std::vector<Content> found(boxes.size());
  std::vector<PointField::Box> proven(boxes.size());
  const std::size_t family = std::min<std::size_t>(8, boxes.size());
  kernel::parallel_for(Range(0, boxes.size() / family, 4), [&](const Range& r) {
    for (std::size_t f = family * r.begin(); f < family * r.end(); f += family) {
      OctreeLeaf parent = boxes[f];
      if (family == 8) parent.size *= 2;
      const std::vector<Index> among = within(parent);
      for (std::size_t i = f; i < f + family; ++i) {
        proven[i] = prove(boxes[i], among);
        found[i] = content(boxes[i], proven[i]);
      }
    }
  });
  for (std::size_t i = 0; i < boxes.size(); ++i)
    if (found[i] == Content::open)
      asked_.push_back({packed(boxes[i].low), boxes[i].size, proven[i]});
  return found;
}

Content PointTree::content(const OctreeLeaf& leaf, const PointField::Box& box) const {
  if (!box.near) return Content::far;
  if (box.nonzero) return Content::empty;
  return leaf.size > 1 && (large(leaf) || criteria(leaf, box)) ? Content::split : Content::open;
}

/// More than one point, n at two corners more than 10 degrees apart, s_nn of both signs. Where n
/// is certain within 5 degrees the corners are not asked.
bool PointTree::criteria(const OctreeLeaf& leaf, const PointField::Box& box) const {
  if (box.inside > 1) return true;
  if (box.passed && box.theta < 5 * M_PI / 180) return false;
  std::array<Vec3, 8> n;
  int positive = 0;
  for (int i = 0; i < 8; ++i) {
    const Local l = sums(as_vector(corner(leaf, i))).local;
    auto& own = n[static_cast<std::size_t>(i)];
    own = dominant_direction(l.tensor);
    positive += kernel::dot(own, product(l.hessian, own)) > 0 ? 1 : 0;
  }
  if (positive % 8 != 0) return true;
  for (std::size_t i = 0; i < 8; ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (std::fabs(kernel::dot(n[i], n[k])) < std::cos(10 * M_PI / 180)) return true;
  return false;
}

double PointTree::oriented(const Vec3& x, const Vec3& w) const {
  const Local l = sums(x).local;
  const Vec3 n = dominant_direction(l.tensor);
  return kernel::dot(n, l.gradient) * side(n, w);
}

Index PointTree::find_node(Place p) const {
  const auto at = std::lower_bound(places_.begin(), places_.end(), p);
  return at != places_.end() && *at == p ? static_cast<Index>(at - places_.begin()) : kernel::kNone;
}

std::size_t PointTree::count_active() const {
  return static_cast<std::size_t>(
      std::count_if(nodes_.begin(), nodes_.end(), [](const OctreeNode& n) { return n.active; }));
}

void PointTree::decide_nodes() {
  const auto& leaves = tree_.leaves();
  places_.reserve(8 * leaves.size());
  for (const OctreeLeaf& leaf : leaves)
    for (int i = 0; i < 8; ++i) places_.push_back(packed(corner(leaf, i)));
  tbb::parallel_sort(places_.begin(), places_.end());
  places_.erase(std::unique(places_.begin(), places_.end()), places_.end());
  std::vector<std::uint8_t> wanted(places_.size(), 0);
  // Corners of leaves that the surface may meet, and the middles of their edges.
  for (Index i = 0; i < leaves.size(); ++i) {
    if (!open(i)) continue;
    const int half = leaves[i].size / 2;
    for (int c = 0; c < 27; ++c) {
      const std::array<int, 3> step = {c % 3, c / 3 % 3, c / 9};
      const auto middles = std::count(step.begin(), step.end(), 1);
      if (middles > 1 || (middles == 1 && half == 0)) continue;
      Node v = leaves[i].low;
      for (std::size_t k = 0; k < 3; ++k) v[k] += step[k] == 2 ? leaves[i].size : step[k] * half;
      if (const Index n = find_node(packed(v)); n != kernel::kNone) wanted[n] = 1;
    }
  }
  nodes_.resize(places_.size());
  kernel::parallel_for(Range(0, places_.size(), 64), [&](const Range& r) {
    for (std::size_t i = r.begin(); i < r.end(); ++i) {
      if (wanted[i] == 0) continue;
      const PointField::Sums s = sums(as_vector(unpacked(places_[i])));
      if (s.count == 0 || s.nearest > PointField::kNear * field_.h()) continue;
      const Vec3 n = dominant_direction(s.local.tensor);
      double size = 0;
      for (const double x : s.local.tensor) size = std::max(size, std::fabs(x));
      if (!(kernel::cone_margin(s.local.tensor, size, 1e-13 * size, n) > 1e-8 * size)) continue;
      const double g = kernel::dot(n, s.local.gradient);
      // Exactly zero: the first coordinate of n that is not.
      const auto first = std::find_if(n.begin(), n.end(), [](double x) { return x != 0; });
      nodes_[i] = {true, static_cast<std::int8_t>((g != 0 ? g : *first) > 0 ? 1 : -1), n};
    }
  });
}

void PointTree::collect_edges() {
  const auto& leaves = tree_.leaves();
  for (Index i = 0; i < leaves.size(); ++i) {
    if (!open(i)) continue;
    const OctreeLeaf& leaf = leaves[i];
    const Index decider = boxes_[i].passed ? i : kernel::kNone;
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (int k = 0; k < 4; ++k) {
        Node v = moved(leaf.low, next(axis), (k & 1) * leaf.size);
        v = moved(v, after_next(axis), (k >> 1) * leaf.size);
        const int half = leaf.size / 2;
        const auto put = [&](const Node& low, int size) {
          edges_.push_back({packed(low), static_cast<std::uint8_t>(axis), size, decider});
        };
        if (leaf.size > 1 && is_node(moved(v, axis, half))) {
          put(v, half);
          put(moved(v, axis, half), half);
        } else {
          put(v, leaf.size);
        }
      }
  }
  tbb::parallel_sort(edges_.begin(), edges_.end(), [](const OctreeEdge& a, const OctreeEdge& b) {
    return std::tuple(a.low, a.axis, a.decider) < std::tuple(b.low, b.axis, b.decider);
  });
  edges_.erase(
      std::unique(edges_.begin(), edges_.end(),
                  [](const OctreeEdge& a, const OctreeEdge& b) { return a.key() == b.key(); }),
      edges_.end());
}

Index PointTree::find_edge(Place low, std::size_t axis) const {
  const std::pair key(low, static_cast<std::uint8_t>(axis));
  const auto at = std::lower_bound(edges_.begin(), edges_.end(), key,
                                   [](const OctreeEdge& e, const auto& k) { return e.key() < k; });
  return at != edges_.end() && at->key() == key ? static_cast<Index>(at - edges_.begin())
                                                : kernel::kNone;
}

/// Follows n along a part of an edge by the cone test; turn is n's at the end against that at the
/// start, both as given.
bool PointTree::follow(const Vec3& a, const Vec3& b, const Vec3& lower, const Vec3& upper,
                       int depth, OctreeEdge& e, int& turn) const {
  e.depth = std::max(e.depth, depth);
  const Vec3 middle = 0.5 * (a + b);
  Vec3 half = 0.5 * grid_.spacing[0] * (b - a);
  const PointField::Box box = field_.box(grid_.position(middle), half);
  if (box.passed) {
    turn *= side(lower, box.w) * side(upper, box.w);
    return true;
  }
  if (depth == kDeepest) return false;
  const Vec3 n = dominant_direction(sums(middle).local.tensor);
  return follow(a, middle, lower, n, depth + 1, e, turn) &&
         follow(middle, b, n, upper, depth + 1, e, turn);
}

void PointTree::decide_edge(OctreeEdge& e) const {
  const Node low = unpacked(e.low), high = moved(low, e.axis, e.size);
  const OctreeNode &na = node(low), &nb = node(high);
  if (!na.active || !nb.active) return;
  int turn = 1;
  if (e.decider != kernel::kNone) {
    const Vec3& w = boxes_[e.decider].w;
    turn = side(na.direction, w) * side(nb.direction, w);
  } else if (!follow(as_vector(low), as_vector(high), na.direction, nb.direction, 0, e, turn)) {
    e.state = EdgeState::undecided;
    return;
  }
  e.state = EdgeState::plain;
  if (na.sign * turn == nb.sign) return;
  // A zero by the Illinois method, n carried along from the lower end.
  const auto at = [&](double t, const Vec3& near) {
    e.zero = as_vector(low);
    e.zero[e.axis] += t * e.size;
    const Local l = sums(e.zero).local;
    const Vec3 n = dominant_direction(l.tensor);
    return std::tuple(l, static_cast<double>(side(n, near)) * n);
  };
  double a = 0, b = 1, last = 0;
  auto [l, n] = at(a, na.direction);
  double ga = na.sign * std::fabs(kernel::dot(n, l.gradient));
  double gb = -na.sign * std::fabs(kernel::dot(nb.direction, sums(as_vector(high)).local.gradient));
  int stays = 0;  // 1: the upper end has stayed, -1: the lower one
  for (int step = 0; step < 24; ++step) {
    const double t = ga == gb ? 0.5 * (a + b) : a + (b - a) * (ga / (ga - gb));
    const auto [here, direction] = at(t, n);
    const double g = kernel::dot(direction, here.gradient);
    l = here;
    if (g == 0 || (step > 0 && std::fabs(t - last) < 0x1p-14)) break;
    last = t;
    if ((g > 0) == (na.sign > 0)) {
      a = t;
      ga = g;
      n = direction;
      if (stays == 1) gb /= 2;
      stays = 1;
    } else {
      b = t;
      gb = g;
      if (stays == -1) ga /= 2;
      stays = -1;
    }
  }
  const Vec3 m = dominant_direction(l.tensor);
  e.state =
      kernel::dot(m, product(l.hessian, m)) > 0 ? EdgeState::extremal : EdgeState::merely_critical;
}

}  // namespace crest::extremal
