// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/smooth_ridges/surface_net.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "kernel/geometry/disjoint_sets.hpp"

namespace crest::smooth_ridges {
namespace {

using Coordinates = GradedGrid::Coordinates;
using Cell = GradedGrid::Cell;

Coordinates moved(Coordinates p, std::size_t axis, std::uint32_t by) {
  p[axis] += by;
  return p;
}

/// A whole edge with a change of sign.
struct Crossing {
  Coordinates low;
  std::size_t axis;
  friend bool operator==(const Crossing&, const Crossing&) = default;
};

/// The sheets of the surface in one cell: its crossings, those of one sheet joined.
class CellSheets {
 public:
  CellSheets(const GradedGrid& grid, const Cell& cell) : grid_(grid), cell_(cell) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::uint32_t v = 0; v < 2; ++v)
        for (std::uint32_t u = 0; u < 2; ++u) {
          const Coordinates low =
              moved(moved(cell.low, (axis + 1) % 3, u * cell.side), (axis + 2) % 3, v * cell.side);
          walk_edge(low, axis, cell.side, true, crossings_);
        }
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::uint32_t side = 0; side < 2; ++side)
        walk_side(moved(cell.low, axis, side * cell.side), (axis + 1) % 3, (axis + 2) % 3,
                  cell.side);
  }

  const std::vector<Crossing>& crossings() const { return crossings_; }
  /// For each crossing the first one of its sheet.
  std::vector<Index> sheets() const {
    kernel::DisjointSets joined(static_cast<Index>(crossings_.size()));
    for (const auto& [a, b] : pairs_) joined.unite(a, b);
    std::vector<Index> first(crossings_.size());
    for (Index i = 0; i < first.size(); ++i) first[i] = joined.find(i);
    return first;
  }

 private:
  bool negative(const Coordinates& p) const { return grid_.value(p) < 0; }

  /// The crossings of an edge, upwards or downwards.
  void walk_edge(const Coordinates& low, std::size_t axis, std::uint32_t length, bool up,
                 std::vector<Crossing>& found) const {
    const std::uint32_t half = length / 2;
    const Coordinates middle = moved(low, axis, half);
    if (half > 0 && grid_.is_corner(middle)) {
      walk_edge(up ? low : middle, axis, half, up, found);
      walk_edge(up ? middle : low, axis, half, up, found);
    } else if (negative(low) != negative(moved(low, axis, length))) {
      found.push_back({low, axis});
    }
  }

  /// Joins the crossings around each run of negative corners of the side's whole parts.
  void walk_side(const Coordinates& low, std::size_t u, std::size_t v, std::uint32_t side) {
    const std::uint32_t half = side / 2;
    if (half > 0 && grid_.is_corner(moved(moved(low, u, half), v, half))) {
      for (const std::uint32_t i : {0u, half})
        for (const std::uint32_t j : {0u, half})
          walk_side(moved(moved(low, u, i), v, j), u, v, half);
      return;
    }
    std::vector<Crossing> around;
    walk_edge(low, u, side, true, around);
    walk_edge(moved(low, u, side), v, side, true, around);
    walk_edge(moved(low, v, side), u, side, false, around);
    walk_edge(low, v, side, false, around);
    const std::size_t n = around.size();
    // From a corner that is not negative the first crossing enters a run.
    for (std::size_t i = negative(low) ? 1 : 0; i < n; i += 2) {
      const Index enters = number(around[i]), leaves = number(around[(i + 1) % n]);
      pairs_.emplace_back(enters, leaves);
    }
  }
  Index number(const Crossing& c) {
    const auto at = std::find(crossings_.begin(), crossings_.end(), c);
    const auto i = static_cast<Index>(at - crossings_.begin());
    if (at == crossings_.end()) crossings_.push_back(c);
    return i;
  }

  const GradedGrid& grid_;
  Cell cell_;
  std::vector<Crossing> crossings_;
  std::vector<std::pair<Index, Index>> pairs_;
};

class Net {
 public:
  Net(Projection& f, const Surface::Box& box, const Grid& grid, const std::vector<FineSpot>& spots)
      : box_(box), grid_(f, box, grid, spots) {}

  SurfaceNet make() {
    for (Coordinates p{}; p[0] <= grid_.end(0); p[0] += grid_.unit())
      for (p[1] = 0; p[1] <= grid_.end(1); p[1] += grid_.unit())
        for (p[2] = 0; p[2] <= grid_.end(2); p[2] += grid_.unit())
          for (std::size_t axis = 0; axis < 3; ++axis)
            if (p[axis] < grid_.end(axis)) edge(p, axis, grid_.unit());
    for (const Cell& c : grid_.small_cells())
      for (std::size_t axis = 0; axis < 3; ++axis)
        for (const std::uint32_t i : {0u, c.side})
          for (const std::uint32_t j : {0u, c.side})
            edge(moved(moved(c.low, (axis + 1) % 3, i), (axis + 2) % 3, j), axis, c.side);
    for (std::size_t i = 0; i < net_.points.size(); ++i) {
      const Vec3 p = net_.points[i];
      net_.points[i] = {p[0] / crossings_[i], p[1] / crossings_[i], p[2] / crossings_[i]};
    }
    for (const auto& q : polygons_) cut(q);
    bound();
    return std::move(net_);
  }

 private:
  bool outside(const Vec3& p) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (p[k] < box_[2 * k] || p[k] > box_[2 * k + 1]) return true;
    return false;
  }
  Vec3 clamped(Vec3 p) const {
    for (std::size_t k = 0; k < 3; ++k) p[k] = std::clamp(p[k], box_[2 * k], box_[2 * k + 1]);
    return p;
  }

  /// A whole edge's crossing goes to the cells around it.
  void edge(const Coordinates& low, std::size_t axis, std::uint32_t length) {
    const Coordinates end = moved(low, axis, length);
    if (length > 1 && grid_.is_corner(moved(low, axis, length / 2))) return;
    const double a = grid_.value(low), b = grid_.value(end);
    if ((a < 0) == (b < 0)) return;
    // Cells of several sides meet it, each of them comes by.
    if (length < grid_.unit() && !seen_.insert({low, axis}).second) return;
    const Vec3 p = grid_.place(low), q = grid_.place(end);
    const double t = a / (a - b);
    const Vec3 crossing = p + (t >= 0 && t <= 1 ? t : 0.5) * (q - p);
    if (outside(p) && outside(q) && !net_.on_boundary) net_.on_boundary = clamped(crossing);
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    if (low[u] == 0 || low[v] == 0 || low[u] == grid_.end(u) || low[v] == grid_.end(v)) {
      if (!net_.on_boundary) net_.on_boundary = clamped(crossing);
      return;
    }
    std::vector<Index> around;
    for (const auto& [i, j] : {std::pair{1u, 1u}, {0u, 1u}, {0u, 0u}, {1u, 0u}}) {
      Coordinates below = low;
      below[u] -= i;
      below[v] -= j;
      const Index vertex = sheet(grid_.cell_above(below), {low, axis});
      if (around.empty() || (vertex != around.back() && vertex != around.front()))
        around.push_back(vertex);
    }
    for (const Index vertex : around) {
      net_.points[vertex] = net_.points[vertex] + crossing;
      crossings_[vertex] += 1;
    }
    // Counter-clockwise around the axis: seen from its end, where F >= 0 if a < 0.
    if (!(a < 0)) std::reverse(around.begin() + 1, around.end());
    polygons_.push_back(std::move(around));
  }

  /// The vertex of the sheet that crosses the edge in the cell.
  Index sheet(const Cell& cell, const Crossing& c) {
    const auto [at, fresh] = sheets_.try_emplace(cell.low);
    auto& vertex = at->second;
    if (fresh) {
      const CellSheets found(grid_, cell);
      const std::vector<Index> first = found.sheets();
      for (Index i = 0; i < first.size(); ++i) {
        vertex.emplace_back(found.crossings()[i], 0);
        if (first[i] < i) {
          vertex.back().second = vertex[first[i]].second;
          continue;
        }
        vertex.back().second = static_cast<Index>(net_.points.size());
        net_.points.push_back({});
        net_.cells.push_back(grid_.side_in_space(cell));
        crossings_.push_back(0);
      }
    }
    return std::find_if(vertex.begin(), vertex.end(), [&](const auto& x) { return x.first == c; })
        ->second;
  }

  /// A quadrangle along its shorter diagonal.
  void cut(const std::vector<Index>& q) {
    const auto distance = [&](Index a, Index b) { return norm(net_.points[a] - net_.points[b]); };
    if (q.size() == 3) {
      net_.faces.push_back({q[0], q[1], q[2]});
    } else if (distance(q[0], q[2]) <= distance(q[1], q[3])) {
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

  const Surface::Box& box_;
  GradedGrid grid_;
  std::map<Coordinates, std::vector<std::pair<Crossing, Index>>> sheets_;  ///< by the cell's low
  std::set<std::pair<Coordinates, std::size_t>> seen_;                     ///< edges of small cells
  std::vector<double> crossings_;
  std::vector<std::vector<Index>> polygons_;
  SurfaceNet net_;
};

}  // namespace

SurfaceNet surface_net(Projection& f, const Surface::Box& box, const Grid& grid,
                       const std::vector<FineSpot>& spots) {
  return Net(f, box, grid, spots).make();
}

}  // namespace crest::smooth_ridges
