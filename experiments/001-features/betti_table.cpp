// SPDX-License-Identifier: GPL-3.0-or-later
// Components and loops before and after thinning on every mesh of a folder, and the checker's
// verdict.
#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <iostream>

#include "algorithms/feature_lines/certificate.hpp"
#include "certify/verify.hpp"
#include "experiments/001-features/feature_field.hpp"
#include "experiments/packed_mesh.hpp"
#include "experiments/program.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest {
namespace {

namespace fl = feature_lines;
namespace fs = std::filesystem;

std::string text(const fl::Betti& b) {
  return fmt::format("{}, {}", b.b0, b.b1);
}

/// True if kept and accepted.
bool row(const fs::path& path, const kernel::TriangleMesh& mesh, const fl::Options& options) {
  const auto field = experiments::curvature_field(mesh);
  const auto start = std::chrono::steady_clock::now();
  const auto f = fl::extract_feature_lines(mesh, field, options);
  const double ms =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() * 1e3;
  const auto verdict = certify::verify(certify::encode(fl::make_certificate(mesh, f.thinning)));
  const auto &before = f.thinning.topology_before, &after = f.thinning.topology_after;
  fmt::print("| {} | {} | {} | {} | {} | {} | {} | {} | {:.1f} | {} |\n", path.filename().string(),
             mesh.vertex_count(), f.marked, fl::count(f.marks), text(before.marked),
             text(after.marked), text(before.complement), text(after.complement), ms,
             verdict.accepted ? "accepted" : "REJECTED");
  std::fflush(stdout);
  return before == after && verdict.accepted;
}

int run(const std::string& folder, const fl::Options& options) {
  if (!fs::is_directory(folder)) {
    std::cerr << folder << ": no such folder; give one with meshes (--folder): skipped\n";
    return 0;
  }
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  fmt::print(
      "| mesh | vertices | marked | on lines | marked b0, b1 before | after | complement b0, b1 "
      "before | after | ms | crest-verify |\n|---|---|---|---|---|---|---|---|---|---|\n");
  int meshes = 0, kept = 0;
  std::vector<std::string> skipped;
  for (const fs::path& path : files) {
    try {
      const auto file = experiments::read_mesh(path.string());
      if (!file) {
        skipped.push_back(path.filename().string());
        continue;
      }
      kept += row(path, file->mesh, options);
      ++meshes;
    } catch (const kernel::InputError&) {
      // Not an orientable manifold triangle mesh: not a case of this table.
    }
  }
  for (const auto& name : skipped)
    fmt::print("\n{}: packed, and there is no program xz to unpack it: skipped\n", name);
  fmt::print("\nKept and accepted: {} of {} meshes.\n", kept, meshes);
  return kept == meshes ? 0 : 1;
}

}  // namespace
}  // namespace crest

int main(int argc, char** argv) {
  std::string folder = "../shared/data/meshes";
  crest::feature_lines::Options options;
  options.close = 1;
  options.prune = 5;
  crest::experiments::Program program("Betti numbers before and after thinning");
  program.option("--folder", folder, "of meshes (default ../shared/data/meshes)");
  program.option("--threshold", options.quantile, "quantile (default 0.85)");
  program.option("--prune", options.prune, "vertices (default 5)");
  return program.run(argc, argv, [&] { return crest::run(folder, options); });
}
