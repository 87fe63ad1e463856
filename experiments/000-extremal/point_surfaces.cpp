// SPDX-License-Identifier: GPL-3.0-or-later
// Figures 6 and 7: surfaces of points with normals of any sign, on octrees of several depths.
#include <fmt/format.h>

#include <chrono>
#include <filesystem>

#include "algorithms/extremal/direction.hpp"
#include "algorithms/extremal/extremal.hpp"
#include "algorithms/extremal/octree.hpp"
#include "algorithms/extremal/point_field.hpp"
#include "algorithms/sampling/phantoms.hpp"
#include "experiments/program.hpp"
#include "io/extremal/extremal_picture.hpp"
#include "io/read/mesh_reader.hpp"
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

using kernel::operator+;
using kernel::operator-;
using kernel::operator*;

/// An ear of the Stanford bunny (figure 6): vertices with the mean normals of their triangles.
void add_ear(const std::string& file, std::vector<Row>& rows) {
  if (!std::filesystem::exists(file)) return;
  const auto mesh = io::read_mesh(file).mesh;
  std::vector<kernel::Vec3> normals(mesh.points().size());
  for (const auto& t : mesh.faces()) {
    const auto &a = mesh.points()[t[0]], &b = mesh.points()[t[1]], &c = mesh.points()[t[2]];
    const auto n = kernel::cross(b - a, c - a);
    for (const auto v : t) normals[v] = normals[v] + n;
  }
  extremal::OrientedPoints ear;
  for (std::size_t v = 0; v < normals.size(); ++v) {
    const auto& p = mesh.points()[v];
    if (!(p[0] < -0.05 && p[1] > 0.14)) continue;
    ear.points.push_back(p);
    ear.normals.push_back(normals[v]);
  }
  rows.push_back({"bunny's ear", std::move(ear), 0.0024, {8, 10}});
}

/// Leaves of the octree by the paper's criteria as printed: more than one point, n at two corners
/// more than 10 degrees apart, s_nn of both signs; wherever there is a field.
std::size_t leaves_by_paper(const Row& row, int depth) {
  using extremal::Vec3;
  std::vector<Vec3> normals = row.points.normals;
  for (auto& n : normals) n = (1 / kernel::norm(n)) * n;
  const extremal::PointField field(row.points.points, std::move(normals), row.radius);
  Vec3 low = row.points.points[0], high = low;
  for (const auto& p : row.points.points)
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  const Vec3 size = high - low;
  const double side = std::max({size[0], size[1], size[2]}) + 2.2 * row.radius;
  const double unit = side / (1 << depth);
  const Vec3 origin = 0.5 * (low + high) - 0.5 * side * Vec3{1, 1, 1};
  const auto points_in = [&](const extremal::OctreeLeaf& leaf) {
    std::size_t count = 0;
    for (const auto& p : row.points.points) {
      bool inside = true;
      for (std::size_t k = 0; k < 3; ++k) {
        const double x = (p[k] - origin[k]) / unit - leaf.low[k];
        inside = inside && x >= 0 && x < leaf.size;
      }
      count += inside ? 1 : 0;
      if (count > 1) break;
    }
    return count;
  };
  const auto splits = [&](const extremal::OctreeLeaf& leaf) {
    std::vector<Vec3> n;
    std::size_t positive = 0;
    for (int i = 0; i < 8; ++i) {
      Vec3 x = origin;
      for (std::size_t k = 0; k < 3; ++k) x[k] += unit * (leaf.low[k] + (i >> k & 1) * leaf.size);
      const auto sums = field.at(x);
      if (sums.count == 0) continue;
      n.push_back(extremal::dominant_direction(sums.local.tensor));
      positive +=
          kernel::dot(n.back(), extremal::product(sums.local.hessian, n.back())) > 0 ? 1 : 0;
    }
    if (positive > 0 && positive < n.size()) return true;
    for (std::size_t i = 0; i < n.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        if (std::fabs(kernel::dot(n[i], n[k])) < std::cos(10 * M_PI / 180)) return true;
    return points_in(leaf) > 1;
  };
  const extremal::Octree tree(depth, [&](const std::vector<extremal::OctreeLeaf>& leaves) {
    std::vector<extremal::Content> r;
    for (const auto& leaf : leaves)
      r.push_back(splits(leaf) ? extremal::Content::split : extremal::Content::open);
    return r;
  });
  return tree.leaves().size();
}

void add_file(const std::string& folder, const std::string& file, const std::vector<double>& radii,
              std::vector<Row>& rows) {
  const auto path = std::filesystem::path(folder) / file;
  if (!std::filesystem::exists(path)) return;
  const auto points = io::read_points(path.string());
  for (const double radius : radii)
    rows.push_back({file, {points.points, points.normals}, radius, {10}});
}

void run(const Row& row, int depth, int paper_depth, const std::string& pictures) {
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
  const std::string paper =
      depth <= paper_depth ? fmt::format("{}", leaves_by_paper(row, depth)) : "";
  fmt::print(
      "| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {:.2f} |\n",
      row.name, row.points.points.size(), row.radius, depth, r.counts.leaves, paper, r.counts.depth,
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
  std::string folder = "../shared/data/points", meshes = "../shared/data/meshes", pictures, only;
  int paper_depth = 0;
  experiments::Program program("Surfaces of points with normals of any sign.");
  program.option("--data", folder, "the shared points");
  program.option("--meshes", meshes, "the shared meshes");
  program.option("--pictures", pictures, "a folder for pictures");
  program.option("--paper-depth", paper_depth,
                 "up to this depth also leaves by the paper's criteria: minutes", {0, 10});
  program.option("--only", only, "one row's name");
  return program.run(argc, argv, [&] {
    std::vector<experiments::Row> rows;
    rows.push_back({"moebius", experiments::sampled("moebius-points", 0), 0.12, {6, 7, 8, 10}});
    rows.push_back(
        {"moebius-noise-0.03", experiments::sampled("moebius-points", 0.03), 0.12, {6, 7, 10}});
    rows.push_back({"hemisphere", experiments::sampled("hemisphere-points", 0), 0.12, {7, 10}});
    experiments::add_ear(meshes + "/stanford-bunny.obj", rows);
    experiments::add_file(folder, "sphere_1k.xyz", {0.25}, rows);
    experiments::add_file(folder, "kitten.xyz", {0.02, 0.025, 0.03, 0.04}, rows);
    experiments::add_file(folder, "oni.pwn", {0.03}, rows);
    experiments::add_file(folder, "hippo1.ply", {0.03}, rows);
    fmt::print(
        "| points | count | radius | depth allowed | leaves | by the paper's criteria | depth | "
        "polygons | components | "
        "one-sided | chi | loops | "
        "valence 3 | unexplained | undecided edges | seconds "
        "|\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (const auto& row : rows)
      if (only.empty() || row.name == only)
        for (const int depth : row.depths) experiments::run(row, depth, paper_depth, pictures);
    return 0;
  });
}
