// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/ridges/smooth_ridge_picture.hpp"

#include <algorithm>

#include "io/page/scene.hpp"
#include "io/picture/picture_file.hpp"
#include "io/ridges/ridge_drawing.hpp"
#include "io/ridges/smooth_ridge_lines.hpp"

namespace crest::io {
namespace {

using kernel::Colour;
using kernel::RidgeType;
using kernel::Vec3;
using smooth_ridges::SmoothRidge;
using smooth_ridges::SmoothRidges;
using smooth_ridges::UmbilicPoint;

constexpr Rgb kPurple = {170, 60, 220};
constexpr Rgb kNotCertified = {230, 90, 90};
constexpr double kDiamond = 1.1;  // turning and purple points, in dot radii

/// A kind of umbilic: index and branches decide the mark.
struct UmbilicMark {
  const char* label;
  int twice_index, branches;
};
constexpr UmbilicMark kUmbilicMarks[] = {{"umbilic +1/2, 1-ridge", 1, 1},
                                         {"umbilic +1/2, 3-ridge", 1, 3},
                                         {"umbilic -1/2, 1-ridge", -1, 1},
                                         {"umbilic -1/2, 3-ridge", -1, 3}};

Dot umbilic_dot(const Vec3& pixel, int twice_index, int branches) {
  const Rgb colour = branches == 1 ? Rgb{255, 255, 255} : Rgb{0, 0, 0};
  if (twice_index > 0) return {pixel, colour};
  return {pixel, colour, Mark::triangle, 1.45};
}

Dot turning_dot(const Vec3& pixel, Colour colour) {
  const Rgb c = ridge_classes()[ridge_class(colour, RidgeType::turning)].colour;
  return {pixel, c, Mark::diamond, kDiamond};
}

Dot purple_dot(const Vec3& pixel) {
  return {pixel, kPurple, Mark::diamond, kDiamond};
}

std::vector<StrokeClass> smooth_classes() {
  std::vector<StrokeClass> classes = ridge_classes();
  classes[ridge_class(Colour::blue, RidgeType::none)].label = "blue, untyped";
  classes[ridge_class(Colour::red, RidgeType::none)].label = "red, untyped";
  return classes;
}

void add_lines(const SmoothRidges& result, StrokeMaker& maker, Drawing& drawing) {
  for (const SmoothRidge& ridge : result.ridges) {
    for (const RidgeRun& run : runs_of(ridge)) {
      const std::size_t to = ridge_class(ridge.colour, run.type);
      drawing.classes[to].in_graph = true;
      for (std::size_t i = 0; i + 1 < run.points.size(); ++i)
        maker.add(ridge.points[run.points[i]], ridge.points[run.points[i + 1]], to);
    }
    maker.end();
  }
}

/// Umbilics last: they cover the others.
void add_dots(const SmoothRidges& result, const Camera& camera, const Canvas& canvas,
              Drawing& drawing) {
  const auto add = [&](const Vec3& point, auto&& make) {
    const Vec3 pixel = camera.project(point);
    if (in_sight(camera, canvas, pixel)) drawing.dots.push_back(make(pixel));
  };
  for (const auto& p : result.turning_points)
    add(p.point, [&](const Vec3& pixel) { return turning_dot(pixel, p.colour); });
  for (const auto& p : result.purple_points) add(p.point, purple_dot);
  for (const UmbilicPoint& u : result.umbilics) {
    add(u.point,
        [&](const Vec3& pixel) { return umbilic_dot(pixel, u.twice_index, u.branches[0]); });
  }
}

void add_legend(const SmoothRidges& result, Drawing& drawing) {
  add_class_legend(drawing);
  const auto add = [&](const char* label, const Dot& dot) {
    drawing.legend.push_back({label, dot.colour, true, dot.mark, dot.size});
  };
  for (const UmbilicMark& m : kUmbilicMarks) {
    const bool present =
        std::any_of(result.umbilics.begin(), result.umbilics.end(), [&](const UmbilicPoint& u) {
          return u.twice_index == m.twice_index && u.branches[0] == m.branches;
        });
    if (present) add(m.label, umbilic_dot({}, m.twice_index, m.branches));
  }
  for (const Colour colour : {Colour::blue, Colour::red}) {
    const bool present = std::any_of(result.turning_points.begin(), result.turning_points.end(),
                                     [&](const auto& p) { return p.colour == colour; });
    if (present)
      add(colour == Colour::blue ? "blue turning point" : "red turning point",
          turning_dot({}, colour));
  }
  if (!result.purple_points.empty()) add("purple point", purple_dot({}));
  if (!result.undecided.empty()) add("face not certified", Dot{{}, kNotCertified});
  if (!result.certified) add("result not certified", Dot{{}, {218, 26, 32}});
}

/// White, red at the corners of faces that are not certified.
std::vector<Vec3> tints(const SmoothRidges& result) {
  std::vector<Vec3> tints(result.points.size(), Vec3{1, 1, 1});
  const std::vector<bool> undecided = undecided_faces(result);
  for (std::size_t f = 0; f < undecided.size(); ++f) {
    if (!undecided[f]) continue;
    for (const kernel::Index v : result.faces[f]) tints[v] = {1, 0.45, 0.45};
  }
  return tints;
}

SceneLayer ridge_layer(const SmoothRidges& result) {
  SceneLayer layer{"Ridges", {}, {{"length", "length"}}};
  for (const StrokeClass& c : smooth_classes()) layer.kinds.push_back({c.label, c.colour});
  layer.words = {{"closed", {"no", "yes"}},
                 {"from", {"nothing", "an umbilic", "the boundary"}},
                 {"to", {"nothing", "an umbilic", "the boundary"}}};
  for (const SmoothRidge& ridge : result.ridges) {
    Columns& row = layer.add_item();
    double length = 0;
    for (std::size_t i = 0; i < ridge.types.size(); ++i)
      length += length_of(ridge, i, (i + 1) % ridge.points.size());
    row.add("length", length);
    row.add("closed", ridge.loop ? 1 : 0);
    row.add("from", end_kind(result, ridge, 0));
    row.add("to", end_kind(result, ridge, 1));
    for (const RidgeRun& run : runs_of(ridge)) {
      std::vector<Vec3> points;
      for (const std::size_t i : run.points) points.push_back(ridge.points[i]);
      layer.add_run(static_cast<std::uint32_t>(ridge_class(ridge.colour, run.type)), points);
    }
  }
  return layer;
}

SceneLayer point_layer(const SmoothRidges& result) {
  SceneLayer layer{"Points", {}};
  const auto add = [&](std::size_t kind, const Vec3& point) -> Columns& {
    Columns& row = layer.add_item();
    layer.add_run(static_cast<std::uint32_t>(kind), {&point, 1});
    return row;
  };
  layer.kinds = {{"blue turning point", turning_dot({}, Colour::blue).colour, 0.8},
                 {"red turning point", turning_dot({}, Colour::red).colour, 0.8},
                 {"purple point", kPurple, 0.8}};
  for (const UmbilicMark& m : kUmbilicMarks)
    layer.kinds.push_back({m.label, umbilic_dot({}, m.twice_index, m.branches).colour,
                           m.twice_index > 0 ? 1.0 : 1.25});
  for (const auto& p : result.turning_points)
    add(p.colour == Colour::blue ? 0 : 1, p.point).add("index", 0.0);
  for (const auto& p : result.purple_points) add(2, p.point).add("index", 0.0);
  for (const UmbilicPoint& u : result.umbilics) {
    const auto mark =
        std::find_if(std::begin(kUmbilicMarks), std::end(kUmbilicMarks), [&](const UmbilicMark& m) {
          return m.twice_index == u.twice_index && m.branches == u.branches[0];
        });
    if (mark == std::end(kUmbilicMarks)) continue;
    add(3 + static_cast<std::size_t>(mark - std::begin(kUmbilicMarks)), u.point)
        .add("index", 0.5 * u.twice_index);
  }
  return layer;
}

}  // namespace

void write_smooth_picture(const std::string& path, const SmoothRidges& result,
                          const PictureOptions& options) {
  check_picture(path, options);
  const SurfaceView mesh(result.points, result.faces);
  const Camera camera = make_camera(mesh, {options.view, options.up}, options.width, {}, false);
  Canvas canvas(camera.width, camera.height);
  const std::vector<Vec3> tint = tints(result);
  canvas.draw_surface(camera, mesh, vertex_normals(mesh), &tint);
  Drawing drawing{};
  drawing.classes = smooth_classes();
  StrokeMaker maker(camera, canvas, drawing);
  add_lines(result, maker, drawing);
  add_dots(result, camera, canvas, drawing);
  set_sizes(camera, drawing);
  add_legend(result, drawing);
  write_drawing(path, camera, canvas, drawing, options.show_legend);
}

Scene smooth_ridge_scene(const SmoothRidges& result, const PictureOptions& options) {
  Scene scene{"Ridges"};
  scene.camera = make_camera(SurfaceView(result.points, result.faces), {options.view, options.up},
                             options.width, {}, false);
  SceneSurface surface{"triangulation of the proof", result.points, result.faces};
  if (!result.undecided.empty()) {
    SceneField field{"not certified", {}, true};
    for (const bool undecided : undecided_faces(result)) field.values.push_back(undecided ? 1 : 0);
    surface.fields.push_back(std::move(field));
  }
  scene.surfaces.push_back(std::move(surface));
  scene.layers = {ridge_layer(result), point_layer(result)};
  if (!result.certified) scene.note = "the result is not certified";
  return scene;
}

}  // namespace crest::io
