// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/reeb/reeb_picture.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>

#include "io/page/scene.hpp"
#include "io/picture/picture_file.hpp"
#include "io/reeb/graph_layout.hpp"

namespace crest::io {
namespace {

using kernel::Index;
using kernel::kNone;
using kernel::Triangle;
using kernel::Vec3;
using reeb::NodeKind;

constexpr int kSurfaceWidth = 800, kGraphWidth = 400, kGraphMargin = 40;
constexpr std::array<Rgb, 8> kArcColours = {{{66, 118, 196},
                                             {228, 128, 46},
                                             {74, 160, 86},
                                             {196, 78, 96},
                                             {132, 106, 190},
                                             {60, 168, 176},
                                             {206, 170, 40},
                                             {150, 104, 78}}};
constexpr Rgb kContour = {70, 74, 84};

Rgb arc_colour(Index arc) {
  return kArcColours[arc % kArcColours.size()];
}

Rgb node_colour(NodeKind kind) {
  constexpr std::array<Rgb, 3> colours = {{{40, 84, 232}, {250, 214, 40}, {222, 34, 40}}};
  return colours[static_cast<std::size_t>(kind)];
}

/// Faces turned to agree with their neighbours where the surface allows it.
std::vector<Triangle> turned_faces(const kernel::QuadraticMesh& mesh) {
  std::vector<Triangle> faces = mesh.faces();
  std::vector<bool> seen(faces.size(), false);
  std::vector<Index> stack;
  const auto runs_up = [&](Index f, const kernel::Edge& e) {
    const Triangle& t = faces[f];
    for (std::size_t k = 0; k < 3; ++k)
      if (t[k] == e.v0 && t[(k + 1) % 3] == e.v1) return true;
    return false;
  };
  for (Index first = 0; first < faces.size(); ++first) {
    if (!seen[first]) stack.push_back(first);
    seen[first] = true;
    while (!stack.empty()) {
      const Index f = stack.back();
      stack.pop_back();
      for (const Index edge : mesh.face_edges()[f]) {
        const kernel::Edge& e = mesh.edges()[edge];
        const Index g = e.f0 == f ? e.f1 : e.f0;
        if (g == kNone || seen[g]) continue;
        seen[g] = true;
        if (runs_up(f, e) == runs_up(g, e)) std::swap(faces[g][1], faces[g][2]);
        stack.push_back(g);
      }
    }
  }
  return faces;
}

/// The direction in which the values grow, if they are nearly a linear function of the place.
std::optional<Vec3> height_direction(const kernel::QuadraticMesh& mesh) {
  const Index n = mesh.vertex_count();
  Eigen::MatrixXd places(n, 3);
  Eigen::VectorXd values(n);
  for (Index v = 0; v < n; ++v) {
    for (Eigen::Index k = 0; k < 3; ++k)
      places(v, k) = mesh.points()[v][static_cast<std::size_t>(k)];
    values(v) = mesh.values()[v];
  }
  places.rowwise() -= places.colwise().mean().eval();
  values.array() -= values.mean();
  const Eigen::Matrix3d covariance = places.transpose() * places;
  const Eigen::Vector3d joint = places.transpose() * values;
  const Eigen::Vector3d slope = covariance.completeOrthogonalDecomposition().solve(joint);
  const double explained = slope.dot(joint), all = values.squaredNorm();
  if (!(explained > 0.98 * all) || !(slope.norm() > 0) || !std::isfinite(slope.norm())) return {};
  const Eigen::Vector3d unit = slope.normalized();
  return Vec3{unit[0], unit[1], unit[2]};
}

/// What the caller leaves open: sees the surface from the side if the values are a height.
Camera camera_for(const SurfaceView& surface, Viewpoint wanted, const std::optional<Vec3>& height) {
  const Camera chosen = make_camera(surface, wanted, kSurfaceWidth, {}, false);
  if (wanted.view || wanted.up || !height) return chosen;
  const Vec3& view = chosen.forward;
  const Vec3 level = combine(1, view, -dot(view, *height), *height);
  if (dot(level, level) < 0.1) return chosen;
  return make_camera(surface, {level, height}, kSurfaceWidth);
}

/// Factors that turn the surface's grey into a pale tone of the arcs' colours.
std::vector<Vec3> tints(const ReebScene& scene) {
  std::vector<Vec3> result(scene.mesh.vertex_count(), Vec3{1, 1, 1});
  for (Index v = 0; v < result.size(); ++v) {
    if (scene.arc_of_node[v] == kNone) continue;
    const Rgb c = arc_colour(scene.arc_of_node[v]);
    const auto pale = [](std::uint8_t x) { return 0.58 + 0.42 * x / 255.0; };
    result[v] = {pale(c.red), pale(c.green), pale(c.blue)};
  }
  return result;
}

class Painter {
 public:
  Painter(const ReebScene& scene, const Camera& camera, const Canvas& canvas, Drawing& drawing)
      : scene_(scene), camera_(camera), canvas_(canvas), drawing_(drawing) {
    drawing.classes.push_back({"contour", kContour, {}});
    for (const Rgb c : kArcColours) drawing.classes.push_back({"arc", c, {}});
    drawing.classes[0].width = 0.5;
  }

  void draw_levels() {
    for (const LevelLines& lines : scene_.levels) {
      for (const reeb::Contour& contour : lines.contours) {
        const std::size_t n = contour.points.size();
        for (std::size_t i = 0; i + 1 < n + (contour.closed ? 1 : 0); ++i)
          draw_visible(contour.points[i], contour.points[(i + 1) % n]);
        end_stroke();
        drawing_.classes[0].in_graph = true;
      }
    }
  }

  void draw_critical_points() {
    for (const reeb::ReebNode& node : scene_.graph.nodes) {
      const Vec3 pixel = camera_.project(scene_.places[node.vertex].point);
      if (visible(pixel)) drawing_.dots.push_back({pixel, node_colour(node.kind)});
    }
  }

  /// In the panel to the right of the surface.
  void draw_graph() {
    const auto& nodes = scene_.graph.nodes;
    if (nodes.empty()) return;
    std::vector<double> heights;
    for (const reeb::ReebNode& node : nodes) heights.push_back(scene_.places[node.vertex].value);
    const double low = heights.front(), high = heights.back();
    for (std::size_t i = 0; i < heights.size(); ++i) {
      // A constant function: by position.
      heights[i] = high > low
                       ? (heights[i] - low) / (high - low)
                       : (static_cast<double>(i) + 0.5) / static_cast<double>(heights.size());
    }
    const GraphLayout layout = lay_out(scene_.graph, heights);
    const double inner = kGraphWidth - 2 * kGraphMargin;
    const double pitch = std::min(inner / std::max(layout.columns - 1, 1), 60.0);
    const double left = kSurfaceWidth + 0.5 * (kGraphWidth - pitch * (layout.columns - 1));
    const double bottom = camera_.height - kGraphMargin, tall = camera_.height - 2 * kGraphMargin;
    const auto at = [&](int column, double height) {
      return Vec3{left + pitch * column, bottom - tall * height, 0};
    };
    for (Index a = 0; a < scene_.graph.arcs.size(); ++a) {
      if (layout.arc_column[a] == kNoColumn) continue;
      const reeb::ReebArc& arc = scene_.graph.arcs[a];
      add_arc(a, at(layout.node_column[arc.lower], heights[arc.lower]),
              at(layout.node_column[arc.upper], heights[arc.upper]),
              left + pitch * layout.arc_column[a]);
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (layout.node_column[i] == kNoColumn) continue;
      drawing_.dots.push_back({at(layout.node_column[i], heights[i]), node_colour(nodes[i].kind)});
    }
  }

 private:
  bool visible(const Vec3& pixel) const { return canvas_.visible(pixel, 0.0015 * camera_.width); }

  /// Next to the background the bias does not tell what is behind the outline.
  bool clear(const Vec3& pixel) const {
    return visible(pixel) && !canvas_.visible({pixel[0], pixel[1], 1e30}, 0);
  }

  void draw_visible(const Vec3& from, const Vec3& to) {
    const Vec3 p = camera_.project(from), q = camera_.project(to);
    const double length = std::hypot(q[0] - p[0], q[1] - p[1]);
    const int steps = static_cast<int>(std::clamp(std::ceil(length), 1.0, 1e4));
    bool on = !stroke_.empty();  // the piece before was visible at its end
    Vec3 last = p;
    for (int i = 0; i <= steps; ++i) {
      const double t = static_cast<double>(i) / steps;
      const Vec3 at = combine(1 - t, p, t, q);
      const bool now = clear(at);
      if (now && !on) stroke_.push_back(at);
      if (!now && on) {
        stroke_.push_back(last);
        end_stroke();
      }
      on = now;
      last = at;
    }
    if (on) stroke_.push_back(q);
  }

  void end_stroke() {
    if (stroke_.size() > 1) drawing_.classes[0].strokes.push_back(stroke_);
    stroke_.clear();
  }

  /// From its lower node over into its column and back to its upper node.
  void add_arc(Index a, const Vec3& low, const Vec3& high, double column) {
    const double rise = low[1] - high[1], bend = std::min(0.45 * rise, 36.0);
    std::vector<Vec3> stroke;
    constexpr int steps = 10;
    const auto curve = [&](const Vec3& from, const Vec3& to) {
      const bool straight = from[0] == to[0];
      for (int i = 0; i <= steps; i += straight ? steps : 1) {
        const double t = static_cast<double>(i) / steps, s = t * t * (3 - 2 * t);
        stroke.push_back({from[0] + s * (to[0] - from[0]), from[1] + t * (to[1] - from[1]), 0});
      }
    };
    curve(low, {column, low[1] - bend, 0});
    curve({column, high[1] + bend, 0}, high);
    StrokeClass& to = drawing_.classes[1 + a % kArcColours.size()];
    to.strokes.push_back(std::move(stroke));
  }

  const ReebScene& scene_;
  const Camera& camera_;
  const Canvas& canvas_;
  Drawing& drawing_;
  std::vector<Vec3> stroke_;
};

void add_legend(const ReebScene& scene, Drawing& drawing) {
  if (drawing.classes[0].in_graph) drawing.legend.push_back({"contour", kContour, false});
  const std::pair<NodeKind, const char*> kinds[] = {
      {NodeKind::minimum, "minimum"}, {NodeKind::saddle, "saddle"}, {NodeKind::maximum, "maximum"}};
  for (const auto& [kind, label] : kinds) {
    const auto& nodes = scene.graph.nodes;
    if (std::any_of(nodes.begin(), nodes.end(),
                    [&](const reeb::ReebNode& node) { return node.kind == kind; }))
      drawing.legend.push_back({label, node_colour(kind), true});
  }
}

SceneLayer contour_layer(const ReebScene& scene) {
  SceneLayer layer{"Contours", {{"contour", kContour, 0.5}}};
  layer.words = {{"closed", {"no", "yes"}}};
  for (const LevelLines& lines : scene.levels) {
    for (const reeb::Contour& contour : lines.contours) {
      Columns& row = layer.add_item();
      row.add("value", lines.level);
      row.add("closed", contour.closed ? 1 : 0);
      layer.add_line(contour.points, contour.closed, [](std::size_t) { return 0; });
    }
  }
  return layer;
}

SceneLayer arc_layer(const ReebScene& scene) {
  SceneLayer layer{"Arcs of the graph", {{"arc, through the inside", {236, 236, 240}}}};
  layer.kinds[0].shown = false;
  layer.filters = {{"span", "span of values"}};
  const auto polylines = arc_polylines(scene);
  for (std::size_t a = 0; a < polylines.size(); ++a) {
    const reeb::ReebArc& arc = scene.graph.arcs[a];
    Columns& row = layer.add_item();
    row.add("lower node", static_cast<int>(arc.lower));
    row.add("upper node", static_cast<int>(arc.upper));
    row.add("span", polylines[a].back().value - polylines[a].front().value);
    std::vector<Vec3> points;
    for (const reeb::NodePlace& place : polylines[a]) points.push_back(place.point);
    layer.add_line(points, false, [](std::size_t) { return 0; });
  }
  return layer;
}

SceneLayer node_layer(const ReebScene& scene, const std::vector<double>& persistence) {
  SceneLayer layer{"Critical points", {}, {{"persistence", "persistence"}}};
  for (const auto& [kind, label] : {std::pair{NodeKind::minimum, "minimum"},
                                    {NodeKind::saddle, "saddle"},
                                    {NodeKind::maximum, "maximum"}})
    layer.kinds.push_back({label, node_colour(kind)});
  layer.words = {{"on the boundary", {"no", "yes"}}};
  for (std::size_t i = 0; i < scene.graph.nodes.size(); ++i) {
    const reeb::ReebNode& node = scene.graph.nodes[i];
    const reeb::NodePlace& place = scene.places[node.vertex];
    Columns& row = layer.add_item();
    row.add("value", place.value);
    row.add("persistence", persistence[i]);
    row.add("multiplicity", static_cast<int>(node.multiplicity));
    row.add("on the boundary", int{node.on_boundary});
    layer.add_run(static_cast<std::uint32_t>(node.kind), {&place.point, 1});
  }
  return layer;
}

}  // namespace

std::vector<double> picture_levels(const std::vector<reeb::NodePlace>& places) {
  const auto [low, high] = std::minmax_element(
      places.begin(), places.end(),
      [](const reeb::NodePlace& a, const reeb::NodePlace& b) { return a.value < b.value; });
  constexpr int count = 15;
  std::vector<double> levels;
  for (int i = 0; i < count; ++i) {
    const double t = (i + 0.5) / count;
    const double level = (1 - t) * low->value + t * high->value;
    if (std::isfinite(level) && low->value < high->value) levels.push_back(level);
  }
  return levels;
}

void write_reeb_picture(const std::string& path, const ReebScene& scene, const Viewpoint& viewpoint,
                        const std::string& note) {
  check_picture_path(path);
  check_viewpoint(viewpoint);
  const std::vector<Triangle> faces = turned_faces(scene.mesh);
  const SurfaceView surface(scene.mesh.points(), faces);
  const Camera camera = camera_for(surface, viewpoint, height_direction(scene.mesh));
  Canvas canvas(kSurfaceWidth + kGraphWidth, camera.height);
  const std::vector<Vec3> colours = tints(scene);
  canvas.draw_surface(camera, surface, vertex_normals(surface), &colours);
  Drawing drawing{};
  Painter painter(scene, camera, canvas, drawing);
  painter.draw_levels();
  painter.draw_critical_points();
  painter.draw_graph();
  drawing.stroke_width = 3;
  drawing.casing_width = 4;
  const auto dots = static_cast<double>(drawing.dots.size() + 1);
  drawing.dot_radius = std::clamp(100 / std::sqrt(dots), 2.0, 7.0);
  add_legend(scene, drawing);
  add_note(note, drawing);
  Camera page = camera;
  page.width = kSurfaceWidth + kGraphWidth;
  write_drawing(path, page, canvas, drawing, true);
}

Scene reeb_page_scene(const ReebScene& scene, const std::vector<double>& persistence,
                      const Viewpoint& viewpoint) {
  Scene page{"Reeb graph"};
  SceneSurface surface{"surface", scene.mesh.points(), turned_faces(scene.mesh)};
  page.camera = camera_for(SurfaceView(surface.points, surface.faces), viewpoint,
                           height_direction(scene.mesh));
  std::vector<double> values, arcs;
  for (Index v = 0; v < surface.points.size(); ++v) {
    values.push_back(scene.places[v].value);
    arcs.push_back(scene.arc_of_node[v] == kNone ? -1.0 : scene.arc_of_node[v]);
  }
  surface.fields = {{"value", values}, {"arc", arcs, false, ColourMap::labels}};
  page.surfaces.push_back(std::move(surface));
  page.layers = {contour_layer(scene), arc_layer(scene), node_layer(scene, persistence)};
  return page;
}

}  // namespace crest::io
