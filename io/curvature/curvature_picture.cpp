// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/curvature/curvature_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/page/scene.hpp"
#include "io/picture/lettering.hpp"
#include "io/picture/picture_file.hpp"

namespace crest::io {
namespace {

using kernel::Vec3;

constexpr Rgb kPositive = {0, 140, 40}, kNegative = {200, 20, 20}, kZero = {128, 128, 128};
constexpr double kQuantile = 0.95;
constexpr int kBarHeight = 12;  // pixels
constexpr double kRoom = 0.8;   // of the picture for the mesh, the rest for what stands off it

double largest_shown(const std::vector<double>& values) {
  std::vector<double> sizes;
  for (const double x : values) sizes.push_back(std::abs(x));
  const auto rank = static_cast<std::ptrdiff_t>(kQuantile * static_cast<double>(sizes.size() - 1));
  std::nth_element(sizes.begin(), sizes.begin() + rank, sizes.end());
  const double largest = sizes[static_cast<std::size_t>(rank)];
  return largest > 0 ? largest : 1;
}

/// t in [-1, 1]: factors on red, green and blue of the surface's own tone.
Vec3 tint(double t) {
  const double s = std::clamp(std::abs(t), 0.0, 1.0);
  const Vec3 end = t < 0 ? Vec3{0.16, 0.34, 0.80} : Vec3{0.84, 0.16, 0.14};
  return {1 + s * (end[0] - 1), 1 + s * (end[1] - 1), 1 + s * (end[2] - 1)};
}

/// Of letters, in pixels.
double letters_of(const Camera& camera) {
  return 10.5 * std::max(1.0, std::round(camera.width / 800.0));
}

/// Below the picture: the bar with its label, or a label alone.
int bar_rows(const Camera& camera) {
  return kBarHeight + 8 + static_cast<int>(1.6 * letters_of(camera));
}
int label_rows(const Camera& camera) {
  return static_cast<int>(1.6 * letters_of(camera));
}

void draw_label(Canvas& canvas, const Camera& camera, double top, const std::string& label) {
  const double letters = letters_of(camera);
  draw_text(canvas, 0.5 * (camera.width - text_width(label, letters)), top + 1.1 * letters, letters,
            label);
}

void draw_bar(Canvas& canvas, const Camera& camera, double largest, const std::string& label) {
  canvas.extend(bar_rows(camera));
  const double y = camera.height + 8, left = 0.3 * camera.width, width = 0.4 * camera.width;
  constexpr int kBoxes = 101;
  for (int i = 0; i < kBoxes; ++i) {
    const Vec3 c = tint(2.0 * i / (kBoxes - 1) - 1);
    const auto channel = [](double x) { return static_cast<std::uint8_t>(235 * x + 0.5); };
    canvas.fill_box(left + width * i / kBoxes, y, left + width * (i + 1) / kBoxes, y + kBarHeight,
                    {channel(c[0]), channel(c[1]), channel(c[2])});
  }
  const double letters = letters_of(camera), base = y + 0.5 * kBarHeight + 0.36 * letters;
  const std::string low = fmt::format("{:.3g}", -largest), high = fmt::format("{:.3g}", largest);
  draw_text(canvas, left - 0.6 * letters - text_width(low, letters), base, letters, low);
  draw_text(canvas, left + width + 0.6 * letters, base, letters, high);
  draw_label(canvas, camera, y + kBarHeight, label);
}

Camera camera_of(const kernel::TriangleMesh& mesh, const ColourPicture& options) {
  check_viewpoint({options.view, options.up});
  return make_camera(mesh, {options.view, options.up}, options.width);
}

SceneLayer focal_layer(const curvature::FocalSurface& focal) {
  const bool gaussian = focal.quantity == curvature::Quantity::gaussian;
  SceneLayer layer{
      gaussian ? "Focal surface of K" : "Focal surface of H",
      {{"positive", kPositive, 0.4}, {"zero", kZero, 0.4}, {"negative", kNegative, 0.4}}};
  for (std::size_t i = 0; i < focal.curves.size(); ++i) {
    const auto& curve = focal.curves[i];
    layer.add_item().add("curve", static_cast<int>(i));
    std::vector<Vec3> points;
    for (const kernel::Index p : curve) points.push_back(focal.points[p]);
    layer.add_line(points, false, [&](std::size_t k) {
      const double value = focal.values[curve[k]];
      return value > 0 ? 0 : value < 0 ? 2 : 1;
    });
  }
  return layer;
}

}  // namespace

void write_colour_picture(const std::string& path, const kernel::TriangleMesh& mesh,
                          const std::vector<double>& values, const ColourPicture& options) {
  check_picture_path(path);
  const std::vector<Vec3> normals = vertex_normals(mesh);
  const Camera camera = camera_of(mesh, options);
  const double largest = largest_shown(values);
  std::vector<Vec3> tints;
  for (const double x : values) tints.push_back(tint(x / largest));
  Canvas canvas(camera.width, camera.height);
  canvas.draw_surface(camera, mesh, normals, &tints);
  draw_bar(canvas, camera, largest, options.label);
  write_canvas(path, canvas, camera.width, camera.height + bar_rows(camera));
}

void write_focal_picture(const std::string& path, const kernel::TriangleMesh& mesh,
                         const curvature::FocalSurface& focal, const ColourPicture& options) {
  check_picture_path(path);
  const std::vector<Vec3> normals = vertex_normals(mesh);
  Camera camera = camera_of(mesh, options);
  camera.scale *= kRoom;
  Canvas canvas(camera.width, camera.height);
  canvas.draw_surface(camera, mesh, normals);
  const double width = options.stroke > 0 ? options.stroke : std::max(0.5, camera.width / 2000.0);
  for (const auto& curve : focal.curves) {
    for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
      const Vec3 a = camera.project(focal.points[curve[i]]);
      const Vec3 b = camera.project(focal.points[curve[i + 1]]);
      if (!canvas.visible(a, 1) || !canvas.visible(b, 1)) continue;
      const double value = focal.values[curve[i]];
      const Rgb colour = value > 0 ? kPositive : value < 0 ? kNegative : kZero;
      canvas.draw_stroke(a, b, width, colour);
    }
  }
  canvas.extend(label_rows(camera));
  draw_label(canvas, camera, camera.height, options.label);
  write_canvas(path, canvas, camera.width, camera.height + label_rows(camera));
}

Scene curvature_scene(const kernel::TriangleMesh& mesh, const curvature::Result& result,
                      const std::string& shown, const std::vector<curvature::FocalSurface>& focal,
                      const ColourPicture& options) {
  using curvature::PointCurvature;
  Scene scene{"Curvature"};
  scene.camera = camera_of(mesh, options);
  SceneSurface surface = scene_surface("surface", mesh);
  for (const auto& [name, member] : {std::pair{"H", &PointCurvature::H},
                                     {"K", &PointCurvature::K},
                                     {"k1", &PointCurvature::k1},
                                     {"k2", &PointCurvature::k2}}) {
    SceneField field{name, {}, false, ColourMap::diverging};
    for (const PointCurvature& c : result.vertices) field.values.push_back(c.*member);
    surface.fields.insert(name == shown ? surface.fields.begin() : surface.fields.end(),
                          std::move(field));
  }
  scene.surfaces.push_back(std::move(surface));
  for (const curvature::FocalSurface& f : focal) scene.layers.push_back(focal_layer(f));
  return scene;
}

}  // namespace crest::io
