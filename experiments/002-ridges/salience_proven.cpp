// SPDX-License-Identifier: GPL-3.0-or-later
// What salience drops of the noise-free perturbed torus, against the proven graph of the smooth
// surface: which of the dropped lines are real, which of the kept ones are not.
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "algorithms/ridges/salience.hpp"
#include "algorithms/sampling/mesh_surface.hpp"
#include "algorithms/smooth_ridges/smooth_ridges.hpp"
#include "experiments/002-ridges/line_match.hpp"
#include "experiments/002-ridges/smooth_surfaces.hpp"
#include "experiments/program.hpp"
#include "kernel/arithmetic/self_test.hpp"

namespace crest {
namespace {

using experiments::Dash;
using experiments::dashes;

/// The sample's "perturbed-torus" with its default parameters.
experiments::SmoothSurface perturbed_torus() {
  experiments::SmoothSurface s;
  s.name = "perturbed torus";
  const std::string w = "(z/0.8)";
  s.functions = {"(sqrt(x^2+y^2)-1)^2+0.16*(" + w + "^2-0.3*(0.6*x*y+0.4*x*" + w +
                 "+0.3*y-0.25*y*" + w + "+0.2*x^2*" + w + ")-1)"};
  s.box = {-2, 2, -2, 2, -2, 2};
  return s;
}

struct ProvenLines {
  std::vector<std::vector<Dash>> lines;  ///< in dashes no longer than the step
  std::vector<Dash> dashes;              ///< of all of them
};

ProvenLines proven_lines(double step) {
  const auto proven =
      smooth_ridges::smooth_ridges(experiments::make_surface(perturbed_torus()), {});
  if (!proven.certified) throw std::runtime_error("perturbed torus: not certified");
  ProvenLines all;
  for (const auto& ridge : proven.ridges) {
    const std::size_t n = ridge.points.size();
    std::vector<Dash> line;
    for (std::size_t i = 0; i + (ridge.loop ? 0 : 1) < n; ++i)
      add_dashes(ridge.points[i], ridge.points[(i + 1) % n], ridge.colour, step, line);
    all.dashes.insert(all.dashes.end(), line.begin(), line.end());
    all.lines.push_back(std::move(line));
  }
  return all;
}

std::vector<Dash> dashes_of(const ridges::Ridge& ridge, double step) {
  std::vector<Dash> all;
  for (std::size_t i = 0; i < ridge.segment_count(); ++i)
    add_dashes(ridge.crossings[i].point, ridge.crossings[(i + 1) % ridge.crossings.size()].point,
               ridge.colour, step, all);
  return all;
}

/// The ridges without any significant crossing; real: a proven line and this one are within the
/// tolerance of each other on nine tenths of their lengths.
struct Dropped {
  int count = 0, real = 0;
  double longest = 0;
};

Dropped dropped_whole(const ridges::RidgeGraph& graph, const ProvenLines& proven, double step,
                      double tolerance) {
  constexpr double kSame = 0.9;
  Dropped d;
  for (const ridges::Ridge& r : graph.ridges) {
    if (std::any_of(r.crossings.begin(), r.crossings.end(),
                    [](const ridges::Crossing& c) { return c.level > 0; }))
      continue;
    const std::vector<Dash> line = dashes_of(r, step);
    ++d.count;
    d.longest = std::max(d.longest, length_of(line));
    d.real += std::any_of(proven.lines.begin(), proven.lines.end(), [&](const auto& other) {
      return near_share(line, other, tolerance) >= kSame &&
             near_share(other, line, tolerance) >= kSame;
    });
  }
  return d;
}

double shortest(const ProvenLines& proven) {
  double least = 1e300;
  for (const auto& line : proven.lines) least = std::min(least, length_of(line));
  return least;
}

void run(const std::vector<int>& vertices, double tolerance) {
  constexpr double kStep = 0.005;
  const ProvenLines lines = proven_lines(kStep);
  const std::vector<Dash>& proven = lines.dashes;
  fmt::print(
      "proven length {:.2f}, shortest line {:.3f}; a line is real within {} of a proven one of its "
      "colour\n\n",
      length_of(proven), shortest(lines), tolerance);
  fmt::print(
      "| vertices | kept, real | kept, not real | dropped, real | dropped, not real | proven "
      "length "
      "met by kept lines | dropped whole: lines, real ones, longest "
      "|\n|---|---|---|---|---|---|---|\n");
  for (const int count : vertices) {
    const sampling::SurfaceSample s = sampling::sample("perturbed-torus", {}, count, false);
    const kernel::TriangleMesh mesh(s.points, s.faces);
    ridges::FitOptions options;
    options.errors = true;
    const ridges::FitResult fit = ridges::fit_monge_forms(mesh, options);
    ridges::RidgeGraph graph = ridges::extract_ridge_graph(mesh, fit.forms);
    ridges::mark_salience(mesh, fit, graph);
    const auto whole = dashes(graph, 0), kept = dashes(graph, 1);
    const double all_real = near_share(whole, proven, tolerance) * length_of(whole);
    const double kept_real = near_share(kept, proven, tolerance) * length_of(kept);
    const Dropped d = dropped_whole(graph, lines, kStep, tolerance);
    fmt::print("| {} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.3f} | {}, {}, {:.3f} |\n",
               mesh.vertex_count(), kept_real, length_of(kept) - kept_real, all_real - kept_real,
               length_of(whole) - all_real - (length_of(kept) - kept_real),
               near_share(proven, kept, tolerance), d.count, d.real, d.longest);
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace crest

int main(int argc, char** argv) {
  std::vector<int> vertices = {5000, 20000, 40000, 100000};
  double tolerance = 0.03;
  crest::experiments::Program program(
      "Dropped and kept ridges of a torus against its proven graph");
  program.list("--vertices", vertices, "of the meshes");
  program.option("--tolerance", tolerance, "distance within which lines are the same");
  return program.run(argc, argv, [&] {
    crest::kernel::require_sound_floating_point();
    crest::run(vertices, tolerance);
    return 0;
  });
}
