// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A uniform grid over the picture that finds candidates: what may meet in the picture, never what
// does. Boxes are inflated by bounds on the rounding of the projection.
#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>
#include <vector>

#include "algorithms/line_art/scene.hpp"

namespace crest::line_art {

/// A point of the picture in double. near grows towards the eye.
struct PagePoint {
  double x = 0, y = 0, near = 0;
  double radius = 0;  ///< bound on the error of each
};

/// A box with a range of nearness, inflated.
struct PageBox {
  double x0 = HUGE_VAL, x1 = -HUGE_VAL, y0 = HUGE_VAL, y1 = -HUGE_VAL;
  double near0 = HUGE_VAL, near1 = -HUGE_VAL;
  void add(const PagePoint& p) {
    x0 = std::min(x0, p.x - p.radius);
    x1 = std::max(x1, p.x + p.radius);
    y0 = std::min(y0, p.y - p.radius);
    y1 = std::max(y1, p.y + p.radius);
    near0 = std::min(near0, p.near - p.radius);
    near1 = std::max(near1, p.near + p.radius);
  }
  bool meets(const PageBox& o) const {
    return x0 <= o.x1 && o.x0 <= x1 && y0 <= o.y1 && o.y0 <= y1;
  }
};

/// Cells of equal squares that cover all points.
class CellFrame {
 public:
  /// About two mean edges a cell, as many cells as `items` at most.
  CellFrame(std::span<const PagePoint> points, double edge, std::size_t items);
  std::size_t size() const {
    return static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  }

  /// Calls take(cell) for cells that cover the corners' convex hull, each once.
  template <class Take>
  void visit(std::span<const PagePoint* const> corners, Take&& take) const {
    PageBox box;
    for (const PagePoint* p : corners) box.add(*p);
    const int c0 = column(box.x0), c1 = column(box.x1), r0 = row(box.y0), r1 = row(box.y1);
    const bool small =
        (c1 - c0 <= 1 && r1 - r0 <= 1) || !std::isfinite(box.x1 - box.x0 + box.y1 - box.y0);
    for (int r = r0; r <= r1; ++r) {
      int from = c0, to = c1;
      if (!small) std::tie(from, to) = columns_in_row(corners, r, c0, c1);
      for (int c = from; c <= to; ++c)
        take(static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) +
             static_cast<std::size_t>(c));
    }
  }

 private:
  int column(double x) const { return clamped((x - x0_) * inverse_, columns_); }
  int row(double y) const { return clamped((y - y0_) * inverse_, rows_); }
  static int clamped(double at, int count) {
    return at >= count ? count - 1 : at > 0 ? static_cast<int>(at) : 0;
  }
  std::pair<int, int> columns_in_row(std::span<const PagePoint* const> corners, int r, int c0,
                                     int c1) const;

  double x0_ = 0, y0_ = 0, cell_ = 1, inverse_ = 1;
  int columns_ = 1, rows_ = 1;
};

/// Which items lie in a cell.
class CellLists {
 public:
  /// corners_of(item) gives a small array of pointers to the corners.
  template <class CornersOf>
  CellLists(const CellFrame& frame, Index items, CornersOf&& corners_of)
      : begin_(frame.size() + 1, 0) {
    for (Index i = 0; i < items; ++i)
      frame.visit(corners_of(i), [&](std::size_t cell) { ++begin_[cell + 1]; });
    for (std::size_t c = 1; c < begin_.size(); ++c) begin_[c] += begin_[c - 1];
    items_.resize(begin_.back());
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    for (Index i = 0; i < items; ++i)
      frame.visit(corners_of(i), [&](std::size_t cell) { items_[next[cell]++] = i; });
  }
  std::span<const Index> at(std::size_t cell) const {
    return {items_.data() + begin_[cell], items_.data() + begin_[cell + 1]};
  }
  /// Of all cells that cover the corners' hull, each once, ascending.
  void gather(const CellFrame& frame, std::span<const PagePoint* const> corners,
              std::vector<Index>& found) const {
    found.clear();
    int cells = 0;
    frame.visit(corners, [&](std::size_t cell) {
      const auto list = at(cell);
      found.insert(found.end(), list.begin(), list.end());
      ++cells;
    });
    if (cells < 2) return;
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
  }

 private:
  std::vector<std::uint32_t> begin_;
  std::vector<Index> items_;
};

}  // namespace crest::line_art
