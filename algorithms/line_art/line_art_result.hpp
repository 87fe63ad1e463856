// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A drawing: what is seen, and the strokes of the pen.
#include <array>
#include <optional>
#include <string>

#include "algorithms/line_art/chains.hpp"

namespace crest::line_art {

/// A cell of the page, means over the surface in it.
struct ToneCell {
  Vec2 corner;        ///< mm, the upper left
  double black, ink;  ///< what is covered, what is wanted
  double bare;        ///< share that is to be hatched but has no stroke near
};

struct ToneError {
  double mean = 0, p95 = 0, max = 0;  ///< of luminance in cells of five spacings
  std::vector<ToneCell> cells;        ///< the worst first
};

struct HatchCounts {
  std::size_t singularities = 0;
  double index_sum = 0;  ///< of the field, on the whole surface
  std::size_t segments = 0, key_ribs = 0, blended = 0;
  double length = 0;                   ///< mm
  double p5 = 0, median = 0, p95 = 0;  ///< spacing, mm
  double median_length = 0;            ///< of strokes, mm
  double bare = 0;                     ///< share of what is to be hatched beyond the spacing
  std::size_t over_contours = 0;       ///< strokes that come within a nanometre of a contour
  ToneError tone;
};

/// A fishbone, by what makes it again.
struct Segment {
  std::vector<Vec2> backbone;
  std::vector<double> key_ribs;  ///< arc lengths on the backbone
};

/// What a user may say about a part of the page; the first one that holds a pixel counts.
struct Region {
  enum class Field : std::uint8_t { max, min, angle, coons, off };
  std::vector<std::vector<Vec2>> rings;  ///< even-odd
  Field field = Field::max;
  double angle = 0;                                 ///< degrees, from the right, upwards
  std::array<std::vector<Vec2>, 4> coons;           ///< below, right, above, left: ends meet
  std::optional<std::array<double, 2>> tones = {};  ///< luminance is clamped to these
  double gauss = 0, median = 0;                     ///< mm, filters of luminance
};

/// What replaces the automatic choices.
struct Steering {
  std::vector<Segment> segments;  ///< drawn as they are, instead of the automatic ones
  std::vector<Region> regions;
};

struct Drawing {
  Scene scene;
  View view;
  Contours contours;
  DrawnContours lines;          ///< the contours' strokes
  bool one_sheet = false;       ///< proved: no face goes through another (sheets.hpp)
  std::vector<Stroke> hatches;  ///< in the order of painting
  HatchCounts counts;           ///< of the hatches
  std::vector<Segment> segments;
  std::vector<Region> regions;  ///< as given
  std::string title, parameters;
};

}  // namespace crest::line_art
