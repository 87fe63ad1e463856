// SPDX-License-Identifier: GPL-3.0-or-later
// What noise does to the ridges of the ellipsoid 1, 1.5, 2: CGAL and Crest with 30 points, then
// both with the support that --scale auto chooses. The right answer is 4 umbilics of index +1/2,
// index sum 2, 1 loop + 2 segments a colour.
#include <fmt/format.h>

#include "algorithms/ridges/auto_scale.hpp"
#include "algorithms/sampling/mesh_surface.hpp"
#include "experiments/peers/ridges/cgal_peer.hpp"
#include "experiments/peers/ridges/crest_run.hpp"
#include "experiments/program.hpp"

namespace crest {
namespace {

struct Options {
  int vertices = 10000;
  std::vector<double> percent = {0, 0.1, 0.3, 1, 3};
  int seeds = 3;
  int smooth = 0;
  double sharpness = 0;
  double umbilic_size = 3;
  bool without_cgal = false;
};

struct Row {
  std::string system;
  int plus, minus, other;
  double index_sum;
  std::string blue, red;
  int ends;
  int points;  ///< of a support, at least
};

void print(const Row& r, double percent, int seed) {
  fmt::print("| {} | {} | {} | {}, {}, {} | {} | {} | {} | {} | {} |\n", percent, seed, r.system,
             r.plus, r.minus, r.other, r.index_sum, r.blue, r.red, r.ends, r.points);
}

Row cgal(const kernel::TriangleMesh& mesh, const Options& o, int points) {
  peers::CgalOptions options;
  options.min_points = static_cast<std::size_t>(points);
  options.umbilic_size = o.umbilic_size;
  const peers::CgalResult r = peers::run_cgal(mesh, options);
  const auto text = [](const peers::MergedLines& m) {
    return fmt::format("{} + {}", m.loops, m.components - m.loops);
  };
  return {"CGAL",
          r.plus,
          r.minus,
          r.other,
          r.index_sum(),
          text(r.blue_lines),
          text(r.red_lines),
          r.blue_lines.open_ends + r.red_lines.open_ends,
          points};
}

Row crest_row(const kernel::TriangleMesh& mesh, const Options& o, int points) {
  const bool auto_scale = points > 0;
  ridges::FitOptions options;
  if (auto_scale) {
    options.smooth = o.smooth;
    options.min_points = points;
  }
  const ridges::FitResult fit = ridges::fit_monge_forms(mesh, options);
  ridges::RidgeGraph graph = ridges::extract_ridge_graph(mesh, fit.forms);
  const peers::CrestResult all = peers::count(graph);
  ridges::FilterOptions filter;
  filter.min_sharpness = o.sharpness;
  ridges::filter(graph, filter);
  const peers::CrestResult kept = peers::count(graph);
  const auto text = [&](const peers::CrestResult::Ridges& a, const peers::CrestResult::Ridges& k) {
    std::string s = fmt::format("{} + {}", a.loops, a.segments);
    if (o.sharpness > 0) s += fmt::format(" (kept {} + {})", k.loops, k.segments);
    return s;
  };
  std::string name = auto_scale ? "Crest --scale auto" : "Crest";
  if (auto_scale && o.smooth > 0) name += fmt::format(" --smooth {}", o.smooth);
  return {name,
          all.plus,
          all.minus,
          all.other,
          all.index_sum,
          text(all.blue, kept.blue),
          text(all.red, kept.red),
          all.open_ends,
          options.min_points};
}

void run(const Options& o) {
  const sampling::SurfaceSample clean =
      sampling::sample("ellipsoid", {1, 1.5, 2}, o.vertices, true);
  const double edge = sampling::mean_edge_length(clean.points, clean.faces);
  fmt::print("Ellipsoid 1, 1.5, 2; {} vertices; noise along the normals, % of the mean edge\n\n",
             clean.points.size());
  fmt::print(
      "| noise % | seed | system | umbilics +1/2, -1/2, other | index sum | blue loops + segments "
      "| "
      "red loops + segments | unjoined ends | points of a support |\n"
      "|---|---|---|---|---|---|---|---|---|\n");
  for (const double percent : o.percent)
    for (int seed = 1; seed <= (percent == 0 ? 1 : o.seeds); ++seed) {
      std::vector<sampling::Vec3> points = clean.points;
      sampling::add_normal_noise(points, sampling::normals(clean), percent / 100 * edge,
                                 static_cast<std::uint64_t>(seed));
      const kernel::TriangleMesh mesh(std::move(points), clean.faces);
      ridges::FitOptions fit;
      fit.smooth = o.smooth;
      const int chosen = ridges::choose_support(mesh, fit).points;
      if (!o.without_cgal) print(cgal(mesh, o, 30), percent, seed);
      print(crest_row(mesh, o, 0), percent, seed);
      if (!o.without_cgal) print(cgal(mesh, o, chosen), percent, seed);
      print(crest_row(mesh, o, chosen), percent, seed);
    }
}

}  // namespace
}  // namespace crest

int main(int argc, char** argv) {
  crest::Options o;
  crest::experiments::Program program(
      "Ridges of a noisy ellipsoid: CGAL, Crest, Crest with automatic scale");
  program.option("--vertices", o.vertices, "of the mesh (default 10000)");
  program.list("--noise", o.percent, "percents of the mean edge length");
  program.option("--seeds", o.seeds, "noisy meshes a level (default 3)");
  program.option("--smooth", o.smooth, "smoothing steps with --scale auto (default 0)");
  program.option("--min-sharpness", o.sharpness,
                 "also count Crest's ridges above it (default off)");
  program.option("--umbilic-size", o.umbilic_size, "CGAL's umbilic patch size (default 3)");
  program.flag("--without-cgal", o.without_cgal, "Crest only");
  return program.run(argc, argv, [&] {
    crest::run(o);
    return 0;
  });
}
