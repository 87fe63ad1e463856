// SPDX-License-Identifier: GPL-3.0-or-later
// Speed of the estimators on 1.5 million triangles, beside one pass over the same arrays (the
// thesis: 2.9 s for 1.5 million triangles on a 3 GHz Pentium 4).
#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstring>

#include "experiments/001-curvature/test_meshes.hpp"
#include "experiments/program.hpp"

namespace crest::experiments {
namespace {

using curvature::Method;

template <class Work>
double best_seconds(int runs, Work&& work) {
  double best = 1e300;
  for (int i = 0; i < runs; ++i) {
    const auto start = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    best = std::min(best, time.count());
  }
  return best;
}

/// Reads what ne must read at least (points, faces' corners twice as rings: the mesh's ring lists)
/// and writes as many bytes as its results have, in order.
double memory_pass(const kernel::TriangleMesh& mesh, std::vector<PointCurvature>& results,
                   std::vector<Vec3>& normals, int runs) {
  std::atomic<std::uint64_t> sink{0};
  return best_seconds(runs, [&] {
    tbb::parallel_for(tbb::blocked_range<Index>(0, mesh.vertex_count(), 4096), [&](const auto& r) {
      std::uint64_t sum = 0;
      for (Index v = r.begin(); v != r.end(); ++v) {
        for (const Index w : mesh.ring(v)) sum += w;
        const Vec3& p = mesh.points()[v];
        normals[v] = p;
        PointCurvature& c = results[v];
        c.k1 = c.k2 = c.K = c.H = c.asymmetry = p[0];
        c.d1 = c.d2 = p;
      }
      sink += sum;
    });
  });
}

void run(int columns, int runs, bool all) {
  const TestMesh test = random_diagonals(torus(), columns, columns, 1);
  const kernel::TriangleMesh mesh(test.points, test.faces);
  const double faces = mesh.face_count();
  fmt::print("Torus 1, {} triangles, {} vertices; best of {} runs; connectivity given\n\n",
             mesh.face_count(), mesh.vertex_count(), runs);
  fmt::print(
      "| what | threads | seconds | microseconds a triangle | microseconds a vertex | times "
      "the memory pass |\n|---|---|---|---|---|---|\n");
  for (const std::size_t threads : {1, 2}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    std::vector<PointCurvature> results(mesh.vertex_count());
    std::vector<Vec3> normals(mesh.vertex_count());
    const double pass = memory_pass(mesh, results, normals, runs);
    const auto print = [&](const std::string& name, double seconds) {
      fmt::print("| {} | {} | {:.4f} | {:.4f} | {:.4f} | {:.2f} |\n", name, threads, seconds,
                 1e6 * seconds / faces, 1e6 * seconds / mesh.vertex_count(), seconds / pass);
    };
    print("memory pass", pass);
    print("normals", best_seconds(runs, [&] { curvature::area_weighted_normals(mesh); }));
    for (const Method method : curvature::kMethods) {
      if (!all && method != Method::ne && method != Method::np) continue;
      curvature::Options o;
      o.method = method;
      if (method == Method::np) o.normals = test.normals;
      const bool cheap = method == Method::ne || method == Method::np;
      print(curvature::name_of(method),
            best_seconds(cheap ? runs : 1, [&] { curvature::estimate(mesh, o); }));
      if (!cheap) continue;
      curvature::Result again;
      print(fmt::format("{}, storage used again", curvature::name_of(method)),
            best_seconds(runs, [&] { curvature::estimate(mesh, o, again); }));
    }
  }
}

}  // namespace
}  // namespace crest::experiments

int main(int argc, char** argv) {
  int columns = 866, runs = 7;
  bool all = false;
  crest::experiments::Program program("Speed of curvature estimates");
  program.option("--columns", columns, "of the square grid (default 866: 1.5 million triangles)");
  program.option("--runs", runs, "the best counts (default 7)");
  program.flag("--all", all, "the fits and normal-cycle too");
  return program.run(argc, argv, [&] {
    crest::experiments::run(columns, runs, all);
    return 0;
  });
}
