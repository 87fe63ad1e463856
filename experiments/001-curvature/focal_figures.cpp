// SPDX-License-Identifier: GPL-3.0-or-later
// Figures 3.7, 3.8, 3.11, 3.12 (focal surfaces of the second torus and the second waved tube at
// noise 1/2, eight panels each, all in the scale of the exact one) and 3.14 (a scan) of paper 001.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "algorithms/curvature/focal.hpp"
#include "experiments/001-curvature/directions.hpp"
#include "experiments/001-curvature/test_meshes.hpp"
#include "experiments/packed_mesh.hpp"
#include "experiments/program.hpp"
#include "io/curvature/curvature_picture.hpp"

namespace crest::experiments {
namespace {

using curvature::FocalSurface;
using curvature::Method;
using curvature::Quantity;

constexpr double kShare =
    0.03;  // of the diagonal: NE and CF stay near the surface, QF and QT leave it

curvature::Result estimate(const kernel::TriangleMesh& mesh, Method method,
                           const std::vector<Vec3>& exact_normals) {
  curvature::Options o;
  o.method = method;
  if (method == Method::np) o.normals = exact_normals;
  return curvature::estimate(mesh, o);
}

/// `make` draws a focal surface of a share of the diagonal; the share is chosen for this scale.
template <class Make>
FocalSurface in_scale(double scale, Make&& make) {
  const FocalSurface first = make(kShare);
  return first.scale > 0 ? make(kShare * scale / first.scale) : first;
}

/// Panels a) to h) of one figure.
void panels(const std::string& name, const TestMesh& test, const kernel::TriangleMesh& mesh,
            Quantity q, int width, const Vec3& view) {
  io::ColourPicture picture;
  picture.label = q == Quantity::gaussian ? "gaussian curvature" : "mean curvature";
  picture.width = width;
  picture.view = view;
  const auto write = [&](char panel, const FocalSurface& s) {
    io::write_focal_picture(fmt::format("{}-{}.png", name, panel), mesh, s, picture);
  };
  curvature::Result exact;
  exact.vertices = test.exact;
  exact.normals = test.normals;
  const FocalSurface reference = curvature::focal_of_vertices(mesh, exact, q, kShare);
  write('a', reference);
  const auto averaged = [&](char panel, const curvature::Result& result) {
    write(panel, in_scale(reference.scale, [&](double share) {
            return curvature::focal_of_vertices(mesh, result, q, share);
          }));
  };
  const auto independent = [&](char panel, const curvature::Result& result) {
    write(panel, in_scale(reference.scale, [&](double share) {
            return curvature::focal_of_triangles(mesh, result.normals, q, share, 3);
          }));
  };
  averaged('b', estimate(mesh, Method::cf, test.normals));
  averaged('c', estimate(mesh, Method::qf, test.normals));
  averaged('d', estimate(mesh, Method::qt, test.normals));
  const auto np = estimate(mesh, Method::np, test.normals);
  independent('e', np);
  averaged('f', np);
  const auto ne = estimate(mesh, Method::ne, test.normals);
  independent('g', ne);
  averaged('h', ne);
}

/// The faces within a ball, without those whose vertices would be pinched.
std::optional<kernel::TriangleMesh> part_of(const kernel::TriangleMesh& mesh, const Vec3& centre,
                                            double radius) {
  std::vector<bool> kept(mesh.face_count());
  for (Index f = 0; f < mesh.face_count(); ++f) {
    kept[f] = std::ranges::all_of(mesh.faces()[f], [&](Index v) {
      const Vec3 d = mesh.points()[v] - centre;
      return dot(d, d) <= radius * radius;
    });
  }
  for (bool changed = true; changed;) {
    changed = false;
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      const auto fan = mesh.fan(v);
      int runs = 0;
      for (std::size_t j = 0; j < fan.size(); ++j) {
        const bool before = j > 0 ? kept[fan[j - 1]] : !mesh.on_boundary(v) && kept[fan.back()];
        runs += kept[fan[j]] && !before ? 1 : 0;
      }
      if (runs < 2) continue;
      for (const Index f : fan) kept[f] = false;
      changed = true;
    }
  }
  std::map<Index, Index> number;
  std::vector<Vec3> points;
  std::vector<kernel::Triangle> faces;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    if (!kept[f]) continue;
    kernel::Triangle t = mesh.faces()[f];
    for (Index& v : t) {
      const auto [at, fresh] = number.emplace(v, static_cast<Index>(points.size()));
      if (fresh) points.push_back(mesh.points()[v]);
      v = at->second;
    }
    faces.push_back(t);
  }
  if (faces.empty()) return std::nullopt;
  return kernel::TriangleMesh(std::move(points), std::move(faces));
}

void figure_14(const std::string& folder, const std::string& file, Index centre, int width) {
  if (!std::filesystem::exists(file)) {
    fmt::print("{}: not there, figure 3.14 skipped\n", file);
    return;
  }
  const auto read = read_mesh(file);
  if (!read) {
    fmt::print("{}: packed, and there is no program xz: figure 3.14 skipped\n", file);
    return;
  }
  const kernel::TriangleMesh& mesh = read->mesh;
  const auto result = estimate(mesh, Method::ne, {});
  std::vector<double> values;
  for (const auto& c : result.vertices) values.push_back(c.H);
  io::ColourPicture picture;
  picture.width = width;
  picture.label = "mean curvature";
  io::write_colour_picture(folder + "/figure-3.14-a.png", mesh, values, picture);
  const Vec3 middle = mesh.points().at(centre);
  const double size = bounding_diagonal(mesh.points());
  const auto part = part_of(mesh, middle, 0.06 * size);
  if (!part) throw std::runtime_error("--centre: no face lies near that vertex");
  const auto ne = estimate(*part, Method::ne, {});
  picture.view = Vec3{} - result.normals[centre];
  io::write_focal_picture(folder + "/figure-3.14-b.png", *part,
                          curvature::focal_of_triangles(*part, ne.normals, Quantity::mean, 0.05, 3),
                          picture);
  write_directions(folder + "/figure-3.14-c.svg", mesh, result, middle, 0.02 * size);
}

void run(const std::string& folder, const std::string& scan, Index centre, int width) {
  std::filesystem::create_directories(folder);
  const struct {
    const char *gaussian, *mean;
    TestMesh test;
    Vec3 view;
  } figures[] = {
      {"figure-3.7", "figure-3.8", perturbed_delaunay(torus(), 100, 100, 1), {0.25, 0.55, -0.8}},
      {"figure-3.11",
       "figure-3.12",
       perturbed_delaunay(waved_tube(), 100, 50, 1),
       {-0.4, -0.8, -0.35}}};
  for (const auto& f : figures) {
    const kernel::TriangleMesh mesh(displaced(f.test, 0.5, 1), f.test.faces);
    panels(folder + "/" + f.gaussian, f.test, mesh, Quantity::gaussian, width, f.view);
    panels(folder + "/" + f.mean, f.test, mesh, Quantity::mean, width, f.view);
  }
  figure_14(folder, scan, centre, width);
  fmt::print("Pictures in {}\n", folder);
}

}  // namespace
}  // namespace crest::experiments

int main(int argc, char** argv) {
  std::string folder = "figures-001-curvature", scan = "../shared/data/meshes/igea.ply.xz";
  crest::kernel::Index centre = 31536;
  int width = 480;
  crest::experiments::Program program("Figures 3.7, 3.8, 3.11, 3.12 and 3.14 of paper 001");
  program.option("--pictures", folder, "folder for the pictures (default figures-001-curvature)");
  program.option("--scan", scan, "of figure 3.14 (default ../shared/data/meshes/igea.ply.xz)");
  program.option("--centre", centre,
                 "vertex in the middle of its close-ups (default 31536: the nose)");
  program.option("--width", width, "of a picture, pixels (default 480)", {100, 4000});
  return program.run(argc, argv, [&] {
    crest::experiments::run(folder, scan, centre, width);
    return 0;
  });
}
