// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What hatches may not cross: the visible pieces of occluding edges and of rims seen edge-on, on
// the page.
#include <optional>
#include <vector>

#include "algorithms/line_art/contours.hpp"

namespace crest::line_art {

struct Barrier {
  Vec2 from, to;
};

class Barriers {
 public:
  Barriers(const Scene& scene, const View& view, const Contours& contours);

  const std::vector<Barrier>& all() const { return all_; }
  /// How far from p towards q the way is free: below 1 where a barrier comes within `clearance`.
  double free_share(const Vec2& p, const Vec2& q, double clearance) const;
  /// Does the segment meet a barrier, or come within a nanometre of one: not a decision about zero,
  /// doubles on a page err by far less.
  bool crosses(const Vec2& p, const Vec2& q) const;
  /// The distance of the nearest barrier, at most `most`, and its direction.
  struct Near {
    double distance;
    Vec2 direction;
  };
  std::optional<Near> nearest(const Vec2& p, double most) const;

 private:
  template <class Take>
  void visit(double x0, double y0, double x1, double y1, Take&& take) const;

  std::vector<Barrier> all_;
  double cell_ = 1;
  int columns_ = 1, rows_ = 1;
  std::vector<Index> begin_, items_;
};

/// The distance between two segments.
double distance_between(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d);
/// Of a point to a segment.
double distance_to(const Vec2& p, const Vec2& a, const Vec2& b);

}  // namespace crest::line_art
