// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What a picture shows over the surface: visible strokes, marks, a legend; on either medium.
#include <cstdint>
#include <string>
#include <vector>

#include "io/picture/camera.hpp"
#include "io/picture/rasteriser.hpp"

namespace crest::io {

/// Strokes of one colour, in pixels; every stroke has at least two points.
struct StrokeClass {
  const char* label;
  Rgb colour;
  std::vector<std::vector<kernel::Vec3>> strokes;
  bool in_graph = false;  ///< visible or not
  double width = 1;       ///< in stroke widths
};

enum class Mark : std::uint8_t { disk, triangle, diamond };

struct Dot {
  kernel::Vec3 centre;
  Rgb colour;
  Mark mark = Mark::disk;
  double size = 1;  ///< in dot radii
};

struct LegendEntry {
  std::string label;
  Rgb colour;
  bool dot;
  Mark mark = Mark::disk;
  double size = 1;
};

/// Classes in the order of painting (later ones cover earlier ones).
struct Drawing {
  std::vector<StrokeClass> classes;
  std::vector<Dot> dots;
  std::vector<LegendEntry> legend;
  double stroke_width, casing_width, dot_radius;  ///< pixels
};

/// A darker tone of the same colour, for rims.
Rgb casing(Rgb colour);

/// Whether the eye sees a point of the surface; the bias only covers rounding and what polylines
/// cut off. slack: so many times that bias.
bool in_sight(const Camera& camera, const Canvas& surface, const kernel::Vec3& pixel,
              double slack = 1);

/// Adds the visible parts of a line on the surface, a stroke for each run of one class.
class StrokeMaker {
 public:
  StrokeMaker(const Camera& camera, const Canvas& surface, Drawing& drawing, double slack = 1)
      : camera_(camera), surface_(surface), drawing_(drawing), slack_(slack) {}
  /// Requires: `from` is where the last segment ended, or end() was called.
  void add(const kernel::Vec3& from, const kernel::Vec3& to, std::size_t stroke_class);
  void end();

 private:
  const Camera& camera_;
  const Canvas& surface_;
  Drawing& drawing_;
  double slack_;
  std::size_t class_ = 0;
  std::vector<kernel::Vec3> stroke_;
};

/// Widths and radii: they grow with the picture and shrink when ink would cover more than its share
/// of it.
void set_sizes(const Camera& camera, Drawing& drawing);
/// The classes that are in the drawing, the last one painted first.
void add_class_legend(Drawing& drawing);
/// A line of words without a sign, if there are any.
void add_note(const std::string& note, Drawing& drawing);

}  // namespace crest::io
