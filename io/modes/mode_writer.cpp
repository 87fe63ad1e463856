// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/modes/mode_writer.hpp"

#include <fmt/format.h>
#include <vtkDoubleArray.h>

#include <algorithm>
#include <cmath>

#include "io/formats/files.hpp"
#include "io/page/scene.hpp"
#include "io/picture/picture_file.hpp"
#include "io/write/formats.hpp"
#include "io/write/mesh_writer.hpp"
#include "io/write/poly_data.hpp"
#include "io/write/vtk_pieces.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::io {
namespace {

using kernel::Index;
using kernel::Vec3;
using Matrix = std::array<Vec3, 3>;

double magnitude(const std::array<double, 6>& t) {
  return std::sqrt(t[0] * t[0] + t[1] * t[1] + t[2] * t[2] +
                   2 * (t[3] * t[3] + t[4] * t[4] + t[5] * t[5]));
}

/// Unit eigenvectors by ascending eigenvalue (Jacobi's rotations).
Matrix eigenvectors(const std::array<double, 6>& t) {
  double a[3][3] = {{t[0], t[3], t[5]}, {t[3], t[1], t[4]}, {t[5], t[4], t[2]}};
  double v[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int sweep = 0; sweep < 30; ++sweep)
    for (int p = 0; p < 2; ++p)
      for (int q = p + 1; q < 3; ++q) {
        if (a[p][q] == 0) continue;
        const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
        const double s = (theta < 0 ? -1 : 1) / (std::fabs(theta) + std::hypot(theta, 1));
        const double c = 1 / std::hypot(s, 1), r = s * c;
        for (auto& row : a) {
          const double x = row[p], y = row[q];
          row[p] = c * x - r * y;
          row[q] = r * x + c * y;
        }
        for (int k = 0; k < 3; ++k) {
          const double x = a[p][k], y = a[q][k];
          a[p][k] = c * x - r * y;
          a[q][k] = r * x + c * y;
        }
        for (auto& row : v) {
          const double x = row[p], y = row[q];
          row[p] = c * x - r * y;
          row[q] = r * x + c * y;
        }
      }
  std::array<int, 3> order = {0, 1, 2};
  std::sort(order.begin(), order.end(), [&](int i, int k) { return a[i][i] < a[k][k]; });
  Matrix m;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) m[i][k] = v[k][order[i]];
  return m;
}

/// Points and triangles of all surfaces in one list, small tensors left out.
struct Joined {
  std::vector<Vec3> points;
  std::vector<kernel::Triangle> triangles;
  struct Row {
    const modes::ModeSurface* surface;
    Index triangle;
  };
  std::vector<Row> rows;
  std::vector<const std::array<double, 6>*> tensors;
  std::vector<const modes::PointGeometry*> geometry;  ///< empty: not asked for

  explicit Joined(const ModeScene& scene) {
    for (const modes::ModeSurface& s : scene.surfaces) {
      const auto first = static_cast<Index>(points.size());
      points.insert(points.end(), s.points.begin(), s.points.end());
      for (const auto& t : s.tensors) tensors.push_back(&t);
      for (const auto& g : s.geometry) geometry.push_back(&g);
      for (Index t = 0; t < s.triangles.size(); ++t) {
        const auto& [a, b, c] = s.triangles[t];
        double least = HUGE_VAL;
        // Tensors of surfaces are 3 times the deviator.
        for (const Index v : {a, b, c}) least = std::fmin(least, magnitude(s.tensors[v]));
        if (scene.min_magnitude > 0 && least < 3 * scene.min_magnitude) continue;
        triangles.push_back({first + a, first + b, first + c});
        rows.push_back({&s, t});
      }
    }
  }
};

}  // namespace

vtkSmartPointer<vtkPolyData> mode_poly_data(const ModeScene& scene) {
  const Joined all(scene);
  PolyData data;
  data.add_points(all.points);
  for (std::size_t i = 0; i < all.triangles.size(); ++i) {
    const auto& [a, b, c] = all.triangles[i];
    Columns& row = data.add_triangle(a, b, c);
    row.add("mode", all.rows[i].surface->mode);
    row.add("tet", static_cast<int>(all.rows[i].surface->tets[all.rows[i].triangle]));
    row.add("component", static_cast<int>(all.rows[i].surface->component_of[all.rows[i].triangle]));
  }
  for (std::size_t i = 0; i < scene.curves.size(); ++i) {
    const modes::DegenerateCurve& curve = scene.curves[i];
    std::vector<PolyData::Id> line;
    for (const Vec3& x : curve.polyline) line.push_back(data.add_point(x));
    Columns& row = data.add_line(line);
    row.add("mode", curve.type == modes::DegenerateType::linear ? 1.0 : -1.0);
    row.add("tet", -1);
    row.add("component", static_cast<int>(i));
  }
  const auto column = [&](const char* name, int components) {
    auto a = vtkSmartPointer<vtkDoubleArray>::New();
    a->SetName(name);
    a->SetNumberOfComponents(components);
    a->SetNumberOfTuples(data.point_count());
    a->Fill(0);
    return a;
  };
  const auto normals = column("normal", 3), minor = column("minor", 3),
             medium = column("medium", 3), major = column("major", 3),
             size = column("magnitude", 1);
  const auto n = vertex_normals(SurfaceView(all.points, all.triangles));
  for (std::size_t v = 0; v < all.points.size(); ++v) {
    const auto i = static_cast<vtkIdType>(v);
    const Matrix e = eigenvectors(*all.tensors[v]);
    normals->SetTuple(i, n[v].data());
    minor->SetTuple(i, e[0].data());
    medium->SetTuple(i, e[1].data());
    major->SetTuple(i, e[2].data());
    size->SetValue(i, magnitude(*all.tensors[v]) / 3);
  }
  for (const auto& a : {normals, minor, medium, major, size}) data.add_point_array(a);
  if (!all.geometry.empty()) {
    const auto normal = column("field_normal", 3), d1 = column("direction1", 3),
               d2 = column("direction2", 3), k1 = column("k1", 1), k2 = column("k2", 1);
    for (std::size_t v = 0; v < all.geometry.size(); ++v) {
      const auto i = static_cast<vtkIdType>(v);
      const modes::PointGeometry& g = *all.geometry[v];
      normal->SetTuple(i, g.normal.data());
      d1->SetTuple(i, g.d1.data());
      d2->SetTuple(i, g.d2.data());
      k1->SetValue(i, g.k1);
      k2->SetValue(i, g.k2);
    }
    for (const auto& a : {normal, d1, d2, k1, k2}) data.add_point_array(a);
  }
  if (!scene.data_digest.empty()) data.fields().add("data_digest", scene.data_digest);
  return data.data();
}

namespace {

constexpr Rgb kLinear = {0, 140, 60}, kPlanar = {215, 170, 0};

SceneLayer curve_layer(const ModeScene& scene) {
  SceneLayer layer{
      "Degenerate curves", {{"linear", kLinear}, {"planar", kPlanar}}, {{"length", "length"}}};
  layer.words = {{"closed", {"no", "yes"}}};
  for (const auto& curve : scene.curves) {
    Columns& row = layer.add_item();
    row.add("length", curve.length);
    row.add("closed", curve.closed ? 1 : 0);
    const int kind = curve.type == modes::DegenerateType::linear ? 0 : 1;
    layer.add_line(curve.polyline, false, [kind](std::size_t) { return kind; });
  }
  return layer;
}

SceneLayer outline_layer(const ModeScene& scene) {
  SceneLayer layer{"Domain", {{"sharp edges of its boundary", {150, 150, 158}, 0.5}}};
  for (const auto& segment : scene.outline) {
    layer.add_item();
    layer.add_run(0, segment);
  }
  return layer;
}

/// Without the triangles that `scene` leaves out.
SceneSurface mode_surface(const ModeScene& scene, const modes::ModeSurface& s) {
  const ModeScene alone{{s}, {}, {}, {}, scene.min_magnitude};
  const Joined all(alone);
  SceneSurface surface{"mode " + fmt::format("{:g}", s.mode), all.points, all.triangles};
  surface.colour = s.sign > 0   ? Rgb{72, 184, 184}
                   : s.sign < 0 ? Rgb{240, 200, 66}
                                : Rgb{156, 214, 84};
  SceneField size{"magnitude", {}}, component{"component", {}, true, ColourMap::labels};
  for (const auto* t : all.tensors) size.values.push_back(magnitude(*t) / 3);
  for (const Joined::Row& row : all.rows)
    component.values.push_back(row.surface->component_of[row.triangle]);
  surface.fields = {size, component};
  surface.coloured = false;
  return surface;
}

}  // namespace

void write_modes(const std::string& path, const ModeScene& scene) {
  const std::string extension = lower_extension(path);
  if (extension == ".vtp") return write_vtp(path, *mode_poly_data(scene));
  if (extension == ".pvtp") return write_pvtp(path, *mode_poly_data(scene));
  if (extension != ".ply" && extension != ".obj")
    throw kernel::InputError(path +
                             ": file: has an unknown extension; write .vtp, .pvtp, .ply or .obj");
  const Joined all(scene);
  write_mesh(path, all.points, all.triangles);
}

void write_mode_picture(const std::string& path, const ModeScene& scene,
                        const Viewpoint& viewpoint) {
  check_picture_path(path);
  check_viewpoint(viewpoint);
  const Joined all(scene);
  // The camera fits curves and outline, too.
  std::vector<Vec3> places = all.points;
  for (const auto& curve : scene.curves)
    places.insert(places.end(), curve.polyline.begin(), curve.polyline.end());
  for (const auto& segment : scene.outline)
    places.insert(places.end(), segment.begin(), segment.end());
  const SurfaceView everything(places, all.triangles), view(all.points, all.triangles);
  const Camera camera = make_camera(everything, viewpoint, 1200);
  Canvas canvas(camera.width, camera.height);
  for (const auto& [a, b] : scene.outline)
    canvas.draw_stroke(camera.project(a), camera.project(b), 1.5, {170, 170, 175});
  if (!all.triangles.empty()) {
    std::vector<Vec3> tints(all.points.size(), {1, 1, 1});
    for (std::size_t i = 0; i < all.triangles.size(); ++i) {
      const int sign = all.rows[i].surface->sign;
      const Vec3 tint = sign > 0   ? Vec3{0.2, 0.75, 0.75}
                        : sign < 0 ? Vec3{1, 0.82, 0.2}
                                   : Vec3{0.6, 1, 0.25};
      for (const Index v : {all.triangles[i][0], all.triangles[i][1], all.triangles[i][2]})
        tints[v] = tint;
    }
    canvas.draw_surface(camera, view, vertex_normals(view), &tints);
  }
  // Curves lie inside the surfaces around them: they are drawn in front of everything.
  for (const auto& curve : scene.curves) {
    const Rgb colour = curve.type == modes::DegenerateType::linear ? kLinear : kPlanar;
    for (std::size_t k = 0; k + 1 < curve.polyline.size(); ++k)
      canvas.draw_stroke(camera.project(curve.polyline[k]), camera.project(curve.polyline[k + 1]),
                         2.5, colour);
  }
  write_canvas(path, canvas, camera.width, camera.height);
}

Scene mode_page_scene(const ModeScene& scene, const Viewpoint& viewpoint) {
  Scene page{"Mode surfaces"};
  std::vector<Vec3> places;
  std::vector<kernel::Triangle> faces;
  for (const modes::ModeSurface& s : scene.surfaces) {
    page.surfaces.push_back(mode_surface(scene, s));
    const auto first = static_cast<Index>(places.size());
    const SceneSurface& last = page.surfaces.back();
    places.insert(places.end(), last.points.begin(), last.points.end());
    for (const auto& [a, b, c] : last.faces) faces.push_back({first + a, first + b, first + c});
  }
  page.layers = {outline_layer(scene), curve_layer(scene)};
  for (const SceneLayer& layer : page.layers)
    places.insert(places.end(), layer.places.begin(), layer.places.end());
  if (!places.empty()) page.camera = make_camera(SurfaceView(places, faces), viewpoint, 1200);
  page.data_digest = scene.data_digest;
  return page;
}

}  // namespace crest::io
