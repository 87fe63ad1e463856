// SPDX-License-Identifier: GPL-3.0-or-later
// Figures 6 and 7: surfaces of points with normals of any sign, on octrees of several depths.
#include <fmt/format.h>

#include <chrono>
#include <filesystem>

#include "algorithms/extremal/extremal.hpp"
#include "algorithms/sampling/phantoms.hpp"
#include "experiments/program.hpp"
#include "io/extremal/extremal_picture.hpp"
#include "io/read/point_reader.hpp"

namespace crest::experiments {
namespace {

struct Row {
  std::string name;
  extremal::OrientedPoints points;
  double radius;
  std::vector<int> depths;
};

extremal::OrientedPoints sampled(const std::string& name, double noise) {
  auto p = sampling::point_phantom(name, 6000, noise, 1);
  return {std::move(p.points), std::move(p.normals)};
}

void add_file(const std::string& folder, const std::string& file, const std::vector<double>& radii,
              std::vector<Row>& rows) {
  const auto path = std::filesystem::path(folder) / file;
  if (!std::filesystem::exists(path)) return;
  const auto points = io::read_points(path.string());
  for (const double radius : radii)
    rows.push_back({file, {points.points, points.normals}, radius, {10}});
}

void run(const Row& row, int depth, const std::string& pictures) {
  const auto start = std::chrono::steady_clock::now();
  const auto r = extremal::extract(row.points, {row.radius, depth, false});
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  std::int64_t euler = 0;
  std::size_t loops = 0, one_sided = 0;
  for (const auto& c : r.components) {
    euler += c.euler_characteristic;
    loops += c.boundary_loops;
    one_sided += c.orientable ? 0 : 1;
  }
  fmt::print("| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {:.2f} |\n",
             row.name, row.points.points.size(), row.radius, depth, r.counts.leaves, r.counts.depth,
             r.polygons(), r.components.size(), one_sided, euler, loops, r.counts.valence[2],
             r.counts.odd_valence_unexplained, r.counts.undecided_edges, time.count());
  std::fflush(stdout);
  if (pictures.empty() || r.polygons() == 0) return;
  const auto name = fmt::format("{}-{}-{}.png", row.name, row.radius, depth);
  io::write_extremal_picture((std::filesystem::path(pictures) / name).string(), r);
}

}  // namespace
}  // namespace crest::experiments

int main(int argc, char** argv) {
  using namespace crest;
  std::string folder = "../shared/data/points", pictures, only;
  experiments::Program program("Surfaces of points with normals of any sign.");
  program.option("--data", folder, "the shared points");
  program.option("--pictures", pictures, "a folder for pictures");
  program.option("--only", only, "one row's name");
  return program.run(argc, argv, [&] {
    std::vector<experiments::Row> rows;
    rows.push_back({"moebius", experiments::sampled("moebius-points", 0), 0.12, {6, 7, 8, 10}});
    rows.push_back(
        {"moebius-noise-0.03", experiments::sampled("moebius-points", 0.03), 0.12, {6, 7, 10}});
    rows.push_back({"hemisphere", experiments::sampled("hemisphere-points", 0), 0.12, {7, 10}});
    experiments::add_file(folder, "sphere_1k.xyz", {0.25}, rows);
    experiments::add_file(folder, "kitten.xyz", {0.02, 0.025, 0.03, 0.04}, rows);
    experiments::add_file(folder, "oni.pwn", {0.03}, rows);
    experiments::add_file(folder, "hippo1.ply", {0.03}, rows);
    fmt::print(
        "| points | count | radius | depth allowed | leaves | depth | polygons | components | "
        "one-sided | chi | loops | "
        "valence 3 | unexplained | undecided edges | seconds "
        "|\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (const auto& row : rows)
      if (only.empty() || row.name == only)
        for (const int depth : row.depths) experiments::run(row, depth, pictures);
    return 0;
  });
}
