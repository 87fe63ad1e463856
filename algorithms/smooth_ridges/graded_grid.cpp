// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/smooth_ridges/graded_grid.hpp"

#include <algorithm>

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

GradedGrid::GradedGrid(Projection& f, const Surface::Box& box, const Grid& grid,
                       const std::vector<FineSpot>& spots)
    : f_(f), box_(box), grid_(grid) {
  constexpr unsigned kDeepest = 20;
  const std::size_t longest = std::max({grid.points[0], grid.points[1], grid.points[2]});
  double least = grid.cell;
  for (const FineSpot& s : spots) least = std::min(least, s.size);
  while (depth_ < kDeepest && longest << (depth_ + 1) < std::size_t{1} << 31 &&
         std::ldexp(grid.cell, -static_cast<int>(depth_)) > least)
    ++depth_;
  coarse_.resize(grid_.size());
  for (Coordinates p{}; p[0] <= end(0); p[0] += unit())
    for (p[1] = 0; p[1] <= end(1); p[1] += unit())
      for (p[2] = 0; p[2] <= end(2); p[2] += unit()) coarse_[number(p)] = sample(p);
  if (depth_ > 0) cut_near(spots);
}

Vec3 GradedGrid::place(const Coordinates& p) const {
  const double side = 1.0 / unit();
  return grid_.at(p[0] * side, p[1] * side, p[2] * side);
}

double GradedGrid::sample(const Coordinates& p) {
  Vec3 x = place(p);
  for (std::size_t k = 0; k < 3; ++k) x[k] = std::clamp(x[k], box_[2 * k], box_[2 * k + 1]);
  return f_.value(x);
}

void GradedGrid::cut_near(const std::vector<FineSpot>& spots) {
  std::vector<FineSpot> inside;  // in the grid's coordinates, sizes too
  for (const FineSpot& s : spots) {
    const Vec3 d = s.place - grid_.origin;
    FineSpot& t = inside.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) t.place[k] = dot(d, grid_.axes[k]) / grid_.cell * unit();
    t.size = s.size / grid_.cell * unit();
  }
  for (Coordinates p{}; p[0] < end(0); p[0] += unit())
    for (p[1] = 0; p[1] < end(1); p[1] += unit())
      for (p[2] = 0; p[2] < end(2); p[2] += unit()) divide({p, unit()}, inside);
}

/// Cuts the cell while it is larger than a spot allows: its size, or half the distance.
void GradedGrid::divide(const Cell& c, const std::vector<FineSpot>& spots) {
  std::vector<FineSpot> near;
  for (const FineSpot& s : spots) {
    double distance = 0;
    for (std::size_t k = 0; k < 3; ++k)
      distance = std::max({distance, c.low[k] - s.place[k], s.place[k] - (c.low[k] + c.side)});
    if (c.side > s.size && c.side > distance / 2) near.push_back(s);
  }
  if (!near.empty() && c.side > 1) {
    const std::uint32_t half = c.side / 2;
    for (std::uint32_t i = 0; i < 8; ++i)
      divide(
          {{c.low[0] + (i & 1) * half, c.low[1] + (i >> 1 & 1) * half, c.low[2] + (i >> 2) * half},
           half},
          near);
    return;
  }
  if (c.side == unit()) return;
  small_.push_back(c);
  small_side_.emplace(c.low, c.side);
  for (std::uint32_t i = 0; i < 8; ++i) {
    const Coordinates p = {c.low[0] + (i & 1) * c.side, c.low[1] + (i >> 1 & 1) * c.side,
                           c.low[2] + (i >> 2) * c.side};
    if (!is_corner(p)) fine_.emplace(p, sample(p));
  }
}

GradedGrid::Cell GradedGrid::cell_above(const Coordinates& p) const {
  for (std::uint32_t side = unit() / 2; side > 0; side /= 2) {
    const Coordinates low = {p[0] & ~(side - 1), p[1] & ~(side - 1), p[2] & ~(side - 1)};
    const auto found = small_side_.find(low);
    if (found != small_side_.end() && found->second == side) return {low, side};
  }
  const std::uint32_t rest = ~(unit() - 1);
  return {{p[0] & rest, p[1] & rest, p[2] & rest}, unit()};
}

}  // namespace crest::smooth_ridges
