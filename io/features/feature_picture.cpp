// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "io/features/feature_writer.hpp"
#include "io/page/scene.hpp"
#include "io/picture/patches.hpp"
#include "io/picture/picture_file.hpp"

namespace crest::io {
namespace {

using feature_lines::FeatureGraph;
using feature_lines::LineKind;
using kernel::Index;
using kernel::Vec3;

/// In the order of LineKind, then the edges inside nodes.
std::vector<StrokeClass> palette() {
  return {{"arc", {28, 70, 222}, {}},
          {"branch", {218, 26, 32}, {}},
          {"loop", {22, 158, 60}, {}},
          {"lone line", {250, 208, 20}, {}},
          {"node", {30, 30, 30}, {}}};
}

/// Cuts mesh edges where the surface hides them.
class Pen {
 public:
  Pen(const Camera& camera, const Canvas& surface, const kernel::TriangleMesh& mesh)
      : camera_(camera), surface_(surface), mesh_(mesh) {
    for (const Vec3& n : area_vectors(mesh)) front_.push_back(dot(n, camera.forward) < 0);
  }

  bool free(Index v) const { return faces_eye(v) && visible(camera_.project(mesh_.points()[v])); }
  Vec3 pixel(Index v) const { return camera_.project(mesh_.points()[v]); }

  void draw(Index v, Index w, StrokeClass& to) const {
    to.in_graph = true;
    if (!faces_eye(v, w)) return;
    const Vec3 p = pixel(v), q = pixel(w);
    const int steps =
        static_cast<int>(std::clamp(std::ceil(std::hypot(q[0] - p[0], q[1] - p[1])), 1.0, 1e5));
    std::vector<Vec3> stroke;
    for (int i = 0; i <= steps; ++i) {
      const double t = static_cast<double>(i) / steps;
      const Vec3 at = combine(1 - t, p, t, q);
      if (visible(at)) {
        // Two points make a straight stroke.
        if (stroke.size() < 2)
          stroke.push_back(at);
        else
          stroke.back() = at;
      }
      if (!visible(at) || i == steps) {
        if (stroke.size() == 2) to.strokes.push_back(stroke);
        stroke.clear();
      }
    }
  }

 private:
  bool visible(const Vec3& pixel) const { return surface_.visible(pixel, 0.003 * camera_.width); }
  /// Whether a face at v (and w) does: the bias does not tell at the outline of a closed surface.
  bool faces_eye(Index v, Index w = kernel::kNone) const {
    const auto fan = mesh_.fan(v);
    return !mesh_.closed() || std::any_of(fan.begin(), fan.end(), [&](Index f) {
      const kernel::Triangle& t = mesh_.faces()[f];
      return front_[f] && (w == kernel::kNone || std::count(t.begin(), t.end(), w) > 0);
    });
  }
  const Camera& camera_;
  const Canvas& surface_;
  const kernel::TriangleMesh& mesh_;
  std::vector<bool> front_;  ///< F: turned to the eye
};

void draw_graph(const Pen& pen, const FeatureGraph& graph, Drawing& drawing) {
  for (const auto& line : graph.lines) {
    StrokeClass& to = drawing.classes[static_cast<std::size_t>(line.kind)];
    const std::size_t n = line.vertices.size();
    for (std::size_t i = 0; i + (line.kind == LineKind::loop ? 0 : 1) < n; ++i)
      pen.draw(line.vertices[i], line.vertices[(i + 1) % n], to);
  }
  for (const auto& [v, w] : graph.node_edges) pen.draw(v, w, drawing.classes[4]);
  for (const auto& node : graph.nodes) {
    const Index v = node.front();
    if (pen.free(v)) drawing.dots.push_back({pen.pixel(v), drawing.classes[4].colour});
  }
}

std::vector<Vec3> places(const kernel::TriangleMesh& mesh, const std::vector<Index>& vertices) {
  std::vector<Vec3> points;
  for (const Index v : vertices) points.push_back(mesh.points()[v]);
  return points;
}

SceneLayer line_layer(const kernel::TriangleMesh& mesh, const FeatureGraph& graph) {
  SceneLayer layer{"Feature lines", {}, {{"length", "length"}}};
  for (const StrokeClass& c : palette()) layer.kinds.push_back({c.label, c.colour});
  layer.kinds.pop_back();  // nodes are a layer of their own
  for (const char* end : {"from", "to"})
    layer.words.push_back({end, {"open end", "node", "boundary of the mesh"}});
  for (const auto& line : graph.lines) {
    Columns& row = layer.add_item();
    row.add("length", line.length);
    row.add("vertices", static_cast<int>(line.vertices.size()));
    row.add("from", static_cast<int>(line.ends[0]));
    row.add("to", static_cast<int>(line.ends[1]));
    const std::vector<Vec3> points = places(mesh, line.vertices);
    const auto kind = static_cast<int>(line.kind);
    if (points.size() == 1)
      layer.add_run(static_cast<std::uint32_t>(kind), points);
    else
      layer.add_line(points, line.kind == LineKind::loop, [kind](std::size_t) { return kind; });
  }
  return layer;
}

SceneLayer node_layer(const kernel::TriangleMesh& mesh, const FeatureGraph& graph) {
  const StrokeClass node = palette().back();
  SceneLayer layer{"Nodes", {{"node", node.colour, 0.8}, {"edge inside a node", node.colour}}};
  for (const auto& vertices : graph.nodes) {
    Columns& row = layer.add_item();
    row.add("vertex", static_cast<int>(vertices.front()));
    row.add("vertices", static_cast<int>(vertices.size()));
    layer.add_run(0, {&mesh.points()[vertices.front()], 1});
    for (const auto& [v, w] : graph.node_edges)
      if (std::binary_search(vertices.begin(), vertices.end(), v))
        layer.add_run(1, std::array{mesh.points()[v], mesh.points()[w]});
  }
  return layer;
}

}  // namespace

void write_feature_picture(const std::string& path, const kernel::TriangleMesh& mesh,
                           const FeatureGraph& graph, bool patches, const Viewpoint& viewpoint,
                           const std::string& note) {
  check_picture_path(path);
  check_viewpoint(viewpoint);
  const Camera camera = make_camera(mesh, viewpoint, 1200);
  Canvas canvas(camera.width, camera.height);
  if (patches)
    draw_patches(canvas, camera, mesh, graph.face_patch);
  else
    canvas.draw_surface(camera, mesh, vertex_normals(mesh));
  Drawing drawing{};
  drawing.classes = palette();
  draw_graph(Pen(camera, canvas, mesh), graph, drawing);
  drawing.stroke_width = 2.4;
  drawing.casing_width = 3.4;
  drawing.dot_radius = 4;
  for (const StrokeClass& c : drawing.classes)
    if (c.in_graph && &c != &drawing.classes[4])
      drawing.legend.push_back({c.label, c.colour, false});
  if (!graph.nodes.empty())
    drawing.legend.push_back({drawing.classes[4].label, drawing.classes[4].colour, true});
  add_note(note, drawing);
  write_drawing(path, camera, canvas, drawing, true);
}

Scene feature_scene(const kernel::TriangleMesh& mesh, const FeatureGraph& graph,
                    const std::string& field_name, const std::vector<double>& field, bool patches,
                    const Viewpoint& viewpoint) {
  Scene scene{"Feature lines"};
  scene.camera = make_camera(mesh, viewpoint, 1200);
  SceneSurface surface = scene_surface("surface", mesh);
  surface.fields.push_back({field_name, field});
  std::vector<double> patch;
  for (const Index p : graph.face_patch) patch.push_back(p == kernel::kNone ? -1.0 : p);
  surface.fields.insert(patches ? surface.fields.begin() : surface.fields.end(),
                        {"patch", patch, true, ColourMap::labels});
  surface.coloured = patches;
  scene.surfaces.push_back(std::move(surface));
  scene.layers = {line_layer(mesh, graph), node_layer(mesh, graph)};
  return scene;
}

}  // namespace crest::io
