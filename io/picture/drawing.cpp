// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/picture/drawing.hpp"

#include <algorithm>
#include <cmath>

namespace crest::io {

using kernel::Vec3;
Rgb casing(Rgb colour) {
  const auto darker = [](std::uint8_t c) { return static_cast<std::uint8_t>(c * 2 / 5); };
  return {darker(colour.red), darker(colour.green), darker(colour.blue)};
}

bool in_sight(const Camera& camera, const Canvas& surface, const Vec3& pixel, double slack) {
  return surface.visible(pixel, slack * 0.003 * camera.width);
}

void StrokeMaker::add(const Vec3& from, const Vec3& to, std::size_t stroke_class) {
  if (stroke_class != class_) end();
  class_ = stroke_class;
  const Vec3 p = camera_.project(from), q = camera_.project(to);
  const double length = std::hypot(q[0] - p[0], q[1] - p[1]);
  const int steps = static_cast<int>(std::clamp(std::ceil(length), 1.0, 1e5));
  const auto at = [&](int i) {
    const double t = static_cast<double>(i) / steps;
    return combine(1 - t, p, t, q);
  };
  bool before = in_sight(camera_, surface_, p, slack_);
  for (int i = 1; i <= steps; ++i) {
    const bool now = in_sight(camera_, surface_, at(i), slack_);
    if (before && now && stroke_.empty()) stroke_.push_back(at(i - 1));
    if (!now && before && !stroke_.empty()) {
      stroke_.push_back(at(i - 1));
      end();
    }
    before = now;
  }
  if (before && !stroke_.empty()) stroke_.push_back(q);
}

void StrokeMaker::end() {
  if (stroke_.size() > 1) drawing_.classes[class_].strokes.push_back(std::move(stroke_));
  stroke_.clear();
}

void set_sizes(const Camera& camera, Drawing& drawing) {
  constexpr double stroke_share = 0.10, dot_share = 0.02, pi = 3.14159;
  const double area = static_cast<double>(camera.width) * camera.height;
  double length = 1;
  for (const StrokeClass& c : drawing.classes) {
    for (const auto& stroke : c.strokes)
      for (std::size_t i = 0; i + 1 < stroke.size(); ++i)
        length += std::hypot(stroke[i + 1][0] - stroke[i][0], stroke[i + 1][1] - stroke[i][1]);
  }
  const double unit = std::max(camera.width / 1200.0, 0.4);
  drawing.stroke_width = std::clamp(stroke_share * area / length, 1.2 * unit, 3.2 * unit);
  drawing.casing_width = 1.4 * drawing.stroke_width;
  const auto dots = static_cast<double>(drawing.dots.size() + 1);
  drawing.dot_radius =
      std::clamp(std::sqrt(dot_share * area / (pi * dots)), 1.8 * unit, 6.6 * unit);
}

void add_class_legend(Drawing& drawing) {
  for (auto c = drawing.classes.rbegin(); c != drawing.classes.rend(); ++c)
    if (c->in_graph) drawing.legend.push_back({c->label, c->colour, false});
}

void add_note(const std::string& note, Drawing& drawing) {
  if (!note.empty()) drawing.legend.push_back({note, {255, 255, 255}, false});
}

}  // namespace crest::io
