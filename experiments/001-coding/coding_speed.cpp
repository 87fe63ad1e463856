// SPDX-License-Identifier: GPL-3.0-or-later
// Processor time a triangle of method valence and of places, one thread, and its growth on tori.
#include <fmt/format.h>

#include <cmath>
#include <ctime>
#include <numbers>

#include "algorithms/coding/coding.hpp"
#include "experiments/001-coding/coding_input.hpp"
#include "experiments/program.hpp"

namespace crest {
namespace {

using coding::Method;
using coding::Places;

double now() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Median of an odd number of runs, in microseconds a triangle.
template <class Work>
double timed(std::size_t faces, int runs, Work&& work) {
  std::vector<double> times;
  for (int i = 0; i < runs; ++i) {
    const double begin = now();
    work();
    times.push_back(1e6 * (now() - begin) / static_cast<double>(faces));
  }
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

experiments::CodingInput torus(kernel::Index n) {
  experiments::CodingInput mesh;
  for (kernel::Index i = 0; i < n; ++i)
    for (kernel::Index j = 0; j < n; ++j) {
      const double a = 2 * std::numbers::pi * i / n, b = 2 * std::numbers::pi * j / n;
      mesh.points.push_back(
          {(2 + std::cos(b)) * std::cos(a), (2 + std::cos(b)) * std::sin(a), std::sin(b)});
      const kernel::Index p = i * n + j, q = (i + 1) % n * n + j, r = (i + 1) % n * n + (j + 1) % n,
                          s = i * n + (j + 1) % n;
      // Diagonals either way, so that the valences are not all six.
      if ((i * 2654435761u ^ j * 40503u) >> 7 & 1u) {
        mesh.faces.push_back({p, q, r});
        mesh.faces.push_back({p, r, s});
      } else {
        mesh.faces.push_back({p, q, s});
        mesh.faces.push_back({q, r, s});
      }
    }
  return mesh;
}

void row(const std::string& name, const experiments::CodingInput& mesh, int runs) {
  const coding::EncodeOptions bare = {.method = Method::valence, .places = Places::none};
  coding::EncodeOptions placed = {
      .method = Method::valence, .places = Places::rounded, .tolerance = 0};
  double size = 0;
  for (const auto& p : mesh.points)
    size = std::max({size, std::fabs(p[0]), std::fabs(p[1]), std::fabs(p[2])});
  placed.tolerance = size / 2047;
  const auto encode = [&](const coding::EncodeOptions& o) {
    return coding::encode(mesh.vertices(), mesh.faces, mesh.points, o);
  };
  const auto stream = encode(bare).stream, placed_stream = encode(placed).stream;
  const std::size_t faces = mesh.faces.size();
  const double e = timed(faces, runs, [&] { encode(bare); }),
               d = timed(faces, runs, [&] { coding::decode(stream); });
  const double ep = timed(faces, runs, [&] { encode(placed); }),
               dp = timed(faces, runs, [&] { coding::decode(placed_stream); });
  fmt::print("| {} | {} | {:.3f} | {:.3f} | {:.3f} | {:.3f} |\n", name, faces, e, d, ep - e,
             dp - d);
  std::fflush(stdout);
}

int run(const std::vector<std::string>& meshes, unsigned most, int runs) {
  fmt::print(
      "| mesh | faces | encode, us a triangle | decode | places within 1/2047 of the size: encode "
      "| decode |\n"
      "|---|---|---|---|---|---|\n");
  for (const std::string& path : meshes)
    if (std::filesystem::exists(path))
      row(std::filesystem::path(path).filename().string(), experiments::read_coding_input(path),
          runs);
  for (const kernel::Index n : {71u, 224u, 707u, 2236u})
    if (2 * n * n <= most) row(fmt::format("torus {} x {}", n, n), torus(n), n > 1000 ? 1 : runs);
  return 0;
}

}  // namespace
}  // namespace crest

int main(int argc, char** argv) {
  const std::string shared = "../shared/data/meshes/";
  std::vector<std::string> meshes = {shared + "fandisk.off", shared + "rocker-arm.obj",
                                     shared + "armadillo.off", shared + "stanford-bunny.obj",
                                     shared + "horse.ply"};
  unsigned most = 10000000;
  int runs = 5;
  crest::experiments::Program program("Times of coding");
  program.option("--meshes", meshes, "files");
  program.option("--most", most, "faces of the largest torus");
  program.option("--runs", runs, "of which the median counts", {1, 99});
  return program.run(argc, argv, [&] { return crest::run(meshes, most, runs); });
}
