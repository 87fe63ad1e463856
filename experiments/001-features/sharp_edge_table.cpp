// SPDX-License-Identifier: GPL-3.0-or-later
// Feature lines beside CGAL's sharp edges: do arcs run along them, how many ends dangle?
#include <fmt/format.h>

#include <filesystem>

#include "experiments/001-features/feature_field.hpp"
#include "experiments/program.hpp"
#include "io/read/mesh_reader.hpp"

namespace crest {
namespace {

namespace fl = feature_lines;

using Edges = std::vector<std::array<kernel::Index, 2>>;

/// Edges with both ends at most one edge from a marked vertex.
std::size_t near(const kernel::TriangleMesh& mesh, const fl::Marks& marks, const Edges& edges) {
  const fl::Marks reach = fl::dilate(mesh, marks, {fl::Neighbourhood::rings, 1});
  return static_cast<std::size_t>(std::count_if(
      edges.begin(), edges.end(), [&](const auto& e) { return reach[e[0]] && reach[e[1]]; }));
}

/// The vertices of arcs, with their ends in nodes, and of loops.
fl::Marks on_arcs(const fl::FeatureGraph& graph) {
  fl::Marks marks(graph.labels.size(), 0);
  for (const auto& line : graph.lines) {
    if (line.kind != fl::LineKind::arc && line.kind != fl::LineKind::loop) continue;
    for (const kernel::Index v : line.vertices) marks[v] = 1;
  }
  return marks;
}

/// Sharp edges on the chains that lead from a dangling end to the next branching: no arc can follow
/// these without leaving the dangling end.
std::size_t on_dangling_chains(const kernel::TriangleMesh& mesh, const Edges& edges) {
  std::vector<std::vector<std::size_t>> at(mesh.vertex_count());
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (const kernel::Index v : edges[i]) at[v].push_back(i);
  std::vector<bool> seen(edges.size(), false);
  for (kernel::Index start = 0; start < mesh.vertex_count(); ++start) {
    if (at[start].size() != 1) continue;
    std::size_t i = at[start][0];
    for (kernel::Index v = start; !seen[i];) {
      seen[i] = true;
      v = edges[i][0] == v ? edges[i][1] : edges[i][0];
      if (at[v].size() != 2) break;
      i = at[v][0] == i ? at[v][1] : at[v][0];
    }
  }
  return static_cast<std::size_t>(std::count(seen.begin(), seen.end(), true));
}

struct Row {
  std::string file;
  double degrees;
  std::string method;
  fl::Options options;
};

void print(const Row& row, const std::string& folder) {
  const std::string path = folder + "/" + row.file;
  if (!std::filesystem::exists(path)) {
    fmt::print("{}: not there, skipped\n", path);
    return;
  }
  const auto mesh = io::read_mesh(path).mesh;
  const Edges edges = experiments::sharp_edges(mesh, row.degrees);
  const auto f =
      fl::extract_feature_lines(mesh, experiments::curvature_field(mesh, row.method), row.options);
  const auto on = std::count_if(edges.begin(), edges.end(),
                                [&](const auto& e) { return f.marks[e[0]] && f.marks[e[1]]; });
  const auto branches = f.graph.count(fl::LineKind::branch);
  const auto lone = f.graph.count(fl::LineKind::isolated);
  fmt::print(
      "| {} | {} | {:g} | {} | {} | {} | {} {:g}, {:g}, {} | {} | {} | {} | {} | {} | {} | {} | "
      "{} |\n",
      row.file, mesh.vertex_count(), row.degrees, edges.size(),
      experiments::dangling_ends(mesh, edges), on_dangling_chains(mesh, edges), row.method,
      row.options.quantile, row.options.close, row.options.prune,
      near(mesh, on_arcs(f.graph), edges), near(mesh, f.marks, edges), on,
      f.graph.count(fl::LineKind::arc), f.graph.count(fl::LineKind::loop), branches, lone,
      branches + 2 * lone);
  std::fflush(stdout);
}

void print_head() {
  fmt::print(
      "| mesh | vertices | angle | sharp edges (CGAL) | their dangling ends | of them on dangling "
      "chains | method, quantile, close, prune | near an arc | near a line | on a line | arcs | "
      "loops | branches | isolated | open ends |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
}

int run(const std::string& folder, const std::string& method, const fl::Options& fandisk) {
  fmt::print("Near: both ends at most one edge away. On: both ends are line vertices.\n\n");
  print_head();
  print({"fandisk.off", 60, method, fandisk}, folder);
  fl::Options old = fandisk;
  old.quantile = 0.85;
  print({"fandisk.off", 60, "fit", old}, folder);
  fl::Options scan;
  scan.quantile = 0.85;
  scan.close = 1;
  scan.prune = 10;
  for (const char* file : {"rocker-arm.obj", "stanford-bunny.obj", "horse.ply", "armadillo.off"})
    print({file, 30, "fit", scan}, folder);
  fmt::print("\n### How much the threshold matters\n\n");
  print_head();
  for (const char* by : {"ne", "fit"})
    for (int q = 80; q <= 90; ++q) {
      fl::Options options = fandisk;
      options.quantile = q / 100.0;
      print({"fandisk.off", 60, by, options}, folder);
    }
  return 0;
}

}  // namespace
}  // namespace crest

int main(int argc, char** argv) {
  std::string folder = "../shared/data/meshes";
  crest::feature_lines::Options fandisk;
  std::string method = "ne";
  fandisk.quantile = 0.885;
  fandisk.prune = 4;
  crest::experiments::Program program("Feature lines beside CGAL's sharp edges");
  program.option("--folder", folder, "of meshes (default ../shared/data/meshes)");
  program.option("--threshold", fandisk.quantile, "quantile for fandisk");
  program.option("--method", method, "of fandisk's curvature (default ne)");
  program.option("--close", fandisk.close, "rings, for fandisk");
  program.option("--open", fandisk.open, "rings, for fandisk");
  program.option("--dilate", fandisk.dilate, "rings, for fandisk");
  program.option("--prune", fandisk.prune, "vertices, for fandisk");
  program.option("--min-patch", fandisk.min_patch, "vertices, for fandisk");
  program.option("--close-branches", fandisk.close_branches, "edges, for fandisk");
  return program.run(argc, argv, [&] { return crest::run(folder, method, fandisk); });
}
