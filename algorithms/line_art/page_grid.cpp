// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/line_art/page_grid.hpp"

namespace crest::line_art {

CellFrame::CellFrame(std::span<const PagePoint> points, double edge, std::size_t items) {
  PageBox box;
  for (const PagePoint& p : points)
    if (std::isfinite(p.x + p.y)) box.add({p.x, p.y, 0, 0});
  if (!(box.x1 >= box.x0)) return;
  const double width = box.x1 - box.x0, height = box.y1 - box.y0;
  // Few, long edges or many: never more cells than items, nor more than 4096 a side.
  const double least =
      std::sqrt(width * height / static_cast<double>(std::max<std::size_t>(items, 1)));
  cell_ = std::max({2 * edge, least, width / 4096, height / 4096});
  if (!(cell_ > 0) || !std::isfinite(cell_)) cell_ = std::max({width, height, 1.0});
  inverse_ = 1 / cell_;
  x0_ = box.x0;
  y0_ = box.y0;
  columns_ = static_cast<int>(width * inverse_) + 1;
  rows_ = static_cast<int>(height * inverse_) + 1;
}

std::pair<int, int> CellFrame::columns_in_row(std::span<const PagePoint* const> corners, int r,
                                              int c0, int c1) const {
  double radius = 0;
  for (const PagePoint* p : corners) radius = std::max(radius, p->radius);
  // The slack covers the rounding of the interpolation: cells are no smaller than 1/4096 of all.
  const double slack = radius + 1e-6 * cell_;
  const double low = y0_ + r * cell_ - slack, high = y0_ + (r + 1) * cell_ + slack;
  double x0 = HUGE_VAL, x1 = -HUGE_VAL;
  const auto add = [&](double x) {
    x0 = std::min(x0, x);
    x1 = std::max(x1, x);
  };
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const PagePoint &p = *corners[i], &q = *corners[(i + 1) % corners.size()];
    if (std::max(p.y, q.y) < low || std::min(p.y, q.y) > high) continue;
    for (const double y : {low, high})
      if ((p.y < y) != (q.y < y)) add(p.x + (q.x - p.x) * ((y - p.y) / (q.y - p.y)));
    for (const PagePoint* v : {&p, &q})
      if (v->y >= low && v->y <= high) add(v->x);
  }
  // Above the last row's end or below the first's start: those cells take all that is beyond.
  if (x0 > x1) return {c0, c1};
  return {std::max(c0, column(x0 - slack)), std::min(c1, column(x1 + slack))};
}

}  // namespace crest::line_art
