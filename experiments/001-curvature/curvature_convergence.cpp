// SPDX-License-Identifier: GPL-3.0-or-later
// Theorem 3.1 (i) as an order: errors of all methods on the test surfaces of section 3.3 without
// noise, at doubling resolutions.
#include <fmt/format.h>

#include "experiments/001-curvature/test_meshes.hpp"
#include "experiments/program.hpp"

namespace crest::experiments {
namespace {

using curvature::Method;

struct Errors {
  double max_K = 0, max_H = 0, rms_K = 0, rms_H = 0;
};

void add(Errors& e, const PointCurvature& a, const PointCurvature& b) {
  e.max_K = std::max(e.max_K, std::abs(a.K - b.K));
  e.max_H = std::max(e.max_H, std::abs(a.H - b.H));
  e.rms_K += (a.K - b.K) * (a.K - b.K);
  e.rms_H += (a.H - b.H) * (a.H - b.H);
}

Errors finished(Errors e, double n) {
  e.rms_K = std::sqrt(e.rms_K / n);
  e.rms_H = std::sqrt(e.rms_H / n);
  return e;
}

/// At the vertices that are not on the boundary.
Errors at_vertices(const kernel::TriangleMesh& mesh, const TestMesh& test, Method method) {
  curvature::Options o;
  o.method = method;
  if (method == Method::np) o.normals = test.normals;
  const auto result = curvature::estimate(mesh, o);
  Errors e;
  int n = 0;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.on_boundary(v)) continue;
    add(e, result.vertices[v], test.exact[v]);
    ++n;
  }
  return finished(e, n);
}

/// np at every corner of every triangle, as the theorem states it.
Errors at_corners(const kernel::TriangleMesh& mesh, const TestMesh& test) {
  const auto corners = curvature::corner_curvatures(mesh, test.normals);
  Errors e;
  for (Index f = 0; f < mesh.face_count(); ++f)
    for (std::size_t k = 0; k < 3; ++k) add(e, corners[f][k], test.exact[mesh.faces()[f][k]]);
  return finished(e, 3.0 * mesh.face_count());
}

void print_series(const std::string& name, const std::vector<int>& sizes,
                  const std::vector<Errors>& errors) {
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const Errors& e = errors[i];
    fmt::print("| {} | {} | {:.3g} | {:.3g} | {:.3g} | {:.3g} |", name, sizes[i], e.max_K, e.rms_K,
               e.max_H, e.rms_H);
    if (i == 0) {
      fmt::print(" | | | |\n");
      continue;
    }
    const Errors& b = errors[i - 1];
    fmt::print(" {:.2f} | {:.2f} | {:.2f} | {:.2f} |\n", std::log2(b.max_K / e.max_K),
               std::log2(b.rms_K / e.rms_K), std::log2(b.max_H / e.max_H),
               std::log2(b.rms_H / e.rms_H));
  }
}

void run(const std::vector<int>& sizes) {
  for (int which = 0; which < 4; ++which) {
    std::vector<TestMesh> tests;
    std::vector<kernel::TriangleMesh> meshes;
    for (const int n : sizes) {
      const TestSurface surface = which < 2 ? torus() : waved_tube();
      const int rows = which < 2 ? n : n / 2;
      tests.push_back(which % 2 == 0 ? random_diagonals(surface, n, rows, 1)
                                     : perturbed_delaunay(surface, n, rows, 1));
      meshes.emplace_back(tests.back().points, tests.back().faces);
    }
    fmt::print("\n### {}\n\n", tests[0].name);
    fmt::print(
        "| method | columns | max K | rms K | max H | rms H | orders: max K | rms K | max H "
        "| rms H |\n|---|---|---|---|---|---|---|---|---|---|\n");
    std::vector<Errors> errors;
    for (std::size_t i = 0; i < sizes.size(); ++i)
      errors.push_back(at_corners(meshes[i], tests[i]));
    print_series("np, corners", sizes, errors);
    for (const Method method : curvature::kMethods) {
      errors.clear();
      for (std::size_t i = 0; i < sizes.size(); ++i)
        errors.push_back(at_vertices(meshes[i], tests[i], method));
      print_series(curvature::name_of(method), sizes, errors);
    }
  }
}

}  // namespace
}  // namespace crest::experiments

int main(int argc, char** argv) {
  std::vector<int> sizes = {32, 64, 128, 256};
  crest::experiments::Program program("Convergence of curvature estimates");
  program.list("--sizes", sizes, "columns of the grids (default 32,64,128,256)");
  return program.run(argc, argv, [&] {
    crest::experiments::run(sizes);
    return 0;
  });
}
