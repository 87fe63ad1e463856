// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/picture/drawing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace crest::io {
namespace {

using kernel::Vec3;

/// Columns of dots, the lowest bit on top.
using Glyph = std::array<std::uint8_t, 5>;
const std::map<char, Glyph>& font() {
  static const std::map<char, Glyph> glyphs = {
      {'a', {0x20, 0x54, 0x54, 0x54, 0x78}}, {'b', {0x7f, 0x48, 0x44, 0x44, 0x38}},
      {'c', {0x38, 0x44, 0x44, 0x44, 0x28}}, {'d', {0x38, 0x44, 0x44, 0x48, 0x7f}},
      {'e', {0x38, 0x54, 0x54, 0x54, 0x18}}, {'f', {0x00, 0x08, 0x7e, 0x09, 0x02}},
      {'g', {0x18, 0xa4, 0xa4, 0xa4, 0x7c}}, {'h', {0x7f, 0x08, 0x04, 0x04, 0x78}},
      {'i', {0x00, 0x44, 0x7d, 0x40, 0x00}}, {'l', {0x00, 0x41, 0x7f, 0x40, 0x00}},
      {'m', {0x7c, 0x04, 0x78, 0x04, 0x78}}, {'n', {0x7c, 0x08, 0x04, 0x04, 0x78}},
      {'o', {0x38, 0x44, 0x44, 0x44, 0x38}}, {'p', {0xfc, 0x24, 0x24, 0x24, 0x18}},
      {'r', {0x7c, 0x08, 0x04, 0x04, 0x08}}, {'t', {0x04, 0x04, 0x3f, 0x44, 0x24}},
      {'u', {0x3c, 0x40, 0x40, 0x20, 0x7c}}, {'y', {0x1c, 0xa0, 0xa0, 0xa0, 0x7c}},
      {'1', {0x00, 0x42, 0x7f, 0x40, 0x00}}, {'3', {0x22, 0x41, 0x49, 0x49, 0x36}},
      {'-', {0x08, 0x08, 0x08, 0x08, 0x08}}, {',', {0x00, 0x80, 0x60, 0x00, 0x00}},
      {'0', {0x3e, 0x51, 0x49, 0x45, 0x3e}}, {'2', {0x42, 0x61, 0x51, 0x49, 0x46}},
      {'4', {0x18, 0x14, 0x12, 0x7f, 0x10}}, {'5', {0x27, 0x45, 0x45, 0x45, 0x39}},
      {'6', {0x3c, 0x4a, 0x49, 0x49, 0x30}}, {'7', {0x01, 0x71, 0x09, 0x05, 0x03}},
      {'8', {0x36, 0x49, 0x49, 0x49, 0x36}}, {'9', {0x06, 0x49, 0x49, 0x29, 0x1e}},
      {'.', {0x00, 0x60, 0x60, 0x00, 0x00}}, {'+', {0x08, 0x08, 0x3e, 0x08, 0x08}},
      {'k', {0x7f, 0x10, 0x28, 0x44, 0x00}}, {'s', {0x48, 0x54, 0x54, 0x54, 0x20}},
      {'/', {0x60, 0x10, 0x08, 0x04, 0x03}}, {'v', {0x1c, 0x20, 0x40, 0x20, 0x1c}},
      {'x', {0x44, 0x28, 0x10, 0x28, 0x44}}};
  return glyphs;
}

constexpr double kAdvance = 6;  // dots

}  // namespace

Rgb casing(Rgb colour) {
  const auto darker = [](std::uint8_t c) { return static_cast<std::uint8_t>(c * 2 / 5); };
  return {darker(colour.red), darker(colour.green), darker(colour.blue)};
}

bool in_sight(const Camera& camera, const Canvas& surface, const Vec3& pixel) {
  return surface.visible(pixel, 0.003 * camera.width);
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
  bool before = in_sight(camera_, surface_, p);
  for (int i = 1; i <= steps; ++i) {
    const bool now = in_sight(camera_, surface_, at(i));
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

void draw_text(Canvas& canvas, double x, double y, double size, const std::string& text) {
  for (char c : text) {
    const auto glyph = font().find(c);
    for (std::size_t column = 0; glyph != font().end() && column < 5; ++column) {
      for (int row = 0; row < 8; ++row) {
        if ((glyph->second[column] >> row & 1) == 0) continue;
        const double left = x + static_cast<double>(column) * size, top = y + row * size;
        canvas.fill_box(left, top, left + size, top + size, {40, 40, 44});
      }
    }
    x += kAdvance * size;
  }
}

double text_width(const std::string& text) {
  return kAdvance * static_cast<double>(text.size());
}

}  // namespace crest::io
