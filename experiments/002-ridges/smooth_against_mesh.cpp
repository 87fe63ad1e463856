// SPDX-License-Identifier: GPL-3.0-or-later
// Paper 002, case II against case I: ridges of a mesh with fitted Monge forms beside the certified
// ridges of the smooth surface, on the very same triangulation.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>

#include "algorithms/smooth_ridges/smooth_ridges.hpp"
#include "experiments/002-ridges/smooth_surfaces.hpp"
#include "experiments/peers/ridges/crest_run.hpp"
#include "kernel/arithmetic/self_test.hpp"

namespace crest {
namespace {

using experiments::SmoothSurface;
using smooth_ridges::SmoothRidges;
using smooth_ridges::Surface;

struct Options {
  std::vector<std::string> only = {"ellipsoid 1, 1.5, 2", "blend"};
  std::vector<int> start_faces = {1000, 3000, 10000, 30000, 100000};
};

struct Counts {
  int plus = 0, minus = 0, other = 0;
  std::array<int, 2> loops{}, paths{};  ///< blue, red
  bool operator==(const Counts&) const = default;
};

Counts counts_of(const SmoothRidges& r) {
  Counts c;
  for (const auto& u : r.umbilics) ++(u.twice_index > 0 ? c.plus : c.minus);
  for (const auto& ridge : r.ridges) ++(ridge.loop ? c.loops : c.paths)[ridge.colour];
  return c;
}

Counts counts_of(const ridges::RidgeGraph& graph) {
  const peers::CrestResult r = peers::count(graph);
  return {r.plus, r.minus, r.other, {r.blue.loops, r.red.loops}, {r.blue.segments, r.red.segments}};
}

std::string text_of(const Counts& c) {
  return fmt::format("{}, {}, {} | {} + {} | {} + {}", c.plus, c.minus, c.other, c.loops[0],
                     c.paths[0], c.loops[1], c.paths[1]);
}

Surface make(const SmoothSurface& s) {
  if (s.functions.size() == 1) return Surface::implicit(s.functions[0], s.box);
  return Surface::parametric({s.functions[0], s.functions[1], s.functions[2]}, s.domain,
                             s.periodic);
}

void row(const SmoothSurface& surface, int start_faces) {
  smooth_ridges::Options options;
  options.start_faces = start_faces;
  const SmoothRidges smooth = smooth_ridges::smooth_ridges(make(surface), options);
  if (!smooth.certified) {
    fmt::print("| {} | {} | not certified | | | | | | |\n", surface.name, smooth.faces.size());
    return;
  }
  const kernel::TriangleMesh mesh(smooth.points, smooth.faces);
  const auto forms = ridges::fit_monge_forms(mesh, {}).forms;
  const Counts proven = counts_of(smooth);
  const Counts fitted = counts_of(ridges::extract_ridge_graph(mesh, forms));
  fmt::print("| {} | {} | {} | {} | {} |\n", surface.name, smooth.faces.size(), text_of(proven),
             text_of(fitted), proven == fitted ? "yes" : "no");
  std::fflush(stdout);
}

void run(const Options& o) {
  fmt::print(
      "| surface | triangles | certified umbilics +1/2, -1/2, other | blue loops + paths | red | "
      "mesh umbilics | blue | red | same |\n|---|---|---|---|---|---|---|---|---|\n");
  for (const SmoothSurface& surface : experiments::generic_surfaces()) {
    if (std::none_of(o.only.begin(), o.only.end(), [&](const std::string& part) {
          return surface.name.find(part) != std::string::npos;
        }))
      continue;
    for (const int faces : o.start_faces) row(surface, faces);
  }
  fmt::print(
      "\nThe mesh is the certified triangulation; its Monge forms are fitted with the defaults of "
      "`crest ridges`.\n");
}

}  // namespace
}  // namespace crest

int main(int argc, char** argv) {
  crest::Options o;
  CLI::App app{"Ridges of meshes against certified ones"};
  app.add_option("--only", o.only, "surfaces whose name contains one of these");
  app.add_option("--start-faces", o.start_faces, "faces before refinement")->delimiter(',');
  CLI11_PARSE(app, argc, argv);
  fmt::print("Command:");
  for (int i = 0; i < argc; ++i)
    fmt::print(" {}", i == 0 ? "experiments/002-ridges/smooth_against_mesh" : argv[i]);
  fmt::print("\n\n");
  try {
    crest::kernel::require_sound_floating_point();
    crest::run(o);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 3;
  }
  return 0;
}
