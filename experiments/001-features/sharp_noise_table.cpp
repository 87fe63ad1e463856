// SPDX-License-Identifier: GPL-3.0-or-later
// Sharp edges under noise: angles between single normals (CGAL's and ours, the same set) and
// between normals over rings, against the sharp edges of the mesh without noise.
#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <random>
#include <set>

#include "algorithms/feature_lines/sharp_edges.hpp"
#include "experiments/001-features/feature_field.hpp"
#include "experiments/program.hpp"
#include "io/read/mesh_reader.hpp"

namespace crest {
namespace {

namespace fl = feature_lines;
using kernel::Index;
using EdgeSet = std::set<std::array<Index, 2>>;

EdgeSet sorted(const std::vector<std::array<Index, 2>>& edges) {
  EdgeSet set;
  for (const auto& [a, b] : edges) set.insert({std::min(a, b), std::max(a, b)});
  return set;
}

EdgeSet edges_of(const fl::FeatureGraph& graph) {
  EdgeSet set = sorted(graph.node_edges);
  for (const auto& line : graph.lines) {
    const std::size_t n = line.vertices.size();
    for (std::size_t i = 0; i + (line.kind == fl::LineKind::loop ? 0 : 1) < n; ++i) {
      const Index a = line.vertices[i], b = line.vertices[(i + 1) % n];
      set.insert({std::min(a, b), std::max(a, b)});
    }
  }
  return set;
}

/// Share of `edges` whose ends are both at most one edge from a vertex of `others`, in percent.
double near(const kernel::TriangleMesh& mesh, const EdgeSet& edges, const EdgeSet& others) {
  fl::Marks marks(mesh.vertex_count(), 0);
  for (const auto& [a, b] : others) marks[a] = marks[b] = 1;
  const fl::Marks reach = fl::dilate(mesh, marks, {fl::Neighbourhood::rings, 1});
  const auto hits = std::count_if(edges.begin(), edges.end(),
                                  [&](const auto& e) { return reach[e[0]] && reach[e[1]]; });
  return edges.empty() ? 0 : 100.0 * static_cast<double>(hits) / static_cast<double>(edges.size());
}

kernel::TriangleMesh noisy(const kernel::TriangleMesh& mesh, double share, unsigned seed) {
  double length = 0;
  for (const auto& e : mesh.edges())
    length += kernel::distance(mesh.points()[e.v0], mesh.points()[e.v1]);
  length /= mesh.edge_count();
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal(0, share * length);
  auto points = mesh.points();
  for (auto& p : points)
    for (double& x : p) x += normal(engine);
  return {points, mesh.faces()};
}

int open_ends(const EdgeSet& edges) {
  std::map<Index, int> degree;
  for (const auto& [a, b] : edges) ++degree[a], ++degree[b];
  return static_cast<int>(
      std::count_if(degree.begin(), degree.end(), [](const auto& d) { return d.second == 1; }));
}

void print(const std::string& what, const kernel::TriangleMesh& mesh, const EdgeSet& found,
           const EdgeSet& truth) {
  const double precision = near(mesh, found, truth), recall = near(mesh, truth, found);
  fmt::print("| {} | {} | {:.1f} | {:.1f} | {:.1f} | {} |\n", what, found.size(), precision, recall,
             precision + recall > 0 ? 2 * precision * recall / (precision + recall) : 0,
             open_ends(found));
  std::fflush(stdout);
}

EdgeSet over_rings(const kernel::TriangleMesh& mesh, int degrees, Index rings, Index prune) {
  fl::Options options;
  options.value = degrees;
  options.prune = prune;
  return edges_of(fl::extract_feature_lines(mesh, fl::vertex_angles(mesh, rings), options).graph);
}

int run(const std::string& file, int degrees, const std::vector<double>& levels, unsigned seed,
        Index prune) {
  if (!std::filesystem::exists(file)) {
    fmt::print("{}: not there, skipped\n", file);
    return 0;
  }
  const auto clean = io::read_mesh(file).mesh;
  const EdgeSet truth = sorted(experiments::sharp_edges(clean, degrees));
  const kernel::DecimalAngle angle(std::to_string(degrees));
  const EdgeSet ours = edges_of(fl::extract_sharp_lines(clean, angle, {}).graph);
  fmt::print(
      "{}: {} sharp edges above {} degrees by CGAL, {} by Crest, the same set: {}; {} open "
      "ends. Noise: normal, of each coordinate, standard deviation in mean edge lengths. "
      "Precision, recall: percent of the found (true) edges whose ends are at most one edge "
      "from the true (found) ones.\n\n| noise | method | edges | precision | recall | F | open "
      "ends |\n|---|---|---|---|---|---|---|\n",
      std::filesystem::path(file).filename().string(), truth.size(), degrees, ours.size(),
      truth == ours ? "yes" : "no", open_ends(truth));
  for (const double level : levels) {
    const auto mesh = noisy(clean, level, seed);
    const std::string start = fmt::format("{:g} | ", level);
    for (const int a : {degrees, degrees / 2}) {
      print(start + fmt::format("CGAL, {}", a), mesh, sorted(experiments::sharp_edges(mesh, a)),
            truth);
      const kernel::DecimalAngle at(std::to_string(a));
      print(start + fmt::format("--angle {} --prune {}", a, prune), mesh,
            edges_of(fl::extract_sharp_lines(mesh, at, {prune, 0}).graph), truth);
      for (const Index rings : {1u, 2u, 3u})
        print(start + fmt::format("--angle {} --over {} --prune {}", a, rings, prune), mesh,
              over_rings(mesh, a, rings, prune), truth);
    }
  }
  return 0;
}

}  // namespace
}  // namespace crest

int main(int argc, char** argv) {
  std::string file = "../shared/data/meshes/fandisk.off";
  std::vector<double> levels = {0, 0.05, 0.1, 0.2, 0.3, 0.4};
  int degrees = 60;
  unsigned seed = 1, prune = 4;
  crest::experiments::Program program("Sharp edges under noise, beside CGAL's");
  program.option("--mesh", file, "(default ../shared/data/meshes/fandisk.off)");
  program.option("--angle", degrees,
                 "what is sharp without noise; the methods use it and its half");
  program.list("--noise", levels, "standard deviations, in mean edge lengths");
  program.option("--seed", seed, "of the noise");
  program.option("--prune", prune, "vertices");
  return program.run(argc, argv, [&] { return crest::run(file, degrees, levels, seed, prune); });
}
