// SPDX-License-Identifier: GPL-3.0-or-later
// Figures 3.2 to 3.4 and 3.13 of paper 001: the normal-based tensor on one and two triangles, the
// test meshes, principal directions of all methods on the second waved tube at noise 1/2.
#include <fmt/format.h>

#include <filesystem>
#include <tuple>

#include "algorithms/curvature/focal.hpp"
#include "experiments/001-curvature/directions.hpp"
#include "experiments/001-curvature/test_meshes.hpp"
#include "experiments/program.hpp"
#include "io/curvature/curvature_picture.hpp"

namespace crest::experiments {
namespace {

using curvature::Method;
using curvature::Quantity;

/// Both focal surfaces of faces with given normals: K, then H, times scale.
void focal_pair(const std::string& name, const kernel::TriangleMesh& mesh,
                const std::vector<Vec3>& normals, double scale, int width) {
  io::ColourPicture picture;
  picture.width = width;
  picture.view = Vec3{-0.3, 0.8, -0.55};
  picture.stroke = 2;
  for (const Quantity q : {Quantity::gaussian, Quantity::mean}) {
    picture.label = q == Quantity::gaussian ? "gaussian curvature" : "mean curvature";
    io::write_focal_picture(fmt::format("{}-{}.png", name, q == Quantity::gaussian ? "K" : "H"),
                            mesh, curvature::focal_of_triangles(mesh, normals, q, scale, 12),
                            picture);
  }
}

/// t1, t2 in the corners and the middles of the sides.
void six_directions(const std::string& path, const kernel::TriangleMesh& mesh,
                    const std::vector<Vec3>& normals) {
  CloseUp view;
  view.centre = {0.5, 0.3, 0};
  view.radius = 0.8;
  const auto& x = mesh.points();
  for (const auto& l : std::vector<std::array<double, 3>>{
           {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5, 0.5, 0}, {0, 0.5, 0.5}, {0.5, 0, 0.5}}) {
    const Vec3 p = l[0] * x[0] + l[1] * x[1] + l[2] * x[2];
    const auto c = curvature::curvature_at(mesh, normals, 0, l);
    const auto add = [&](const Vec3& d, const char* colour) {
      view.lines.push_back({p - 0.1 * d, p + 0.1 * d, {0, 0, 1}, colour, 2});
    };
    add(c.d1, "#c81e1e");
    add(c.d2, "#1e46c8");
  }
  write_close_up(path, mesh, view);
}

/// (a) one triangle, K < 0 < H somewhere; (b) the same with n0 half, one and two times as long.
void figure_2(const std::string& folder, int width) {
  const kernel::TriangleMesh triangle({{0, 0, 0}, {1, 0, 0}, {0.4, 0.9, 0}}, {{0, 1, 2}});
  const std::vector<Vec3> normals = {{0.35, 0.1, 1}, {-0.35, 0.25, 1}, {0.1, 0.4, 1}};
  focal_pair(folder + "/figure-3.2-a", triangle, normals, 0.08, width);
  six_directions(folder + "/figure-3.2-a-directions.svg", triangle, normals);
  for (const double factor : {0.5, 1.0, 2.0}) {
    std::vector<Vec3> scaled = normals;
    scaled[0] = factor * scaled[0];
    const std::string name = fmt::format("{}/figure-3.2-b-{}", folder, factor);
    focal_pair(name, triangle, scaled, 0.08, width);
    six_directions(name + "-directions.svg", triangle, scaled);
  }
}

/// (a) K over two triangles tears at their edge; (b) the corners' directions at a vertex and those
/// of the averaged tensor.
void figure_3(const std::string& folder, int width) {
  const kernel::TriangleMesh pair({{0, 0, 0}, {1, 0, 0.1}, {1, 1, 0}, {0, 1, 0.15}},
                                  {{0, 1, 2}, {0, 2, 3}});
  focal_pair(folder + "/figure-3.3-a", pair,
             {{-0.3, -0.35, 1}, {0.4, -0.2, 1}, {0.25, 0.45, 1}, {-0.5, 0.1, 1}}, 0.09, width);
  const TestMesh test = perturbed_delaunay(torus(), 20, 14, 3);
  const kernel::TriangleMesh mesh(test.points, test.faces);
  curvature::Options options;
  options.method = Method::ne;
  const auto result = curvature::estimate(mesh, options);
  const auto corners = curvature::corner_curvatures(mesh, result.normals);
  const Index v = 5;
  CloseUp each, mean;
  each.centre = mean.centre = mesh.points()[v];
  each.radius = mean.radius = 0.7;
  each.reach = mean.reach = 4;
  const auto strokes = [&](CloseUp& view, const Vec3& p, const curvature::PointCurvature& c) {
    const auto add = [&](const Vec3& d, const char* colour) {
      view.lines.push_back({p - 0.12 * d, p + 0.12 * d, result.normals[v], colour, 2});
    };
    add(c.d1, "#c81e1e");
    add(c.d2, "#1e46c8");
  };
  for (const Index f : mesh.fan(v)) {
    const auto& t = mesh.faces()[f];
    const Vec3 middle = 1.0 / 3 * (mesh.points()[t[0]] + mesh.points()[t[1]] + mesh.points()[t[2]]);
    for (std::size_t k = 0; k < 3; ++k)
      if (t[k] == v) strokes(each, 0.5 * (mesh.points()[v] + middle), corners[f][k]);
  }
  strokes(mean, mesh.points()[v], result.vertices[v]);
  write_close_up(folder + "/figure-3.3-b-left.svg", mesh, each);
  write_close_up(folder + "/figure-3.3-b-right.svg", mesh, mean);
}

/// The four test triangulations (of a tube the half that faces the eye), coarser than those of the
/// tables so that triangles are seen.
void figure_4(const std::string& folder) {
  const TestMesh meshes[] = {
      random_diagonals(torus(), 40, 24, 1), perturbed_delaunay(torus(), 40, 24, 1),
      random_diagonals(waved_tube(), 40, 20, 1), perturbed_delaunay(waved_tube(), 40, 20, 1)};
  char panel = 'a';
  for (const TestMesh& test : meshes) {
    CloseUp view;
    const bool tube = panel > 'b';
    view.centre = tube ? test.points[test.points.size() / 2] : Vec3{};
    view.radius = tube ? 1.6 : 3.1;
    view.reach = 4;
    if (!tube) view.towards = {0.4, -0.6, 0.7};
    write_close_up(fmt::format("{}/figure-3.4-{}.svg", folder, panel++),
                   kernel::TriangleMesh(test.points, test.faces), view);
  }
}

/// Panels a) exact, b) CF, c) QF, d) QT, e) NP, f) NP averaged, g) NE, h) NE averaged; e) and g)
/// show the tensor of the first triangle at a vertex.
void figure_13(const std::string& folder) {
  const TestMesh test = perturbed_delaunay(waved_tube(), 100, 50, 1);
  const kernel::TriangleMesh mesh(displaced(test, 0.5, 1), test.faces);
  const Index centre = mesh.vertex_count() / 2;
  const auto write = [&](char panel, const curvature::Result& result) {
    write_directions(fmt::format("{}/figure-3.13-{}.svg", folder, panel), mesh, result,
                     mesh.points()[centre], 0.35);
  };
  curvature::Result exact;
  exact.vertices = test.exact;
  write('a', exact);
  const auto estimate = [&](Method method) {
    curvature::Options options;
    options.method = method;
    if (method == Method::np) options.normals = test.normals;
    return curvature::estimate(mesh, options);
  };
  write('b', estimate(Method::cf));
  write('c', estimate(Method::qf));
  write('d', estimate(Method::qt));
  for (const auto& [method, single, averaged] :
       {std::tuple{Method::np, 'e', 'f'}, std::tuple{Method::ne, 'g', 'h'}}) {
    curvature::Result result = estimate(method);
    write(averaged, result);
    const auto corners = curvature::corner_curvatures(mesh, result.normals);
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      const Index f = mesh.fan(v).front();
      for (std::size_t k = 0; k < 3; ++k)
        if (mesh.faces()[f][k] == v) result.vertices[v] = corners[f][k];
    }
    write(single, result);
  }
}

void run(const std::string& folder, int width) {
  std::filesystem::create_directories(folder);
  figure_2(folder, width);
  figure_3(folder, width);
  figure_4(folder);
  figure_13(folder);
  fmt::print("Pictures in {}\n", folder);
}

}  // namespace
}  // namespace crest::experiments

int main(int argc, char** argv) {
  std::string folder = "figures-001-curvature";
  int width = 480;
  crest::experiments::Program program("Figures 3.2 to 3.4 and 3.13 of paper 001");
  program.option("--pictures", folder, "folder for the pictures (default figures-001-curvature)");
  program.option("--width", width, "of a picture, pixels (default 480)", {100, 4000});
  return program.run(argc, argv, [&] {
    crest::experiments::run(folder, width);
    return 0;
  });
}
