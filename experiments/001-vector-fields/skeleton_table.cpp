// SPDX-License-Identifier: GPL-3.0-or-later
// Skeletons of the generated fields: the reference table, the twins of the thesis' data, and a
// large field; processor time (of all threads) of the whole, of finding zeros alone, and wall time.
#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <chrono>
#include <string>

#include "algorithms/sampling/planar_fields.hpp"
#include "algorithms/vector_fields/vector_fields.hpp"
#include "algorithms/vector_fields/zeros.hpp"
#include "experiments/processor_time.hpp"
#include "experiments/program.hpp"

namespace crest::experiments {
namespace {

using namespace vector_fields;

template <class Items, class Test>
auto count(const Items& items, Test&& test) {
  return std::count_if(items.begin(), items.end(), test);
}

void row(const std::string& name, sampling::PlanarSample sample) {
  const PlanarField field{std::move(sample.points), std::move(sample.vectors),
                          std::move(sample.triangles)};
  const Domain domain(field);
  double start = processor_seconds();
  const std::size_t zeros = find_zeros(domain).size();
  const double scan = processor_seconds() - start;
  start = processor_seconds();
  const auto clock = std::chrono::steady_clock::now();
  const Skeleton s = extract_skeleton(field);
  const double whole = processor_seconds() - start;
  const double wall =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - clock).count();
  const auto kind = [&](ZeroKind k) {
    return count(s.critical_points, [k](const CriticalPoint& c) { return c.kind == k; });
  };
  const auto touch = [&](bool inside, bool vertex) {
    return count(s.switch_points,
                 [=](const SwitchPoint& p) { return p.inside == inside && p.at_vertex == vertex; });
  };
  const auto end = [&](EndKind e) {
    return count(s.separatrices, [e](const Separatrix& l) { return l.end == e; });
  };
  const auto precise = count(s.separatrices, [](const Separatrix& l) {
    return l.bits > 53 && l.end != EndKind::undecided;
  });
  fmt::print(
      "| {} | {} | {} | {}/{}/{} ({}) | {}+{} / {}+{} | {} = {} | {} | {}/{}/{} | {} | {} | {} | "
      "{:.4f} "
      "| {:.3f} | {:.3f} |\n",
      name, field.triangles.size(), zeros, kind(ZeroKind::saddle), kind(ZeroKind::source),
      kind(ZeroKind::sink),
      count(s.critical_points, [](const CriticalPoint& c) { return c.focus; }), touch(true, false),
      touch(true, true), touch(false, false), touch(false, true), s.index_sum, s.winding_sum,
      s.separatrices.size(), end(EndKind::critical_point), end(EndKind::boundary),
      end(EndKind::closed_orbit), end(EndKind::undecided), precise, s.counts.crossings, scan, whole,
      wall);
}

void table(int large) {
  fmt::print(
      "| field | triangles | zeros | saddle/source/sink (foci) | switch in-edge + vertex / "
      "out-edge "
      "+ vertex | index = winding | separatrices | ends zero/boundary/orbit | undecided | beyond "
      "53 "
      "bits | crossings | zeros alone, s | whole, s | wall, s |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  const std::pair<std::uint64_t, bool> fields[] = {{1, false}, {1, true},  {2, false}, {2, true},
                                                   {3, false}, {4, false}, {5, false}, {6, true},
                                                   {7, false}, {8, true}};
  for (const auto& [seed, hole] : fields)
    row(fmt::format("L({}){}", seed, hole ? " hole" : ""), sampling::lattice_field(seed, 40, hole));
  row("Bodden (twin)", sampling::twin_bodden());
  row("skin friction (twin)", sampling::twin_skin());
  if (large > 0) row(fmt::format("L(30), {0} x {0}", large), sampling::lattice_field(30, large));
}

}  // namespace
}  // namespace crest::experiments

int main(int argc, char** argv) {
  int large = 1024;
  crest::experiments::Program program("Skeletons of generated plane fields.");
  program.option("--large", large, "cells a side of the last row; 0: none", {0, 4096});
  return program.run(argc, argv, [&] {
    crest::experiments::table(large);
    return 0;
  });
}
