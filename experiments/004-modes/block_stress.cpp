// SPDX-License-Identifier: GPL-3.0-or-later
// The four blocks of paper 004, section 7 and appendix B: stress of a block under compression, push
// and pull, three compressions, a twisting compression, as VTU with a 6-component point array.
#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "algorithms/sampling/loaded_block.hpp"
#include "experiments/program.hpp"
#include "io/write/tet_writer.hpp"

namespace crest::experiments {
namespace {

void run(const std::filesystem::path& folder, const std::string& only, bool mirror) {
  fmt::print(
      "| block | hexahedra | tets | iterations | seconds | file |\n|---|---|---|---|---|---|\n");
  for (const sampling::Scenario& s : sampling::scenarios()) {
    if (!only.empty() && only != s.name) continue;
    const auto start = std::chrono::steady_clock::now();
    const auto [block, stress, steps] = sampling::load_block(s, 1, mirror);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    const auto path = folder / (s.name + ".vtu");
    io::write_tets(path.string(), points(block), block.tets(), "stress", stress);
    const int hexahedra = s.cubes[0] * s.cubes[1] * s.cubes[2];
    fmt::print("| {} | {} | {} | {} | {:.1f} | {} |\n", s.name, hexahedra, 6 * hexahedra, steps,
               time.count(), path.filename().string());
  }
}

}  // namespace
}  // namespace crest::experiments

int main(int argc, char** argv) {
  std::filesystem::path folder = ".";
  std::string only;
  bool mirror = false;
  crest::experiments::Program program("Stress of the four blocks as VTU.");
  program.option("--output", folder, "folder of the files");
  program.option("--only", only, "one block: single, push_pull, three, twist");
  program.flag("--mirror", mirror, "make the symmetries of the loads exact (not of twist)");
  return program.run(argc, argv, [&] {
    crest::experiments::run(folder, only, mirror);
    return 0;
  });
}
