// SPDX-License-Identifier: GPL-3.0-or-later
// The index sum against the Euler characteristic on every closed scan of a folder, and how many
// ridge ends stay unjoined, Crest beside CGAL with the same supports. Crest's sum and joins are
// right by construction, for any data; CGAL claims neither.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "algorithms/ridges/certificate.hpp"
#include "certify/verify.hpp"
#include "experiments/packed_mesh.hpp"
#include "experiments/peers/ridges/cgal_peer.hpp"
#include "experiments/peers/ridges/crest_run.hpp"
#include "experiments/program.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::string folder = "../shared/data/meshes";
  unsigned cgal_seconds = 600;
};

struct Tally {
  int meshes = 0, equal = 0, verified = 0, cgal_meshes = 0, cgal_equal = 0;
};

// Indices, their sum and unjoined ends, or why there are none.
std::string cgal_columns(const kernel::TriangleMesh& mesh, const Options& o, Tally& tally) {
  try {
    const peers::CgalResult r = peers::run_cgal_within(o.cgal_seconds, mesh);
    ++tally.cgal_meshes;
    tally.cgal_equal += r.index_sum() == mesh.euler_characteristic();
    return fmt::format("| {}, {}, {} | {} | {} ", r.plus, r.minus, r.other, r.index_sum(),
                       r.blue_lines.open_ends + r.red_lines.open_ends);
  } catch (const std::exception& error) {
    return fmt::format("| {} | | ", error.what());
  }
}

void row(const fs::path& path, const kernel::TriangleMesh& mesh, const Options& o, Tally& tally) {
  const ridges::FitResult fit = ridges::fit_monge_forms(mesh, {});
  const ridges::RidgeGraph graph = ridges::extract_ridge_graph(mesh, fit.forms);
  const peers::CrestResult c = peers::count(graph);
  const bool accepted =
      certify::verify(certify::encode(ridges::make_certificate(mesh, fit.forms, graph))).accepted;
  const int chi = mesh.euler_characteristic();
  ++tally.meshes;
  tally.equal += graph.twice_index_sum == 2 * chi;
  tally.verified += accepted;
  const std::string peer = cgal_columns(mesh, o, tally);
  fmt::print("| {} | {} | {} | {}, {}, {} | {} | {} | {} {}|\n", path.filename().string(),
             mesh.vertex_count(), chi, c.plus, c.minus, c.other, c.index_sum, c.open_ends,
             accepted ? "accepted" : "REJECTED", peer);
  std::fflush(stdout);
}

int run(const Options& o) {
  if (!fs::is_directory(o.folder)) {
    std::cerr << o.folder << ": no such folder; give one with meshes (--folder): skipped\n";
    return 0;
  }
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(o.folder))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  fmt::print(
      "| mesh | vertices | chi | +1/2, -1/2, other | index sum | unjoined ends | crest-verify | "
      "CGAL +1/2, -1/2, other | CGAL index sum | CGAL unjoined ends |\n"
      "|---|---|---|---|---|---|---|---|---|---|\n");
  Tally tally;
  for (const fs::path& path : files) {
    try {
      const auto file = experiments::read_mesh(path.string());
      if (file && file->mesh.closed()) row(path, file->mesh, o, tally);
    } catch (const kernel::InputError&) {
      // Not a closed manifold triangle mesh: not a case of this table.
    }
  }
  fmt::print(
      "\nCrest: index sum = chi on {} of {} meshes, as on any, {} certificates accepted. CGAL: {} "
      "of "
      "the {} it finishes, with the same supports (rings until 30 points) and its own patch "
      "size.\n",
      tally.equal, tally.meshes, tally.verified, tally.cgal_equal, tally.cgal_meshes);
  return tally.equal == tally.meshes && tally.verified == tally.meshes ? 0 : 1;
}

}  // namespace
}  // namespace crest

int main(int argc, char** argv) {
  crest::Options o;
  crest::experiments::Program program(
      "Index sum and Euler characteristic of closed meshes, Crest beside CGAL");
  program.option("--folder", o.folder, "of meshes (default ../shared/data/meshes)");
  program.option("--cgal-seconds", o.cgal_seconds,
                 "of processor time that CGAL may take for a mesh (default 600)");
  return program.run(argc, argv, [&] { return crest::run(o); });
}
