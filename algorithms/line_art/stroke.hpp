// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the pen does: polylines on the page with a width at every point.
#include <cstdint>
#include <vector>

#include "kernel/arithmetic/vec3.hpp"
#include "kernel/geometry/index.hpp"

namespace crest::line_art {

using kernel::Index;
using kernel::kNone;
using kernel::Vec2;

enum class StrokeKind : std::uint8_t { rib, cross, streamline, contour };
const char* name_of(StrokeKind kind);

struct Stroke {
  StrokeKind kind = StrokeKind::contour;
  Index segment = kNone;                ///< of the picture; contours: none
  Index rank = 0;                       ///< order of painting within the segment; the later covers
  std::vector<Vec2> points;             ///< mm; closed: the last is the first
  std::vector<double> widths;           ///< mm, one a point
  Index face = kNone;                   ///< hatches: the nearest one where it begins
  double band = 0;                      ///< mm of white painted below, 0: none
  Vec2 start_cut{0, 0}, end_cut{0, 0};  ///< ends run along this direction; zero: round
  double length() const;
};

/// The direction of a; zero if a is.
Vec2 unit(const Vec2& a);

/// The area that the pen covers, as a closed polygon to be filled where it winds: sharp bends
/// mitred, ends round or cut. At least two points that differ, else empty.
std::vector<Vec2> outline(const Stroke& stroke);
/// The same of its white band.
std::vector<Vec2> band_outline(const Stroke& stroke);

/// The line without points that lie within `error` of those that stay; its ends stay.
std::vector<Vec2> simplified(const std::vector<Vec2>& line, double error);

/// The polyline with points of equal distance along it, about `step`; its ends are kept.
std::vector<Vec2> resample(const std::vector<Vec2>& line, double step);

}  // namespace crest::line_art
