// SPDX-License-Identifier: GPL-3.0-or-later
// What users do today: marching tets on the mode as a scalar, each tet in 1, 8, 27 or 64. Topology,
// the largest error of the mode at triangles' centres, time, on the four blocks.
#include <fmt/format.h>

#include <chrono>

#include "algorithms/sampling/loaded_block.hpp"
#include "experiments/004-modes/marching.hpp"
#include "experiments/program.hpp"

namespace crest::experiments {
namespace {

void run(const std::string& only, const std::vector<double>& levels, bool mirror, int finest) {
  fmt::print(
      "| block | level | parts of a tet | triangles | components | Euler characteristic | boundary "
      "loops | "
      "largest error of the mode | seconds |\n|---|---|---|---|---|---|---|---|---|\n");
  for (const sampling::Scenario& s : sampling::scenarios()) {
    if (!only.empty() && only != s.name) continue;
    const auto [block, stress, steps] = sampling::load_block(s, 1, mirror);
    const auto tets = block.tets();
    for (const double level : levels)
      for (int n = 1; n <= finest; ++n) {
        const auto start = std::chrono::steady_clock::now();
        const Lattice lattice(n);
        Marching marching(stress, {}, level);
        for (const auto& t : tets) marching.add(t, lattice, n);
        const auto c = marching.count();
        const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
        fmt::print("| {} | {} | {} | {} | {} | {} | {} | {:.3g} | {:.1f} |\n", s.name, level,
                   n * n * n, c.triangles, c.components, c.euler, c.loops, c.error, time.count());
        std::fflush(stdout);
      }
  }
}

}  // namespace
}  // namespace crest::experiments

int main(int argc, char** argv) {
  std::string only;
  std::vector<double> levels{0.97, -0.97, 0.53, -0.53, 0};
  bool mirror = false;
  int finest = 4;
  crest::experiments::Program program("Marching tets on the mode of the four blocks.");
  program.option("--only", only, "one block: single, push_pull, three, twist");
  program.list("--mode", levels, "signed levels");
  program.flag("--mirror", mirror, "make the symmetries of the loads exact");
  program.option("--finest", finest, "parts of an edge at most", {1, 6});
  return program.run(argc, argv, [&] {
    crest::experiments::run(only, levels, mirror, finest);
    return 0;
  });
}
