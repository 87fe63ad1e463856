// SPDX-License-Identifier: GPL-3.0-or-later
// crest spline: splines of volumes and of scattered samples on type-6 tetrahedral partitions
// (paper 001, chapters 7 to 9).
#include <CLI/CLI.hpp>
#include <cmath>
#include <map>
#include <memory>

#include "cli/one_of.hpp"
#include "cli/run.hpp"
#include "cli/spline_cubic_run.hpp"
#include "cli/spline_options.hpp"
#include "cli/spline_volume_run.hpp"
#include "cli/volume_source.hpp"

namespace crest::cli {
namespace {

Outcome work(Run& run, const SplineOptions& o) {
  if (o.quadratic && o.cubic) throw UsageError("give --quadratic or --cubic, not both");
  if (o.evaluate.empty() != o.values.empty())
    throw UsageError("--evaluate (points in) and --values (out) go together");
  if (o.rays.empty() != o.hits.empty())
    throw UsageError("--rays (in) and --hits (out) go together");
  return o.cubic || (!o.quadratic && is_cubic_input(o.common.input)) ? run_cubic(run, o)
                                                                     : run_volume(run, o);
}

/// An option of numbers with commas between, as many as one of two counts says.
template <class Number>
CLI::Option* add_numbers(CLI::App& app, const char* name, std::vector<Number>& numbers,
                         std::array<std::size_t, 2> counts, const char* help, const char* type) {
  const auto take = [name, &numbers, counts](const std::string& text) {
    for (const std::string& word : CLI::detail::split(text, ',')) {
      Number x{};
      if (!CLI::detail::lexical_cast(word, x) || !std::isfinite(static_cast<double>(x)))
        throw CLI::ValidationError(name, "'" + word + "' is no number");
      numbers.push_back(x);
    }
    if (numbers.size() != counts[0] && numbers.size() != counts[1])
      throw CLI::ValidationError(name, text + " is not " + std::to_string(counts[0]) + " or " +
                                           std::to_string(counts[1]) + " numbers");
  };
  return app.add_option_function<std::string>(name, take, help)->type_name(type);
}

void add_volume_options(CLI::App& app, SplineOptions& o) {
  constexpr const char* group = "Volumes";
  app.add_flag("--quadratic", o.quadratic, "quadratic super splines (default for volumes)")
      ->group(group);
  app.add_option("--isovalue", o.isovalue, "of --rays, --picture, --mesh and --page")
      ->check(finite_number(-HUGE_VAL))
      ->type_name("C")
      ->group(group);
  app.add_option("--rays", o.rays, "cast these: ox,oy,oz,dx,dy,dz (.csv)")
      ->type_name("FILE")
      ->group(group);
  app.add_option("--hits", o.hits, "what --rays hit first (.csv)")->type_name("FILE")->group(group);
  app.add_option("--mesh", o.mesh, "the isosurface with proven topology (.vtp .obj .ply)")
      ->type_name("FILE")
      ->group(group);
  app.add_option("--max-depth", o.max_depth, "of the mesh's bisections (default 54)")
      ->check(CLI::Range(0, 54))
      ->type_name("D")
      ->group(group);
  add_numbers(app, "--camera", o.camera, {6, 7},
              "of --picture: eye, target, vertical angle in degrees (default 40)",
              "EX,EY,EZ,TX,TY,TZ[,A]")
      ->group(group);
  app.add_option("--size", o.size, "of --picture, in pixels (default 512)")
      ->check(CLI::Range(1, 16384))
      ->type_name("S")
      ->group(group);
  app.add_option_function<std::string>(
         "--border", [&o](const std::string& word) { o.extend = word == "extend"; },
         "none (default): the domain ends half a spacing inside the outermost samples' cells; "
         "extend: a layer of samples is added by linear extrapolation")
      ->check(CLI::IsMember({"none", "extend"}))
      ->type_name("WORD")
      ->group(group);
  add_volume_source(app, o.source, group);
}

void add_table_options(CLI::App& app, SplineOptions& o) {
  constexpr const char* group = "Tables of samples";
  app.add_flag("--cubic", o.cubic, "cubic splines (default for tables)")->group(group);
  const std::map<std::string, splines::Smoothness> words = {
      {"c1", splines::Smoothness::c1},
      {"local", splines::Smoothness::local},
      {"sequential", splines::Smoothness::sequential}};
  app.add_option("--smoothness", o.smoothness,
                 "c1: exactly (default); local: but for triangles inside cubes, one pass; "
                 "sequential: the thesis' extension")
      ->transform(one_of(words))
      ->type_name("WORD")
      ->group(group);
  add_numbers(app, "-n", o.cubes, {1, 3},
              "cubes along each axis (default: as many as give ten samples a cube)", "N|NX,NY,NZ")
      ->group(group);
  add_numbers(app, "--box", o.box, {2, 6}, "the domain (default: that of the samples; --box=-1,1)",
              "LO,HI|X0,X1,Y0,Y1,Z0,Z1")
      ->group(group);
  app.add_option("--columns", o.columns,
                 "names of the columns of x, y, z and the value (default: these)")
      ->delimiter(',')
      ->expected(4)
      ->type_name("A,B,C,D")
      ->group(group);
}

std::function<int()> add_spline(CLI::App& app) {
  auto options = std::make_shared<SplineOptions>();
  SplineOptions& o = *options;
  add_common_options(
      app, o.common,
      "a volume (.nrrd .mha .mhd .vti .pvti .vtk .nii .nii.gz .mrc .map .cube .inr), a table of "
      "samples x,y,z,value (.csv), or a saved spline (.vti)",
      "the spline (.vti)");
  app.add_option("--evaluate", o.evaluate, "points x,y,z to evaluate at (.csv)")->type_name("FILE");
  app.add_option("--values", o.values, "values and gradients there (.csv)")->type_name("FILE");
  add_volume_options(app, o);
  add_table_options(app, o);
  return [options] {
    return run_command({"spline",
                        options->common,
                        {".vti"},
                        {{"--values", options->values, {".csv"}},
                         {"--hits", options->hits, {".csv"}},
                         {"--mesh", options->mesh, {".vtp", ".obj", ".ply"}}}},
                       [&](Run& run) { return work(run, *options); });
  };
}

}  // namespace

extern const Command spline_command;
const Command spline_command = {
    "spline",
    "splines of volumes and of scattered samples, their isosurfaces by exact rays",
    add_spline,
    {"crest spline moebius.nrrd --isovalue 0.4 --picture surface.png --certificate rays.crest",
     "crest spline moebius.nrrd --isovalue 0.4 --mesh surface.vtp --report surface.json"}};

}  // namespace crest::cli
