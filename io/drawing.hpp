// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What a picture shows over the surface: visible strokes, umbilics, a legend; on either medium.
#include <string>
#include <vector>

#include "io/camera.hpp"
#include "io/rasteriser.hpp"

namespace crest::io {

/// Strokes of one colour, in pixels; every stroke has at least two points.
struct StrokeClass {
  const char* label;
  Colour colour;
  std::vector<std::vector<kernel::Vec3>> strokes;
  bool in_graph = false;  ///< visible or not
  double width = 1;       ///< in stroke widths
};

struct Dot {
  kernel::Vec3 centre;
  Colour colour;
};

struct LegendEntry {
  const char* label;
  Colour colour;
  bool dot;
};

/// Classes in the order of painting (later ones cover earlier ones).
struct Drawing {
  std::vector<StrokeClass> classes;
  std::vector<Dot> dots;
  std::vector<LegendEntry> legend;
  double stroke_width, casing_width, dot_radius;  ///< pixels
};

/// A darker tone of the same colour, for rims.
Colour casing(Colour colour);

/// Cuts the ridges where the canvas's surface hides them. order: 3 or 4, which types to use.
/// Strokes and dots become thinner where there are too many for the picture.
Drawing make_drawing(const Camera& camera, const Canvas& surface, const kernel::TriangleMesh& mesh,
                     const std::vector<kernel::Vec3>& normals, const ridges::RidgeGraph& graph,
                     int order);

/// Writes the shaded surface on `canvas` with the drawing over it, .svg or .png by the extension.
/// Throws: kernel::InputError (write_picture).
void write_drawing(const std::string& path, const Camera& camera, Canvas& canvas,
                   const Drawing& drawing, bool show_legend);

/// Lower-case words in a 5 x 8 dot font, `size` pixels a dot; x, y is the upper left corner.
void draw_text(Canvas& canvas, double x, double y, double size, const std::string& text);

/// The width of a text in dots.
double text_width(const std::string& text);

}  // namespace crest::io
