// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/smooth_ridges/surface_net.hpp"

#include <algorithm>
#include <unordered_map>

#include "kernel/geometry/disjoint_sets.hpp"

namespace crest::smooth_ridges {
namespace {

/// Orthonormal to rounding; no entry is near 0, 1 or a ratio of small integers.
std::array<Vec3, 3> generic_axes() {
  Vec3 a = {0.8316, 0.3871, 0.2547}, b = {-0.4329, 0.7213, 0.5418};
  const double size = norm(a);
  for (double& x : a) x /= size;
  b = b - dot(a, b) * a;
  const double other = norm(b);
  for (double& x : b) x /= other;
  return {a, b, cross(a, b)};
}

using Cell = std::array<std::size_t, 3>;

class Net {
 public:
  Net(Projection& f, const Surface::Box& box, const Grid& grid) : f_(f), box_(box), grid_(grid) {}

  SurfaceNet make() {
    sample();
    for (Cell c{}; c[0] < grid_.points[0]; ++c[0])
      for (c[1] = 0; c[1] < grid_.points[1]; ++c[1])
        for (c[2] = 0; c[2] < grid_.points[2]; ++c[2])
          for (std::size_t axis = 0; axis < 3; ++axis) edge(c, axis);
    for (std::size_t i = 0; i < net_.points.size(); ++i) {
      const Vec3 p = net_.points[i];
      net_.points[i] = {p[0] / crossings_[i], p[1] / crossings_[i], p[2] / crossings_[i]};
    }
    for (const auto& q : quads_) cut(q);
    bound();
    return std::move(net_);
  }

 private:
  std::size_t number(const Cell& c) const {
    return (c[0] * grid_.points[1] + c[1]) * grid_.points[2] + c[2];
  }
  Vec3 point(const Cell& c) const {
    return grid_.at(static_cast<double>(c[0]), static_cast<double>(c[1]),
                    static_cast<double>(c[2]));
  }
  bool outside(const Vec3& p) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (p[k] < box_[2 * k] || p[k] > box_[2 * k + 1]) return true;
    return false;
  }
  Vec3 clamped(Vec3 p) const {
    for (std::size_t k = 0; k < 3; ++k) p[k] = std::clamp(p[k], box_[2 * k], box_[2 * k + 1]);
    return p;
  }

  void sample() {
    values_.resize(grid_.size());
    for (Cell c{}; c[0] < grid_.points[0]; ++c[0])
      for (c[1] = 0; c[1] < grid_.points[1]; ++c[1])
        for (c[2] = 0; c[2] < grid_.points[2]; ++c[2])
          values_[number(c)] = f_.value(clamped(point(c)));
  }

  /// The edge from point c along the axis: its crossing goes to the four cells around it.
  void edge(const Cell& c, std::size_t axis) {
    Cell end = c;
    if (++end[axis] == grid_.points[axis]) return;
    const double a = values_[number(c)], b = values_[number(end)];
    if ((a < 0) == (b < 0)) return;
    const Vec3 p = point(c), q = point(end);
    const double t = a / (a - b);
    const Vec3 crossing = p + (t >= 0 && t <= 1 ? t : 0.5) * (q - p);
    if (outside(p) && outside(q) && !net_.on_boundary) net_.on_boundary = clamped(crossing);
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    if (c[u] == 0 || c[v] == 0 || c[u] + 1 == grid_.points[u] || c[v] + 1 == grid_.points[v]) {
      if (!net_.on_boundary) net_.on_boundary = clamped(crossing);
      return;
    }
    std::array<Index, 4> around{};
    const std::array<std::array<unsigned, 2>, 4> shifts = {{{1, 1}, {0, 1}, {0, 0}, {1, 0}}};
    for (std::size_t i = 0; i < 4; ++i) {
      Cell cell = c;
      cell[u] -= shifts[i][0];
      cell[v] -= shifts[i][1];
      const unsigned corner = shifts[i][0] << u | shifts[i][1] << v;
      around[i] = sheets(cell)[edge_of(corner, axis)];
      net_.points[around[i]] = net_.points[around[i]] + crossing;
      crossings_[around[i]] += 1;
    }
    // Counter-clockwise around the axis: seen from its end, where F >= 0 if a < 0.
    if (!(a < 0)) std::swap(around[1], around[3]);
    quads_.push_back(around);
  }

  /// The number of a cell's edge along the axis, from its corner (bit a: upper along axis a).
  static std::size_t edge_of(unsigned corner, std::size_t axis) {
    return 4 * axis + (corner >> (axis + 1) % 3 & 1) + 2 * (corner >> (axis + 2) % 3 & 1);
  }
  bool negative(const Cell& cell, unsigned corner) const {
    return values_[number(
               {cell[0] + (corner & 1), cell[1] + (corner >> 1 & 1), cell[2] + (corner >> 2)})] < 0;
  }

  using Sheets = std::array<Index, 12>;
  /// The vertex of the sheet that crosses each edge of the cell.
  const Sheets& sheets(const Cell& cell) {
    const auto [at, fresh] = sheets_.try_emplace(number(cell));
    if (!fresh) return at->second;
    kernel::DisjointSets joined(12);
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (unsigned side = 0; side < 2; ++side) join(cell, axis, side, joined);
    std::array<Index, 12> vertex;
    vertex.fill(kNone);
    Sheets& result = at->second;
    for (Index e = 0; e < 12; ++e) {
      const Index r = joined.find(e);
      if (vertex[r] == kNone && crossed(cell, e)) {
        vertex[r] = static_cast<Index>(net_.points.size());
        net_.points.push_back({});
        crossings_.push_back(0);
      }
      result[e] = vertex[r];
    }
    return result;
  }
  bool crossed(const Cell& cell, Index e) const {
    const std::size_t axis = e / 4;
    const unsigned corner = (e & 1) << (axis + 1) % 3 | (e >> 1 & 1) << (axis + 2) % 3;
    return negative(cell, corner) != negative(cell, corner | 1u << axis);
  }
  /// Joins crossed edges of a side: all, or around each negative corner if the signs alternate.
  void join(const Cell& cell, std::size_t axis, unsigned side, kernel::DisjointSets& joined) const {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    const auto corner = [&](unsigned i, unsigned j) { return side << axis | i << u | j << v; };
    const bool alternate = negative(cell, corner(0, 0)) == negative(cell, corner(1, 1)) &&
                           negative(cell, corner(1, 0)) == negative(cell, corner(0, 1)) &&
                           negative(cell, corner(0, 0)) != negative(cell, corner(1, 0));
    Index last = kNone;
    for (unsigned i = 0; i < 2; ++i)
      for (unsigned j = 0; j < 2; ++j) {
        if (alternate && !negative(cell, corner(i, j))) continue;
        if (alternate) last = kNone;
        for (const std::size_t along : {u, v}) {
          const Index e = static_cast<Index>(edge_of(corner(i, j), along));
          if (!crossed(cell, e)) continue;
          if (last != kNone) joined.unite(last, e);
          last = e;
        }
      }
  }

  /// Along the shorter diagonal.
  void cut(const std::array<Index, 4>& q) {
    const auto distance = [&](Index a, Index b) { return norm(net_.points[a] - net_.points[b]); };
    if (distance(q[0], q[2]) <= distance(q[1], q[3])) {
      net_.faces.push_back({q[0], q[1], q[2]});
      net_.faces.push_back({q[0], q[2], q[3]});
    } else {
      net_.faces.push_back({q[1], q[2], q[3]});
      net_.faces.push_back({q[1], q[3], q[0]});
    }
  }

  void bound() {
    net_.low = {HUGE_VAL, HUGE_VAL, HUGE_VAL};
    net_.high = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    for (const Vec3& p : net_.points) {
      const Vec3 t = along_generic_axes(p);
      for (std::size_t k = 0; k < 3; ++k) {
        net_.low[k] = std::min(net_.low[k], t[k]);
        net_.high[k] = std::max(net_.high[k], t[k]);
      }
    }
  }

  Projection& f_;
  const Surface::Box& box_;
  const Grid& grid_;
  std::vector<double> values_;
  std::unordered_map<std::size_t, Sheets> sheets_;
  std::vector<double> crossings_;
  std::vector<std::array<Index, 4>> quads_;
  SurfaceNet net_;
};

}  // namespace

Vec3 along_generic_axes(const Vec3& p) {
  const std::array<Vec3, 3> axes = generic_axes();
  return {dot(p, axes[0]), dot(p, axes[1]), dot(p, axes[2])};
}

Grid generic_grid(const Vec3& low, const Vec3& high, double cell) {
  const std::array<double, 3> shifts = {1.3713, 1.6127, 1.4519};  // of a cell
  Grid grid{{}, generic_axes(), cell, {}};
  for (std::size_t k = 0; k < 3; ++k) {
    grid.origin = grid.origin + (low[k] - shifts[k] * cell) * grid.axes[k];
    grid.points[k] = static_cast<std::size_t>(std::ceil((high[k] - low[k]) / cell)) + 4;
  }
  return grid;
}

SurfaceNet surface_net(Projection& f, const Surface::Box& box, const Grid& grid) {
  return Net(f, box, grid).make();
}

}  // namespace crest::smooth_ridges
