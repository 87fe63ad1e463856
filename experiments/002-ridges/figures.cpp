// SPDX-License-Identifier: GPL-3.0-or-later
// Figures 1, 25, 26 and 27 of paper 002: pictures and the counts behind them. For the part of 37 k
// points stands a rocker arm, subdivided once to 40 k; for David a scan of 134 k.
#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <iostream>
#include <optional>

#include "algorithms/ridges/auto_scale.hpp"
#include "algorithms/sampling/mesh_surface.hpp"
#include "experiments/002-ridges/loop_subdivision.hpp"
#include "experiments/packed_mesh.hpp"
#include "experiments/peers/ridges/crest_run.hpp"
#include "experiments/program.hpp"
#include "io/ridges/ridge_picture.hpp"

namespace crest {
namespace {

namespace fs = std::filesystem;

struct Options {
  fs::path data = "../shared/data/meshes", out = "out/figures";
  double strength = 2, sharpness = 150, scan_sharpness = 1000;
};

struct Model {
  std::string name;
  kernel::TriangleMesh mesh;
  ridges::RidgeGraph graph;
  double seconds;
};

Model extract(const std::string& name, kernel::TriangleMesh mesh, bool chosen) {
  const auto start = std::chrono::steady_clock::now();
  ridges::FitOptions fit;
  if (chosen) fit.min_points = ridges::choose_support(mesh, fit).points;  // a scan
  const ridges::FitResult forms = ridges::fit_monge_forms(mesh, fit);
  ridges::RidgeGraph graph = ridges::extract_ridge_graph(mesh, forms.forms);
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  return {name, std::move(mesh), std::move(graph), time.count()};
}

Model sampled(const std::string& name, int vertices) {
  const sampling::SurfaceSample s = sampling::sample(name, {}, vertices, true);
  return extract(name, kernel::TriangleMesh(s.points, s.faces), false);
}

void figure(const std::string& label, const Model& model, const ridges::FilterOptions& filter,
            const Options& o, const std::string& note = {}) {
  ridges::RidgeGraph graph = model.graph;
  ridges::filter(graph, filter);
  const peers::CrestResult c = peers::count(graph);
  const std::string file =
      (o.out / ("figure-" + label + (note.empty() ? ".svg" : ".png"))).string();
  io::PictureOptions picture;
  picture.width = 900;
  picture.note = note;
  io::write_picture(file, model.mesh, graph, picture);
  fmt::print("| {} | {} | {} | {}, {} | {} + {} | {} + {} | {:.2f} | {} |\n", label, model.name,
             model.mesh.vertex_count(), c.plus, c.minus, c.blue.loops, c.blue.segments, c.red.loops,
             c.red.segments, model.seconds, file);
}

std::optional<kernel::TriangleMesh> scanned(const Options& o, const std::string& file) {
  const fs::path path = o.data / file;
  if (fs::exists(path))
    if (auto read = experiments::read_mesh(path.string())) return std::move(read->mesh);
  std::cerr << path.string() << ": not there (see --data), or no xz: figure skipped\n";
  return std::nullopt;
}

void run(const Options& o) {
  fs::create_directories(o.out);
  fmt::print(
      "| figure | model | vertices | umbilics +1/2, -1/2 | blue loops + segments | red | seconds | "
      "picture |\n|---|---|---|---|---|---|---|---|\n");
  figure("1", sampled("ellipsoid", 10000), {}, o);
  figure("25", sampled("blend", 40000), {}, o);
  ridges::FilterOptions crest, strong, sharp;
  crest.crest_only = strong.crest_only = sharp.crest_only = true;
  strong.min_strength = o.strength;
  sharp.min_sharpness = o.sharpness;
  const std::string by = "subset by --crest-only";
  if (const auto mesh = scanned(o, "rocker-arm.obj")) {
    const Model part =
        extract("rocker-arm.obj, subdivided", experiments::loop_subdivision(*mesh), false);
    figure("26-a", part, crest, o, by);
    figure("26-b", part, strong, o, by + ", --min-strength");
    figure("26-c", part, sharp, o, by + ", --min-sharpness");
  }
  sharp.min_sharpness = o.scan_sharpness;
  if (auto mesh = scanned(o, "igea.ply.xz"))
    figure("27", extract("igea.ply.xz", std::move(*mesh), true), sharp, o,
           by + ", --min-sharpness");
}

}  // namespace
}  // namespace crest

int main(int argc, char** argv) {
  crest::Options o;
  crest::experiments::Program program("Figures 1, 25, 26 and 27 of paper 002");
  program.option("--data", o.data,
                 "folder of rocker-arm.obj and igea.ply.xz (default "
                 "../shared/data/meshes)");
  program.option("--out", o.out, "folder for the pictures (default out/figures)");
  program.option("--min-strength", o.strength, "of figure 26b");
  program.option("--min-sharpness", o.sharpness, "of figure 26c");
  program.option("--scan-sharpness", o.scan_sharpness, "of figure 27");
  return program.run(argc, argv, [&] {
    crest::run(o);
    return 0;
  });
}
