// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "io/picture/picture_file.hpp"
#include "io/vector_fields/convolution.hpp"
#include "io/vector_fields/skeleton_writer.hpp"

namespace crest::io {
namespace {

using namespace vector_fields;

constexpr int kLongest = 1000, kMargin = 20;  ///< pixels
constexpr Rgb kBlue = {40, 84, 232}, kRed = {222, 34, 40}, kGreen = {30, 160, 60},
              kYellow = {250, 214, 40}, kBlack = {0, 0, 0}, kViolet = {150, 60, 190},
              kGrey = {120, 120, 124};

/// From above, x to the right.
Camera plane_camera(const PlanarField& field) {
  Vec2 low = field.points.front(), high = low;
  for (const Vec2& p : field.points)
    for (std::size_t k = 0; k < 2; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  const double w = high[0] - low[0], h = high[1] - low[1];
  Camera camera;
  camera.right = {1, 0, 0};
  camera.up = {0, 1, 0};
  camera.forward = {0, 0, -1};
  camera.centre = {low[0] + w / 2, low[1] + h / 2, 0};
  camera.scale = kLongest / std::max(w, h);
  const auto pixels = [&](double length) {
    return static_cast<int>(std::lround(camera.scale * length)) + 2 * kMargin;
  };
  camera.width = std::max(pixels(w), 320);  // the legend's width
  camera.height = pixels(h);
  return camera;
}

kernel::Vec3 pixel(const Camera& camera, const Vec2& p) {
  return camera.project({p[0], p[1], 0});
}

Rgb colour_of(const CriticalPoint& c) {
  switch (c.kind) {
    case ZeroKind::saddle:
      return kBlue;
    case ZeroKind::source:
      return kRed;
    case ZeroKind::sink:
      return kGreen;
    default:
      return kViolet;
  }
}

/// The lines of a skeleton by colour, in the order of painting.
void add_lines(const Camera& camera, const Skeleton& s, Drawing& drawing) {
  const auto line = [&](std::vector<std::vector<kernel::Vec3>>& strokes, const std::vector<Vec2>& x,
                        bool closed) {
    auto& stroke = strokes.emplace_back();
    for (const Vec2& p : x) stroke.push_back(pixel(camera, p));
    if (closed) stroke.push_back(stroke.front());
    if (stroke.size() < 2) strokes.pop_back();
  };
  StrokeClass in{"inflow", kGreen, {}, true, 1.2}, out{"outflow", kRed, {}, true, 1.2},
      none{"no flow across", kGrey, {}, true, 1.2}, lines{"separatrix", kBlack, {}, true, 0.7},
      orbits{"closed orbit", kViolet, {}, true, 1.4};
  for (const BoundaryPiece& p : s.boundary)
    line((p.flow > 0 ? in : p.flow < 0 ? out : none).strokes, {p.from, p.to}, false);
  for (const Separatrix& l : s.separatrices) line(lines.strokes, l.line, false);
  for (const ClosedOrbit& o : s.orbits) line(orbits.strokes, o.line, true);
  for (StrokeClass* c : {&none, &in, &out, &lines, &orbits})
    if (!c->strokes.empty()) drawing.classes.push_back(std::move(*c));
}

void add_dots(const Camera& camera, const Skeleton& s, Drawing& drawing) {
  struct Kind {
    const char* label;
    Rgb colour;
    bool seen = false;
  };
  Kind kinds[] = {{"saddle", kBlue}, {"source", kRed}, {"sink", kGreen}, {"other zero", kViolet}};
  for (const CriticalPoint& c : s.critical_points) {
    if (c.where == ZeroPlace::region || c.where == ZeroPlace::line) continue;
    const Rgb colour = colour_of(c);
    drawing.dots.push_back({pixel(camera, c.point), colour});
    for (Kind& k : kinds)
      k.seen = k.seen || (k.colour.red == colour.red && k.colour.blue == colour.blue);
  }
  for (const SwitchPoint& p : s.switch_points)
    drawing.dots.push_back({pixel(camera, p.point), kYellow, Mark::diamond, p.inside ? 1.0 : 0.7});
  for (const Kind& k : kinds)
    if (k.seen) drawing.legend.push_back({k.label, k.colour, true});
  if (!s.switch_points.empty())
    drawing.legend.push_back({"switch point", kYellow, true, Mark::diamond});
}

}  // namespace

void write_skeleton_picture(const std::string& path, const SkeletonScene& scene) {
  check_picture_path(path);
  const Camera camera = plane_camera(*scene.field);
  Canvas canvas(camera.width, camera.height);
  const auto pixels = convolve(*scene.field, camera);
  std::vector<std::uint8_t> dark;
  for (int y = 0; y < canvas.sample_height(); ++y)
    for (int x = 0; x < canvas.sample_width(); ++x)
      dark.push_back(pixels[static_cast<std::size_t>(y / kSamples * camera.width + x / kSamples)]);
  canvas.stamp(0, 0,
               {dark.data(), canvas.sample_width(), canvas.sample_height(), canvas.sample_width()},
               {40, 44, 54});
  Drawing drawing{};
  add_lines(camera, *scene.skeleton, drawing);
  add_dots(camera, *scene.skeleton, drawing);
  set_sizes(camera, drawing);
  add_class_legend(drawing);
  write_drawing(path, camera, canvas, drawing, true);
}

}  // namespace crest::io
