// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/ridges/smooth_ridge_picture.hpp"

#include <algorithm>

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
  drawing.classes = ridge_classes();
  drawing.classes[ridge_class(Colour::blue, RidgeType::none)].label = "blue, untyped";
  drawing.classes[ridge_class(Colour::red, RidgeType::none)].label = "red, untyped";
  StrokeMaker maker(camera, canvas, drawing);
  add_lines(result, maker, drawing);
  add_dots(result, camera, canvas, drawing);
  set_sizes(camera, drawing);
  add_legend(result, drawing);
  write_drawing(path, camera, canvas, drawing, options.show_legend);
}

}  // namespace crest::io
