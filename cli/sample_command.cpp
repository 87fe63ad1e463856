// SPDX-License-Identifier: GPL-3.0-or-later
// crest sample: meshes of surfaces with known answers, to try things on.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "algorithms/sampling/mesh_surface.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/outputs.hpp"
#include "cli/report.hpp"
#include "io/write/atomic_file.hpp"
#include "io/write/mesh_writer.hpp"

namespace crest::cli {
namespace {

struct SampleOptions {
  CommonOptions common;  ///< input is the surface's name
  std::vector<double> parameters;
  int vertices = 10000;
  bool rotate = false;
  double noise = 0;
  std::uint64_t seed = 1;
};

void add_sample_options(CLI::App& app, SampleOptions& o) {
  app.add_option("SURFACE", o.common.input, "one of the surfaces below")->required();
  app.add_option("-o,--output", o.common.output, "the mesh (.off .obj .ply .vtp)")
      ->required()
      ->type_name("FILE");
  app.add_option("--parameters", o.parameters, "the surface's parameters, separated by commas")
      ->delimiter(',')
      ->type_name("A,B,..");
  app.add_option("--vertices", o.vertices, "how many, nearly (default 10000)")
      ->check(CLI::Range(12, 100000000))
      ->type_name("N");
  app.add_flag("--rotate", o.rotate, "a generic pose and mesh instead of a symmetric one");
  app.add_option("--noise", o.noise,
                 "deviation along the normals as a share of the mean edge length (default 0)")
      ->check(CLI::Range(0.0, 10.0))
      ->type_name("F");
  app.add_option("--seed", o.seed, "of the noise (default 1)")->type_name("S");
  app.add_option("--report", o.common.report, "what is known about the surface (.json)")
      ->type_name("FILE");
  add_run_options(app, o.common);
  std::string surfaces = "Surfaces:";
  for (const std::string& line : sampling::list_surfaces()) surfaces += "\n  " + line;
  app.footer(surfaces);
}

sampling::SurfaceSample make_sample(const SampleOptions& o) {
  try {
    return sampling::sample(o.common.input, o.parameters, o.vertices, o.rotate);
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
}

void fill_report(Report& report, const SampleOptions& o, const sampling::SurfaceSample& sample) {
  Json& json = report.json();
  json["vertices"] = sample.points.size();
  json["faces"] = sample.faces.size();
  json["noise"] = o.noise;
  json["known"] = {{"euler_characteristic", sample.known.euler_characteristic},
                   {"boundary_loops", sample.known.boundary_loops}};
  if (sample.known.umbilics) {
    json["known"]["umbilics"] = {{"plus", sample.known.umbilics->plus},
                                 {"minus", sample.known.umbilics->minus}};
  }
}

int run_sample(const SampleOptions& o) {
  Outputs outputs;
  outputs.add("-o", o.common.output, {".off", ".obj", ".ply", ".vtp"});
  outputs.add("--report", o.common.report);
  const ThreadLimit limit(o.common.threads);
  Progress progress(o.common.quiet);
  Report report("sample", o.common.input, limit.threads());

  progress.show("sampling " + o.common.input);
  sampling::SurfaceSample sample = report.timed("sample", [&] { return make_sample(o); });
  if (o.noise > 0) {
    const double edge = sampling::mean_edge_length(sample.points, sample.faces);
    sampling::add_normal_noise(sample.points, sampling::normals(sample), o.noise * edge, o.seed);
  }
  progress.show("writing");
  report.timed("write", [&] {
    outputs.write(
        "-o", [&](const std::string& path) { io::write_mesh(path, sample.points, sample.faces); });
  });
  fill_report(report, o, sample);
  outputs.write("--report",
                [&](const std::string& path) { io::write_atomically(path, report.text()); });
  outputs.commit();
  progress.clear();
  if (!o.common.quiet) {
    const std::string text =
        fmt::format("{}: {} vertices, {} faces\ntime: {:.3g} s\n", o.common.output,
                    sample.points.size(), sample.faces.size(), report.elapsed());
    std::fputs(text.c_str(), stdout);
  }
  return kDone;
}

std::function<int()> add_sample(CLI::App& app) {
  auto options = std::make_shared<SampleOptions>();
  add_sample_options(app, *options);
  return [options] { return run_sample(*options); };
}

}  // namespace

extern const Command sample_command;
const Command sample_command = {
    "sample",
    "a mesh of a surface with known umbilics and ridges",
    add_sample,
    {"crest sample ellipsoid --parameters 1,1.5,2 --vertices 10000 -o ellipsoid.off",
     "crest sample blend --vertices 40000 --rotate --noise 0.01 -o blend.obj"}};

}  // namespace crest::cli
