// SPDX-License-Identifier: GPL-3.0-or-later
// Thinning a million vertices: seconds of each step, beside one pass over the same arrays.
#include <fmt/format.h>

#include <chrono>
#include <cmath>

#include "algorithms/feature_lines/feature_lines.hpp"
#include "experiments/program.hpp"

namespace crest {
namespace {

namespace fl = feature_lines;

/// A torus of side x side vertices.
kernel::TriangleMesh torus(kernel::Index side) {
  std::vector<kernel::Vec3> points;
  std::vector<kernel::Triangle> faces;
  const double step = 6.283185307179586 / side;
  for (kernel::Index j = 0; j < side; ++j)
    for (kernel::Index i = 0; i < side; ++i) {
      const double r = 3 + std::cos(step * j);
      points.push_back({r * std::cos(step * i), r * std::sin(step * i), std::sin(step * j)});
      const kernel::Index a = i + side * j, b = (i + 1) % side + side * j,
                          c = (i + 1) % side + side * ((j + 1) % side),
                          d = i + side * ((j + 1) % side);
      faces.push_back({a, b, c});
      faces.push_back({a, c, d});
    }
  return kernel::TriangleMesh(std::move(points), std::move(faces));
}

/// Smooth waves of some 60 vertices: wide regions with many holes and pieces.
std::vector<double> waves(kernel::Index side) {
  std::vector<double> field;
  for (kernel::Index j = 0; j < side; ++j)
    for (kernel::Index i = 0; i < side; ++i)
      field.push_back(std::sin(0.1 * i) * std::cos(0.07 * j) +
                      0.5 * std::sin(0.031 * i + 0.053 * j));
  return field;
}

template <class Work>
double seconds(Work&& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void run(kernel::Index side) {
  const auto mesh = torus(side);
  const auto field = waves(side);
  fmt::print(
      "| quantile | marked | on lines | skeletonize s | + pre-prune s | all s | us a vertex | "
      "pass over rings s |\n|---|---|---|---|---|---|---|---|\n");
  for (const double quantile : {0.2, 0.5, 0.8}) {
    const fl::Marks region = fl::threshold_by_value(field, fl::field_quantile(field, quantile));
    fl::Thinner thinner(mesh, region, field);
    const double peel = seconds([&] { thinner.skeletonize(); });
    const double prune = seconds([&] { thinner.pre_prune(); });
    fl::Options options;
    options.quantile = quantile;
    options.prune = 10;
    fl::FeatureLines result;
    const double all = seconds([&] { result = fl::extract_feature_lines(mesh, field, options); });
    kernel::Index sum = 0;
    const double pass = seconds([&] {
      for (kernel::Index v = 0; v < mesh.vertex_count(); ++v)
        sum += fl::marked_neighbours(mesh, region, v);
    });
    fmt::print("| {} | {} | {} | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {:.3f} |\n", quantile,
               result.marked, fl::count(result.marks), peel, peel + prune, all,
               1e6 * all / mesh.vertex_count(), sum > 0 ? pass : 0);
  }
}

}  // namespace
}  // namespace crest

int main(int argc, char** argv) {
  unsigned side = 1000;
  crest::experiments::Program program("Thinning speed");
  program.option("--side", side, "vertices a side of the torus (default 1000)", {3, 10000});
  return program.run(argc, argv, [&] {
    crest::run(side);
    return 0;
  });
}
