// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/picture/drawing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "io/ridges/ridge_lines.hpp"

namespace crest::io {
namespace {

using kernel::Vec3;
using ridges::RidgeType;
using ridges::UmbilicKind;

constexpr Colour kGrey = {128, 128, 128};

std::size_t class_of(ridges::Colour colour, RidgeType type) {
  return ridge_class(static_cast<std::size_t>(colour), static_cast<std::size_t>(type));
}

Colour dot_colour(UmbilicKind kind) {
  if (kind == UmbilicKind::one_ridge) return {255, 255, 255};
  if (kind == UmbilicKind::three_ridge) return {0, 0, 0};
  return kGrey;
}

/// Tells which points the eye can see.
class Sight {
 public:
  Sight(const Camera& camera, const Canvas& surface, const kernel::TriangleMesh& mesh,
        const std::vector<Vec3>& normals)
      : camera_(camera), surface_(surface), mesh_(mesh), normals_(normals), outward_(side(mesh)) {}

  bool free(const Vec3& pixel) const { return in_sight(camera_, surface_, pixel); }

  /// The back of a closed surface is hidden even where the bias does not tell, at its outline.
  bool faces_eye(kernel::Index v, kernel::Index w) const {
    if (!mesh_.closed()) return true;
    const Vec3 n = combine(1, normals_[v], 1, normals_[w]);
    return outward_ * dot(normalised(n, combine(-1, camera_.forward, 0, n)), camera_.forward) < 0.1;
  }
  bool faces_eye(const ridges::Crossing& crossing) const {
    const kernel::Edge& e = mesh_.edges()[crossing.edge];
    return faces_eye(e.v0, e.v1);
  }
  bool faces_eye(const ridges::Umbilic& umbilic) const {
    const kernel::Triangle& f = mesh_.faces()[umbilic.face];
    return faces_eye(f[0], f[1]);
  }
  const Camera& camera() const { return camera_; }

 private:
  /// 1 if the normals point out of a closed mesh, -1 if into it: the sign of its volume.
  static double side(const kernel::TriangleMesh& mesh) {
    double volume = 0;
    const Vec3& o = mesh.points()[0];
    for (const kernel::Triangle& f : mesh.faces()) {
      Vec3 e[3];
      for (std::size_t k = 0; k < 3; ++k) e[k] = combine(1, mesh.points()[f[k]], -1, o);
      volume += e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) +
                e[0][1] * (e[1][2] * e[2][0] - e[1][0] * e[2][2]) +
                e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
    }
    return volume < 0 ? -1 : 1;
  }

  const Camera& camera_;
  const Canvas& surface_;
  const kernel::TriangleMesh& mesh_;
  const std::vector<Vec3>& normals_;
  double outward_;
};

void add_strokes(const Sight& sight, const Canvas& surface, const ridges::RidgeGraph& graph,
                 int order, Drawing& drawing) {
  StrokeMaker maker(sight.camera(), surface, drawing);
  const auto hidden = [&](const LinePoint& p) {
    return p.crossing != nullptr && !sight.faces_eye(*p.crossing);
  };
  for (const ridges::Ridge& ridge : graph.ridges) {
    const std::vector<LinePoint> line = line_points(ridge);
    const std::size_t n = line.size();
    for (std::size_t i = 0; i + (ridge.loop ? 0 : 1) < n; ++i) {
      const LinePoint& next = line[(i + 1) % n];
      const RidgeType type = order == 3 ? line[i].third_order : line[i].fourth_order;
      const std::size_t stroke_class = class_of(ridge.colour, type);
      drawing.classes[stroke_class].in_graph = true;
      if (hidden(line[i]) || hidden(next))
        maker.end();
      else
        maker.add(line[i].point, next.point, stroke_class);
    }
    maker.end();
  }
}

/// Umbilics at which a ridge of the graph ends: filters take the others' ridges away.
std::vector<ridges::Umbilic> joined_umbilics(const ridges::RidgeGraph& graph) {
  std::vector<bool> joined(graph.umbilics.size(), false);
  for (const ridges::Ridge& ridge : graph.ridges)
    for (const ridges::RidgeEnd& end : ridge.ends)
      if (end.kind == ridges::EndKind::umbilic) joined[end.umbilic] = true;
  std::vector<ridges::Umbilic> umbilics;
  for (std::size_t i = 0; i < joined.size(); ++i)
    if (joined[i]) umbilics.push_back(graph.umbilics[i]);
  return umbilics;
}

void add_dots(const Sight& sight, const std::vector<ridges::Umbilic>& umbilics, Drawing& drawing) {
  for (const ridges::Umbilic& umbilic : umbilics) {
    const Vec3 pixel = sight.camera().project(umbilic.point);
    if (sight.faces_eye(umbilic) && sight.free(pixel))
      drawing.dots.push_back({pixel, dot_colour(umbilic.kind)});
  }
}

void add_legend(const std::vector<ridges::Umbilic>& umbilics, Drawing& drawing) {
  add_class_legend(drawing);
  const std::pair<UmbilicKind, const char*> kinds[] = {
      {UmbilicKind::one_ridge, "umbilic, 1-ridge"},
      {UmbilicKind::three_ridge, "umbilic, 3-ridge"},
      {UmbilicKind::degenerate, "umbilic, degenerate"}};
  for (const auto& [kind, label] : kinds) {
    const bool present = std::any_of(umbilics.begin(), umbilics.end(),
                                     [&](const auto& umbilic) { return umbilic.kind == kind; });
    if (present) drawing.legend.push_back({label, dot_colour(kind), true});
  }
}

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

Colour casing(Colour colour) {
  const auto darker = [](std::uint8_t c) { return static_cast<std::uint8_t>(c * 2 / 5); };
  return {darker(colour.red), darker(colour.green), darker(colour.blue)};
}

std::vector<StrokeClass> ridge_classes() {
  return {
      {"red, flat", kGrey, {}},
      {"red hyperbolic", {250, 208, 20}, {}},
      {"red turning", {240, 128, 24}, {}},
      {"red elliptic", {218, 26, 32}, {}},
      {"blue, flat", kGrey, {}},
      {"blue hyperbolic", {22, 158, 60}, {}},
      {"blue turning", {24, 140, 160}, {}},
      {"blue elliptic", {28, 70, 222}, {}},
  };
}

std::size_t ridge_class(std::size_t colour, std::size_t type) {
  constexpr std::array<std::size_t, 4> place = {0, 3, 1, 2};  // flat, elliptic, hyperbolic, turning
  return place[type] + (colour == 0 ? 4 : 0);
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

Drawing make_drawing(const Camera& camera, const Canvas& surface, const kernel::TriangleMesh& mesh,
                     const std::vector<Vec3>& normals, const ridges::RidgeGraph& graph, int order) {
  Drawing drawing{};
  drawing.classes = ridge_classes();
  const Sight sight(camera, surface, mesh, normals);
  add_strokes(sight, surface, graph, order, drawing);
  const std::vector<ridges::Umbilic> umbilics = joined_umbilics(graph);
  add_dots(sight, umbilics, drawing);
  set_sizes(camera, drawing);
  add_legend(umbilics, drawing);
  return drawing;
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
