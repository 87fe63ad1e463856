// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/clean/polygon_cutter.hpp"

#include <algorithm>
#include <cmath>

#include "kernel/predicates/collinear.hpp"

namespace crest::io {

using kernel::Vec3;

namespace {

constexpr std::size_t kNobody = static_cast<std::size_t>(-1);

}  // namespace

void PolygonCutter::project() {
  double size = 0;
  for (const Vec3& p : corners_)
    for (const double x : p) size = std::max(size, std::fabs(x));
  Vec3 normal{};
  for (std::size_t i = 0; size > 0 && i < corners_.size(); ++i) {
    const Vec3 &p = corners_[i], &q = corners_[(i + 1) % corners_.size()];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t u = (k + 1) % 3, v = (k + 2) % 3;
      normal[k] += (p[u] / size - q[u] / size) * (p[v] / size + q[v] / size);
    }
  }
  std::size_t axis = 2;
  for (const std::size_t k : {1u, 0u})
    if (std::fabs(normal[k]) > std::fabs(normal[axis])) axis = k;
  axes_ = {(axis + 1) % 3, (axis + 2) % 3};
  if (normal[axis] < 0) std::swap(axes_[0], axes_[1]);
}

/// 1: the path a, b, c turns left.
int PolygonCutter::turn(std::size_t a, std::size_t b, std::size_t c) const {
  const Vec3 &p = corners_[a], &q = corners_[b], &r = corners_[c];
  const auto [u, v] = axes_;
  const kernel::Sign sign =
      kernel::climb(kernel::CrossCoordinate{p[u], p[v], q[u], q[v], r[u], r[v]}).sign;
  return sign == kernel::Sign::zero ? 0 : sign == kernel::Sign::positive ? 1 : -1;
}

PolygonCutter::Key PolygonCutter::key(std::size_t tip) const {
  const double diagonal = kernel::distance(corners_[before_[tip]], corners_[next_[tip]]);
  return {rank_[tip], diagonal, numbers_[tip], tip};
}

int PolygonCutter::rank_of_ear(std::size_t tip) const {
  return edges_->has(numbers_[before_[tip]], numbers_[next_[tip]]) ? kEarOnEdge : kEar;
}

/// Whether w is in the triangle or on it, but not at one of its corners.
bool PolygonCutter::covers(const Local& triangle, std::size_t w) const {
  const auto& [a, b, c] = triangle;
  const Vec3& p = corners_[w];
  if (p == corners_[a] || p == corners_[b] || p == corners_[c]) return false;
  return turn(a, b, w) >= 0 && turn(b, c, w) >= 0 && turn(c, a, w) >= 0;
}

/// The same rule without the book-keeping: most polygons are quadrilaterals.
void PolygonCutter::cut_quadrilateral() {
  bool left[4];
  for (std::size_t i = 0; i < 4; ++i) left[i] = turn(before_[i], i, next_[i]) > 0;
  std::size_t tip = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t opposite = (i + 2) % 4;
    const bool ear = left[i] && (left[opposite] || !covers({before_[i], i, next_[i]}, opposite));
    rank_[i] = ear ? rank_of_ear(i) : kNoEar;
    if (key(i) < key(tip)) tip = i;
  }
  triangles_ = {{before_[tip], tip, next_[tip]}, {before_[tip], next_[tip], (tip + 2) % 4}};
}

/// The corner that keeps a left turn from being an ear, or nobody.
std::size_t PolygonCutter::blocker(std::size_t tip) const {
  const std::size_t a = before_[tip], c = next_[tip], u = axes_[0];
  const auto [low, high] = std::minmax({corners_[a][u], corners_[tip][u], corners_[c][u]});
  for (auto at = not_left_.lower_bound({low, 0}); at != not_left_.end() && at->first <= high; ++at)
    if (covers({a, tip, c}, at->second)) return at->second;
  return kNobody;
}

/// Puts a tip in its place.
void PolygonCutter::judge(std::size_t tip) {
  rank_[tip] = kNoEar;
  if (turn(before_[tip], tip, next_[tip]) > 0) {
    const std::size_t w = blocker(tip);
    if (w == kNobody)
      rank_[tip] = rank_of_ear(tip);
    else
      blocked_[w].push_back(tip);
  }
  tips_.insert(key(tip));
}

void PolygonCutter::start() {
  const std::size_t n = corners_.size();
  blocked_.assign(n, {});
  not_left_.clear();
  tips_.clear();
  for (std::size_t i = 0; i < n; ++i)
    if (turn(before_[i], i, next_[i]) <= 0) not_left_.insert({corners_[i][axes_[0]], i});
  for (std::size_t i = 0; i < n; ++i) judge(i);
}

void PolygonCutter::remove(std::size_t tip) {
  const std::size_t a = before_[tip], c = next_[tip];
  triangles_.push_back({a, tip, c});
  for (const std::size_t i : {a, tip, c}) tips_.erase(key(i));
  next_[a] = c;
  before_[c] = a;
  next_[tip] = tip;  // gone
  std::vector<std::size_t> again = {a, c};
  for (const std::size_t i : {a, tip, c}) {
    const bool left = i == tip || turn(before_[i], i, next_[i]) > 0;
    const std::pair<double, std::size_t> place{corners_[i][axes_[0]], i};
    if (!left) not_left_.insert(place);
    if (!left || not_left_.erase(place) == 0) continue;
    again.insert(again.end(), blocked_[i].begin(), blocked_[i].end());
    blocked_[i].clear();
  }
  for (const std::size_t i : again) {
    if (next_[i] == i) continue;
    tips_.erase(key(i));
    judge(i);
  }
}

const std::vector<PolygonCutter::Local>& PolygonCutter::cut(std::span<const Vec3> corners,
                                                            std::span<const kernel::Index> numbers,
                                                            EdgeSet& edges) {
  corners_ = corners;
  numbers_ = numbers;
  edges_ = &edges;
  triangles_.clear();
  std::size_t left = corners.size();
  if (left < 3) return triangles_;
  next_.resize(left);
  before_.resize(left);
  rank_.assign(left, kNoEar);
  for (std::size_t i = 0; i < left; ++i) {
    next_[i] = (i + 1) % left;
    before_[i] = (i + left - 1) % left;
  }
  if (left == 3) {
    triangles_.push_back({0, 1, 2});
    return triangles_;
  }
  project();
  if (left == 4) {
    cut_quadrilateral();
  } else {
    start();
    for (; left > 3; --left) remove(std::get<3>(*tips_.begin()));
    const std::size_t last = std::get<3>(*tips_.begin());
    triangles_.push_back({before_[last], last, next_[last]});
  }
  // The diagonals: one a triangle but the last.
  for (std::size_t i = 0; i + 1 < triangles_.size(); ++i)
    edges.insert(numbers[triangles_[i][0]], numbers[triangles_[i][2]]);
  return triangles_;
}

}  // namespace crest::io
