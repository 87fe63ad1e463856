// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Ridges as drawn: polylines with a type for each of their segments.
#include <vector>

#include "algorithms/ridges/ridge_graph.hpp"

namespace crest::io {

/// A point of a ridge and the segment that starts in it.
struct LinePoint {
  kernel::Vec3 point;
  const ridges::Crossing* crossing;  ///< null in the umbilic's patch
  ridges::RidgeType fourth_order;    ///< of the segment after it, at the end the one before
  ridges::RidgeType third_order;     ///< likewise
  std::uint8_t level;                ///< of the crossing, in a patch of the one beside it
  bool spur = false;                 ///< not to be drawn (drawn_lines.hpp)
};

/// Lead-in, crossings, lead-out. A segment that leads to or from the first or last crossing has
/// that crossing's type. In a loop the segment after the last point returns to the first.
inline std::vector<LinePoint> line_points(const ridges::Ridge& ridge) {
  using ridges::RidgeType;
  std::vector<LinePoint> line;
  if (ridge.crossings.empty()) return line;
  const std::size_t n = ridge.crossings.size(), segments = ridge.segment_count();
  const RidgeType first = ridge.crossings.front().type, last = ridge.crossings.back().type;
  for (const kernel::Vec3& p : ridge.lead_in)
    line.push_back({p, nullptr, first, first, ridge.crossings.front().level});
  for (std::size_t i = 0; i < n; ++i) {
    LinePoint point{ridge.crossings[i].point, &ridge.crossings[i], last, last,
                    ridge.crossings[i].level};
    if (i < segments) point.fourth_order = ridge.fourth_order(i);
    if (i < segments) point.third_order = point.fourth_order;
    if (i < segments && i < ridge.third_order.size()) point.third_order = ridge.third_order[i];
    line.push_back(point);
  }
  for (const kernel::Vec3& p : ridge.lead_out)
    line.push_back({p, nullptr, last, last, ridge.crossings.back().level});
  if (ridge.lead_out.empty() && segments > 0 && !ridge.loop) {
    line.back().fourth_order = line[line.size() - 2].fourth_order;
    line.back().third_order = line[line.size() - 2].third_order;
  }
  return line;
}

}  // namespace crest::io
