// SPDX-License-Identifier: GPL-3.0-or-later
// Feature lines beside CGAL's sharp edges: do arcs run along them, how many ends dangle?
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>

#include "experiments/001-features/feature_field.hpp"
#include "io/mesh_reader.hpp"

namespace crest {
namespace {

namespace fl = feature_lines;

struct Row {
  std::string file;
  double degrees;
  fl::Options options;
  int rings;
};

/// Sharp edges with both ends at most one edge from an arc, a loop or a node; or from any line.
std::size_t near_lines(const kernel::TriangleMesh& mesh, const fl::FeatureGraph& graph,
                       const std::vector<std::array<kernel::Index, 2>>& edges, bool any) {
  fl::Marks near(mesh.vertex_count(), 0);
  for (kernel::Index v = 0; v < mesh.vertex_count(); ++v)
    near[v] = graph.labels[v] == fl::Label::arc || graph.labels[v] == fl::Label::node ||
              graph.labels[v] == fl::Label::loop || (any && graph.labels[v] != fl::Label::patch);
  near = fl::dilate(mesh, near, {fl::Neighbourhood::rings, 1});
  return static_cast<std::size_t>(std::count_if(
      edges.begin(), edges.end(), [&](const auto& e) { return near[e[0]] && near[e[1]]; }));
}

void print(const Row& row, const std::string& folder) {
  const std::string path = folder + "/" + row.file;
  if (!std::filesystem::exists(path)) {
    fmt::print("{}: not there, skipped\n", path);
    return;
  }
  const auto mesh = io::read_mesh(path).mesh;
  const auto edges = experiments::sharp_edges(mesh, row.degrees);
  const auto f =
      fl::extract_feature_lines(mesh, experiments::curvature_field(mesh, row.rings), row.options);
  const auto branches = f.graph.count(fl::LineKind::branch);
  const auto lone = f.graph.count(fl::LineKind::isolated);
  fmt::print("| {} | {} | {:g} | {} | {} | {} | {} | {} | {:g} | {} | {} | {} | {} | {} | {} |\n",
             row.file, mesh.vertex_count(), row.degrees, edges.size(),
             experiments::dangling_ends(mesh, edges), near_lines(mesh, f.graph, edges, false),
             near_lines(mesh, f.graph, edges, true), row.rings, row.options.quantile,
             row.options.prune, f.graph.count(fl::LineKind::arc), f.graph.count(fl::LineKind::loop),
             branches, lone, branches + 2 * lone);
  std::fflush(stdout);
}

int run(const std::string& folder, const fl::Options& fandisk, int rings) {
  fmt::print(
      "| mesh | vertices | angle | sharp edges (CGAL) | their dangling ends | of them near an arc "
      "| "
      "quantile | prune | arcs | loops | branches | isolated | open ends |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  fl::Options scan;
  scan.quantile = 0.85;
  scan.close = 1;
  scan.prune = 10;
  print({"fandisk.off", 60, fandisk, rings}, folder);
  for (const char* file : {"rocker-arm.obj", "stanford-bunny.obj", "horse.ply", "armadillo.off",
                           "dragon_vrip_res3.ply"})
    print({file, 30, scan, 0}, folder);
  return 0;
}

}  // namespace
}  // namespace crest

int main(int argc, char** argv) {
  std::string folder = "../shared/data/meshes";
  crest::feature_lines::Options fandisk;
  int rings = 0;
  fandisk.quantile = 0.85;
  fandisk.prune = 4;
  CLI::App app{"Feature lines beside CGAL's sharp edges"};
  app.add_option("--folder", folder, "of meshes (default ../shared/data/meshes)");
  app.add_option("--threshold", fandisk.quantile, "quantile for fandisk");
  app.add_option("--rings", rings, "of the curvature's fit, for fandisk; 0: until 30 points");
  app.add_option("--close", fandisk.close, "rings, for fandisk");
  app.add_option("--open", fandisk.open, "rings, for fandisk");
  app.add_option("--dilate", fandisk.dilate, "rings, for fandisk");
  app.add_option("--prune", fandisk.prune, "vertices, for fandisk");
  app.add_option("--min-patch", fandisk.min_patch, "vertices, for fandisk");
  app.add_option("--close-branches", fandisk.close_branches, "edges, for fandisk");
  CLI11_PARSE(app, argc, argv);
  try {
    return crest::run(folder, fandisk, rings);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 3;
  }
}
