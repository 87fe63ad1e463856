// SPDX-License-Identifier: GPL-3.0-or-later
// Processor time of the first look at every tetrahedron of the four blocks, error bounds included:
// signs of f by bounds of det and |T|^2, then by the 84 coefficients (aim 250 ns a tetrahedron).
#include <fmt/format.h>

#include "algorithms/modes/pieces.hpp"
#include "algorithms/sampling/loaded_block.hpp"
#include "experiments/median.hpp"
#include "experiments/processor_time.hpp"
#include "experiments/program.hpp"

namespace crest::experiments {
namespace {

struct Counts {
  std::size_t bound = 0, coefficients = 0, open = 0;
};

Counts count(const std::vector<modes::CellSign>& signs) {
  Counts c;
  for (const modes::CellSign& s : signs)
    ++(s.finding == modes::Finding::none ? c.open : s.bound ? c.bound : c.coefficients);
  return c;
}

void run(const std::string& only, int times) {
  fmt::print(
      "Medians of {} runs. Deviators: of all vertices, a tetrahedron\n\n| block | tets | level | "
      "rejected by bounds | by coefficients | open | deviators, ns a tet | signs, ns a tet "
      "|\n|---|---|---|---|---|---|---|---|\n",
      times);
  const std::vector<modes::Level> levels = {{97, 100}, {53, 100}, {0, 1}};
  for (const sampling::Scenario& s : sampling::scenarios()) {
    if (!only.empty() && only != s.name) continue;
    const auto [block, stress, steps] = sampling::load_block(s, 1, false);
    auto tets = block.tets();
    for (auto& t : tets) std::sort(t.begin(), t.end());
    const int scale = modes::scale_of(stress);
    const double unit = 1e9 / static_cast<double>(tets.size());
    for (const modes::Level& level : levels) {
      const auto seconds = [&](const auto& work) {
        return median_of(times, [&] {
          const double start = processor_seconds();
          work();
          return processor_seconds() - start;
        });
      };
      const double deviators = seconds([&] { modes::Vertices(stress, scale, level); });
      modes::Vertices vertices(stress, scale, level);
      std::vector<modes::CellSign> signs;
      const double scan = seconds([&] { signs = modes::signs_on(vertices, tets, level); });
      const Counts c = count(signs);
      fmt::print("| {} | {} | {} | {} | {} | {} | {:.0f} | {:.0f} |\n", s.name, tets.size(),
                 level.value(), c.bound, c.coefficients, c.open, unit * deviators, unit * scan);
      std::fflush(stdout);
    }
  }
}

}  // namespace
}  // namespace crest::experiments

int main(int argc, char** argv) {
  std::string only;
  int times = 5;
  crest::experiments::Program program("Processor time of rejection on the four blocks.");
  program.option("--only", only, "one block: single, push_pull, three, twist");
  program.option("--times", times, "runs of each", {1, 1000});
  return program.run(argc, argv, [&] {
    crest::experiments::run(only, times);
    return 0;
  });
}
