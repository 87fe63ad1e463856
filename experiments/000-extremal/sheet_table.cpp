// SPDX-License-Identifier: GPL-3.0-or-later
// Sheets with known answers: what is extracted from them at several sizes by both definitions.
#include <fmt/format.h>

#include <algorithm>

#include "experiments/000-extremal/inputs.hpp"
#include "experiments/program.hpp"

namespace crest::experiments {
namespace {

struct Sums {
  std::int64_t euler = 0;
  std::size_t loops = 0, isotopic = 0;
  bool orientable = true;
};

Sums sums_of(const extremal::Result& r) {
  Sums s;
  for (const auto& c : r.components) {
    s.euler += c.euler_characteristic;
    s.loops += c.boundary_loops;
    s.isotopic += c.isotopic.value_or(false) ? 1 : 0;
    s.orientable = s.orientable && c.orientable;
  }
  return s;
}

void row(const sampling::Phantom& p, std::size_t nodes, bool hessian, int refine,
         double min_strength) {
  auto options = ridge_options(hessian, 0.4, min_strength);
  options.refine = refine;
  const auto r = extremal::extract(phantom(p.name, nodes), options);
  const Sums s = sums_of(r);
  const auto& c = r.counts;
  const auto largest =
      std::max_element(r.components.begin(), r.components.end(),
                       [](const auto& a, const auto& b) { return a.polygons < b.polygons; });
  const bool right = largest != r.components.end() &&
                     largest->euler_characteristic == p.known.euler_characteristic &&
                     largest->boundary_loops == static_cast<std::size_t>(p.known.boundary_loops) &&
                     largest->orientable == p.known.orientable;
  const double proven =
      100.0 * static_cast<double>(c.empty + c.regular) /
      static_cast<double>(std::max<std::size_t>(1, c.empty + c.regular + c.cone + c.open));
  fmt::print(
      "| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {:.2f} | "
      "{:.3f} | {} "
      "|\n",
      p.name, nodes, hessian ? "hessian" : "structure", refine, c.critical_edges, c.extremal_edges,
      c.odd_faces, r.components.size(), s.euler, s.loops, s.orientable ? "yes" : "no", c.valence[0],
      c.valence[2], c.odd_valence_unexplained, c.undecided_edges, s.isotopic, proven,
      static_cast<double>(c.cone_tests) / static_cast<double>(std::max<std::size_t>(1, c.edges)),
      right ? "yes" : "NO");
  std::fflush(stdout);
}

}  // namespace
}  // namespace crest::experiments

int main(int argc, char** argv) {
  using namespace crest;
  std::vector<int> sizes{48, 64, 128};
  std::string only;
  std::string definition = "structure";
  int refine = 0;
  double min_strength = 0;
  experiments::Program program("Sheets with known answers, structure and hessian.");
  program.list("--nodes", sizes, "along each axis");
  program.option("--only", only, "one phantom");
  program.option("--definition", definition, "of n", {"structure", "hessian"});
  program.option("--min-strength", min_strength, "in the world's units");
  program.option("--refine", refine, "splits of cells that are not proven", {0, 8});
  return program.run(argc, argv, [&] {
    fmt::print(
        "sigma 1, min-value 0.4. Proven: cells empty or regular, of "
        "those tested; right: Euler characteristic, loops and orientability of the largest "
        "component are those of the "
        "sheet\n\n"
        "| sheet | nodes | definition | refine | critical edges | extremal | odd faces | "
        "components | chi | loops | "
        "orientable | valence 1 | valence 3 | unexplained | undecided edges | isotopic | proven, % "
        "| "
        "tests an edge | right "
        "|\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (const auto& p : sampling::volume_phantoms()) {
      if (!only.empty() && p.name != only) continue;
      for (const int n : sizes)
        experiments::row(p, static_cast<std::size_t>(n), definition == "hessian", refine,
                         min_strength);
    }
    return 0;
  });
}
