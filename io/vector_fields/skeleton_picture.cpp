// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "io/page/scene.hpp"
#include "io/picture/picture_file.hpp"
#include "io/vector_fields/convolution.hpp"
#include "io/vector_fields/skeleton_writer.hpp"

namespace crest::io {
namespace {

using namespace vector_fields;
using kernel::operator+;
using kernel::operator-;
using kernel::operator*;

constexpr int kLongest = 1000, kMargin = 20;  ///< pixels
constexpr Rgb kBlue = {40, 84, 232}, kRed = {222, 34, 40}, kGreen = {30, 160, 60},
              kYellow = {250, 214, 40}, kBlack = {0, 0, 0}, kViolet = {150, 60, 190},
              kGrey = {120, 120, 124};

/// From above, x to the right.
Camera plane_camera(const SkeletonScene& scene, int longest = kLongest) {
  const std::vector<Vec2>& points = scene.field->points;
  PlaneWindow all{points.front(), points.front()};
  for (const Vec2& p : points)
    for (std::size_t k = 0; k < 2; ++k) {
      all.low[k] = std::min(all.low[k], p[k]);
      all.high[k] = std::max(all.high[k], p[k]);
    }
  const auto [low, high] = scene.close_up.value_or(all);
  const double w = high[0] - low[0], h = high[1] - low[1];
  Camera camera;
  camera.right = {1, 0, 0};
  camera.up = {0, 1, 0};
  camera.forward = {0, 0, -1};
  camera.centre = {low[0] + w / 2, low[1] + h / 2, 0};
  camera.scale = longest / std::max(w, h);
  const auto pixels = [&](double length) {
    return static_cast<int>(std::lround(camera.scale * length)) + 2 * kMargin;
  };
  camera.width = std::max(pixels(w), 320);  // the legend's width
  camera.height = pixels(h);
  return camera;
}

/// A part of a picture: how it is seen, and where its upper left corner is.
struct Panel {
  Camera camera;
  int x = 0, y = 0;

  kernel::Vec3 pixel(const Vec2& p) const {
    const kernel::Vec3 q = camera.project({p[0], p[1], 0});
    return {q[0] + x, q[1] + y, q[2]};
  }
  /// The shares of a segment, in pixels, between which it is in the panel.
  std::optional<std::array<double, 2>> visible(const kernel::Vec3& p, const kernel::Vec3& q) const {
    std::array<double, 2> part = {0, 1};
    const double low[2] = {static_cast<double>(x), static_cast<double>(y)};
    const double high[2] = {low[0] + camera.width, low[1] + camera.height};
    for (std::size_t k = 0; k < 2; ++k) {
      const double step = q[k] - p[k];
      double enters = (low[k] - p[k]) / step, leaves = (high[k] - p[k]) / step;
      if (step < 0) std::swap(enters, leaves);
      if (step == 0 ? p[k] < low[k] || p[k] > high[k] : !(enters < 1 && leaves > 0))
        return std::nullopt;
      if (step == 0) continue;
      part = {std::max(part[0], enters), std::min(part[1], leaves)};
    }
    if (!(part[0] < part[1])) return std::nullopt;
    return part;
  }
  bool shows(const kernel::Vec3& p) const {
    return p[0] >= x && p[1] >= y && p[0] <= x + camera.width && p[1] <= y + camera.height;
  }
  /// Adds what the panel shows of a line.
  void add(const std::vector<Vec2>& line, std::vector<std::vector<kernel::Vec3>>& strokes) const {
    std::vector<kernel::Vec3> stroke;
    const auto end = [&] {
      if (stroke.size() > 1) strokes.push_back(stroke);
      stroke.clear();
    };
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const kernel::Vec3 p = pixel(line[i]), q = pixel(line[i + 1]);
      const auto part = visible(p, q);
      if (!part) {
        end();
        continue;
      }
      const auto at = [&](double s) { return s == 1 ? q : p + s * (q - p); };
      if (stroke.empty()) stroke.push_back(at((*part)[0]));
      stroke.push_back(at((*part)[1]));
      if ((*part)[1] < 1) end();
    }
    end();
  }
};

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
void add_lines(const Panel& panel, const Skeleton& s, Drawing& drawing) {
  StrokeClass in{"inflow", kGreen, {}, true, 1.2}, out{"outflow", kRed, {}, true, 1.2},
      none{"no flow across", kGrey, {}, true, 1.2}, lines{"separatrix", kBlack, {}, true, 0.7},
      orbits{"closed orbit", kViolet, {}, true, 1.4};
  for (const BoundaryPiece& p : s.boundary)
    panel.add({p.from, p.to}, (p.flow > 0 ? in : p.flow < 0 ? out : none).strokes);
  for (const Separatrix& l : s.separatrices) panel.add(l.line, lines.strokes);
  for (const ClosedOrbit& o : s.orbits) {
    std::vector<Vec2> around = o.line;
    if (!around.empty()) around.push_back(around.front());
    panel.add(around, orbits.strokes);
  }
  for (StrokeClass* c : {&none, &in, &out, &lines, &orbits})
    if (!c->strokes.empty()) drawing.classes.push_back(std::move(*c));
}

void add_mesh(const Panel& panel, const PlanarField& field, Drawing& drawing) {
  StrokeClass edges{"edge of the mesh", kGrey, {}, true, 0.5};
  std::vector<std::pair<Index, Index>> ends;
  for (const auto& t : field.triangles)
    for (std::size_t k = 0; k < 3; ++k) ends.push_back(std::minmax(t[k], t[(k + 1) % 3]));
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  for (const auto& [a, b] : ends) panel.add({field.points[a], field.points[b]}, edges.strokes);
  drawing.classes.push_back(std::move(edges));
}

void add_flow(const Panel& panel, const PlanarField& field, Canvas& canvas) {
  const int width = panel.camera.width * kSamples, height = panel.camera.height * kSamples;
  const auto pixels = convolve(field, panel.camera);
  std::vector<std::uint8_t> dark;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      dark.push_back(
          pixels[static_cast<std::size_t>(y / kSamples * panel.camera.width + x / kSamples)]);
  canvas.stamp(panel.x * kSamples, panel.y * kSamples, {dark.data(), width, height, width},
               {40, 44, 54});
}

/// The legend names each class and mark once.
void join_classes(Drawing& drawing) {
  std::vector<StrokeClass> joined;
  for (StrokeClass& c : drawing.classes) {
    const auto same = std::find_if(joined.begin(), joined.end(), [&](const StrokeClass& other) {
      return std::string_view(other.label) == c.label;
    });
    if (same == joined.end())
      joined.push_back(std::move(c));
    else
      std::move(c.strokes.begin(), c.strokes.end(), std::back_inserter(same->strokes));
  }
  drawing.classes = std::move(joined);
  std::vector<LegendEntry> legend;
  for (LegendEntry& e : drawing.legend)
    if (std::none_of(legend.begin(), legend.end(),
                     [&](const LegendEntry& other) { return other.label == e.label; }))
      legend.push_back(std::move(e));
  drawing.legend = std::move(legend);
}

void add_dots(const Panel& panel, const Skeleton& s, Drawing& drawing) {
  struct Kind {
    const char* label;
    Rgb colour;
    bool seen = false;
  };
  Kind kinds[] = {{"saddle", kBlue}, {"source", kRed}, {"sink", kGreen}, {"other zero", kViolet}};
  for (const CriticalPoint& c : s.critical_points) {
    if (c.where == ZeroPlace::region || c.where == ZeroPlace::line) continue;
    const kernel::Vec3 place = panel.pixel(c.point);
    if (!panel.shows(place)) continue;
    const Rgb colour = colour_of(c);
    drawing.dots.push_back({place, colour});
    for (Kind& k : kinds)
      k.seen = k.seen || (k.colour.red == colour.red && k.colour.blue == colour.blue);
  }
  bool switches = false;
  for (const SwitchPoint& p : s.switch_points) {
    const kernel::Vec3 place = panel.pixel(p.point);
    if (!panel.shows(place)) continue;
    switches = true;
    drawing.dots.push_back({place, kYellow, Mark::diamond, p.inside ? 1.0 : 0.7});
  }
  for (const Kind& k : kinds)
    if (k.seen) drawing.legend.push_back({k.label, k.colour, true});
  if (switches) drawing.legend.push_back({"switch point", kYellow, true, Mark::diamond});
}

kernel::Vec3 at(const Vec2& p) {
  return {p[0], p[1], 0};
}

std::vector<kernel::Vec3> at(const std::vector<Vec2>& line) {
  std::vector<kernel::Vec3> points;
  for (const Vec2& p : line) points.push_back(at(p));
  return points;
}

SceneLayer boundary_layer(const Skeleton& s) {
  SceneLayer layer{
      "Boundary",
      {{"outflow", kRed, 1.2}, {"no flow across", kGrey, 1.2}, {"inflow", kGreen, 1.2}}};
  for (const BoundaryPiece& p : s.boundary) {
    layer.add_item();
    layer.add_run(static_cast<std::uint32_t>(p.flow + 1), std::array{at(p.from), at(p.to)});
  }
  return layer;
}

SceneLayer separatrix_layer(const Skeleton& s) {
  SceneLayer layer{"Separatrices", {{"separatrix", kBlack, 0.7}, {"undecided", kViolet, 0.7}}};
  layer.words = {{"direction", {"backward", "forward"}},
                 {"from", {"a saddle", "a switch point"}},
                 {"ends at",
                  {"a critical point", "the boundary", "a closed orbit", "zero flow",
                   "a switch point", "undecided"}}};
  for (const Separatrix& l : s.separatrices) {
    Columns& row = layer.add_item();
    row.add("direction", l.forward ? 1 : 0);
    row.add("from", l.from_switch_point ? 1 : 0);
    row.add("origin", static_cast<int>(l.origin));
    row.add("ends at", static_cast<int>(l.end));
    row.add("bits", l.bits);
    row.add("crossings", static_cast<int>(l.crossings));
    const int kind = l.end == EndKind::undecided ? 1 : 0;
    layer.add_line(at(l.line), false, [kind](std::size_t) { return kind; });
  }
  return layer;
}

SceneLayer orbit_layer(const Skeleton& s) {
  SceneLayer layer{"Closed orbits", {{"attracting", kViolet, 1.4}, {"repelling", kBlue, 1.4}}};
  for (const ClosedOrbit& o : s.orbits) {
    layer.add_item();
    const int kind = o.attracting ? 0 : 1;
    layer.add_line(at(o.line), true, [kind](std::size_t) { return kind; });
  }
  return layer;
}

SceneLayer zero_layer(const Skeleton& s) {
  SceneLayer layer{
      "Critical points",
      {{"saddle", kBlue}, {"source", kRed}, {"sink", kGreen}, {"other zero", kViolet}}};
  layer.words = {{"focus", {"no", "yes"}}};
  for (const CriticalPoint& c : s.critical_points) {
    if (c.where == ZeroPlace::region || c.where == ZeroPlace::line) continue;
    Columns& row = layer.add_item();
    row.add("index", c.index ? std::to_string(*c.index) : std::string("none, at the boundary"));
    row.add("focus", c.focus ? 1 : 0);
    const kernel::Vec3 place = at(c.point);
    layer.add_run(std::min<std::uint32_t>(static_cast<std::uint32_t>(c.kind), 3), {&place, 1});
  }
  return layer;
}

SceneLayer switch_layer(const Skeleton& s) {
  SceneLayer layer{"Switch points", {{"inside", kYellow}, {"outside", kYellow, 0.7}}};
  for (const SwitchPoint& p : s.switch_points) {
    layer.add_item().add("loop", static_cast<int>(p.loop));
    const kernel::Vec3 place = at(p.point);
    layer.add_run(p.inside ? 0 : 1, {&place, 1});
  }
  return layer;
}

}  // namespace

void write_skeleton_picture(const std::string& path, const SkeletonScene& scene) {
  check_picture_path(path);
  const Panel panel{plane_camera(scene)};
  Canvas canvas(panel.camera.width, panel.camera.height);
  add_flow(panel, *scene.field, canvas);
  Drawing drawing{};
  add_lines(panel, *scene.skeleton, drawing);
  add_dots(panel, *scene.skeleton, drawing);
  set_sizes(panel.camera, drawing);
  add_class_legend(drawing);
  write_drawing(path, panel.camera, canvas, drawing, true);
}

void write_comparison_picture(const std::string& path, const SkeletonScene& before,
                              const SkeletonScene& after) {
  check_picture_path(path);
  const Camera one = plane_camera(before, kLongest * 3 / 4);
  Camera all = one;
  all.width *= 2;
  all.height *= 2;
  Canvas canvas(all.width, all.height);
  Drawing drawing{};
  int x = 0;
  for (const SkeletonScene* scene : {&before, &after}) {
    add_mesh({one, x, 0}, *scene->field, drawing);
    const Panel below{one, x, one.height};
    add_flow(below, *scene->field, canvas);
    add_lines(below, *scene->skeleton, drawing);
    add_dots(below, *scene->skeleton, drawing);
    x += one.width;
  }
  join_classes(drawing);
  set_sizes(one, drawing);
  add_class_legend(drawing);
  write_drawing(path, all, canvas, drawing, true);
}

Scene skeleton_page_scene(const SkeletonScene& scene) {
  const PlanarField& field = *scene.field;
  Scene page{"Skeleton"};
  page.flat = true;
  page.camera = plane_camera({scene.field, nullptr});
  page.data_digest = scene.data_digest;
  SceneSurface surface{"domain", {}, field.triangles};
  for (const Vec2& p : field.points) surface.points.push_back(at(p));
  std::vector<double> speed;
  for (const Vec2& v : field.vectors) speed.push_back(std::hypot(v[0], v[1]));
  surface.fields.push_back({"speed", speed, false, ColourMap::pale});
  page.surfaces.push_back(std::move(surface));
  page.layers = {boundary_layer(*scene.skeleton), separatrix_layer(*scene.skeleton),
                 orbit_layer(*scene.skeleton), zero_layer(*scene.skeleton),
                 switch_layer(*scene.skeleton)};
  return page;
}

}  // namespace crest::io
