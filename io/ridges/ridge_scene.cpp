// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "io/page/scene.hpp"
#include "io/ridges/ridge_drawing.hpp"

namespace crest::io {
namespace {

using kernel::Vec3;
using ridges::UmbilicKind;

std::vector<SceneKind> ridge_kinds(const PictureOptions& options) {
  std::vector<SceneKind> kinds;
  for (const StrokeClass& c : options.by_salience ? classes_by_salience() : ridge_classes()) {
    const char* thin = c.width < 1 ? ", not salient" : "";
    kinds.push_back({c.label + std::string(thin), c.colour, c.width < 1 ? 0.5 : 1});
  }
  return kinds;
}

void add_row(const ridges::Ridge& ridge, bool salience, Columns& row) {
  const auto largest = [&](const auto& of) {
    double most = 0;
    for (const ridges::Crossing& c : ridge.crossings) most = std::max<double>(most, of(c));
    return most;
  };
  row.add("colour", static_cast<int>(ridge.colour));
  row.add("length", ridge.length);
  row.add("strength", ridge.strength);
  row.add("sharpness", ridge.sharpness);
  row.add("closed", ridge.loop ? 1 : 0);
  for (const std::size_t end : {0, 1}) {
    const ridges::RidgeEnd& e = ridge.ends[end];
    row.add(end == 0 ? "from" : "to", ridge.loop ? -1 : static_cast<int>(e.kind));
  }
  row.add("largest |k1|", largest([](const auto& c) { return std::abs(c.k1); }));
  row.add("largest |k2|", largest([](const auto& c) { return std::abs(c.k2); }));
  if (!salience) return;
  row.add("weight", ridge.weight);
  row.add("significance", largest([](const auto& c) { return c.significance; }));
  row.add("level", static_cast<int>(largest([](const auto& c) { return c.level; })));
}

SceneLayer ridge_layer(const kernel::TriangleMesh& mesh, const std::vector<Vec3>& normals,
                       const ridges::RidgeGraph& graph, bool salience,
                       const PictureOptions& options) {
  SceneLayer layer{"Ridges", ridge_kinds(options)};
  layer.filters = {{"strength", "strength"}, {"sharpness", "sharpness"}, {"length", "length"}};
  if (salience) layer.filters.push_back({"significance", "significance (standard errors)"});
  layer.words = {{"colour", {"blue", "red"}},
                 {"closed", {"no", "yes"}},
                 {"from", {"nothing", "an umbilic", "the boundary", "a filter's cut"}},
                 {"to", {"nothing", "an umbilic", "the boundary", "a filter's cut"}},
                 {"level", {"not significant", "significant", "salient"}}};
  const std::vector<std::vector<LinePoint>> lines = shown_lines(mesh, normals, graph, options);
  for (std::size_t r = 0; r < lines.size(); ++r) {
    const ridges::Ridge& ridge = graph.ridges[r];
    const std::vector<LinePoint>& line = lines[r];
    add_row(ridge, salience, layer.add_item());
    std::vector<Vec3> points;
    for (const LinePoint& p : line) points.push_back(p.point);
    layer.add_line(points, ridge.loop, [&](std::size_t i) {
      const LinePoint& next = line[(i + 1) % line.size()];
      if (line[i].spur || next.spur) return -1;
      return static_cast<int>(segment_class(ridge, line[i], next, options));
    });
  }
  return layer;
}

SceneLayer umbilic_layer(const ridges::RidgeGraph& graph, const PictureOptions& options) {
  const auto colour = [](UmbilicKind kind) { return dot_colour(kind); };
  SceneLayer layer{"Umbilics",
                   {{"1-ridge", colour(UmbilicKind::one_ridge)},
                    {"3-ridge", colour(UmbilicKind::three_ridge)},
                    {"degenerate", colour(UmbilicKind::degenerate)},
                    {"region", {150, 150, 160}, 1.2}}};
  layer.words = {{"coherent", {"no", "yes"}}};
  for (const ridges::Umbilic& u : shown_umbilics(graph, options)) {
    Columns& row = layer.add_item();
    row.add("index", 0.5 * u.twice_index);
    row.add("face", static_cast<int>(u.face));
    row.add("coherent", u.coherent ? 1 : 0);
    const std::uint32_t kind = is_region(u)                         ? 3
                               : u.kind == UmbilicKind::one_ridge   ? 0
                               : u.kind == UmbilicKind::three_ridge ? 1
                                                                    : 2;
    layer.add_run(kind, {&u.point, 1});
  }
  return layer;
}

}  // namespace

Scene ridge_scene(const kernel::TriangleMesh& mesh, const ridges::FitResult& fit,
                  const ridges::RidgeGraph& graph, const PictureOptions& options) {
  const std::vector<Vec3> normals = vertex_normals(mesh);
  const bool salience = !fit.errors.empty();
  Scene scene{"Ridges"};
  scene.camera = make_camera(mesh, {options.view, options.up}, options.width,
                             view_score(mesh, normals, graph));
  SceneSurface surface = scene_surface("surface", mesh);
  std::vector<double> k1, k2;
  for (const kernel::MongeForm& form : fit.forms) {
    k1.push_back(form.k1);
    k2.push_back(form.k2);
  }
  surface.fields = {{"k1", k1, false, ColourMap::diverging},
                    {"k2", k2, false, ColourMap::diverging}};
  surface.coloured = false;
  scene.surfaces.push_back(std::move(surface));
  scene.layers = {ridge_layer(mesh, normals, graph, salience, options),
                  umbilic_layer(graph, options)};
  scene.note = options.note;
  return scene;
}

}  // namespace crest::io
