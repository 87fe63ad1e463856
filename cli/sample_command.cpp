// SPDX-License-Identifier: GPL-3.0-or-later
// crest sample: meshes of surfaces with known answers, volumes, points, fields of tensors and plane
// fields of vectors, to try things on.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>
#include <optional>

#include "algorithms/sampling/loaded_block.hpp"
#include "algorithms/sampling/mesh_surface.hpp"
#include "algorithms/sampling/phantoms.hpp"
#include "algorithms/sampling/planar_fields.hpp"
#include "cli/run.hpp"
#include "io/write/mesh_writer.hpp"
#include "io/write/planar_field_writer.hpp"
#include "io/write/tet_writer.hpp"
#include "io/write/volume_writer.hpp"

namespace crest::cli {
namespace {

struct SampleOptions {
  CommonOptions common;  ///< input is the surface's name
  std::vector<double> parameters;
  std::optional<int> vertices;
  std::optional<int> nodes;
  bool rotate = false;
  double noise = 0;
  std::uint64_t seed = 1;
};

void add_sample_options(CLI::App& app, SampleOptions& o) {
  app.add_option("SURFACE", o.common.input, "one of the surfaces below")->required();
  app.add_option(
         "-o,--output", o.common.output,
         "the mesh (.off .obj .ply .vtp; of blocks and plane fields .vtu, volumes .nrrd .vti,\n"
         "points .xyz .pwn)")
      ->required()
      ->type_name("FILE");
  app.add_option("--parameters", o.parameters, "the surface's parameters, separated by commas")
      ->delimiter(',')
      ->type_name("A,B,..");
  app.add_option("--vertices", o.vertices, "how many, nearly (default 10000, of points 6000)")
      ->check(CLI::Range(12, 100000000))
      ->type_name("N");
  app.add_option("--nodes", o.nodes, "of a volume: along each axis (default 48)")
      ->check(CLI::Range(4, 2000))
      ->type_name("N");
  app.add_flag("--rotate", o.rotate, "a generic pose and mesh instead of a symmetric one");
  app.add_option("--noise", o.noise,
                 "deviation along the normals as a share of the mean edge length, of points in "
                 "their units (default 0)")
      ->check(CLI::Range(0.0, 10.0))
      ->type_name("F");
  app.add_option("--seed", o.seed, "of the noise, of a lattice field (default 1)")->type_name("S");
  app.add_option("--report", o.common.report, "what is known about the surface (.json)")
      ->type_name("FILE");
  add_run_options(app, o.common);
  std::string surfaces = "Surfaces:";
  for (const std::string& line : sampling::list_surfaces()) surfaces += "\n  " + line;
  for (const sampling::Scenario& s : sampling::scenarios())
    surfaces += fmt::format("\n  block-{}: the stress of an elastic block, {}, on tetrahedra",
                            s.name, s.summary);
  for (const sampling::Phantom& p : sampling::volume_phantoms())
    surfaces += fmt::format("\n  {}: a volume with a bright sheet, {}", p.name, p.summary);
  for (const sampling::Phantom& p : sampling::point_phantoms())
    surfaces += fmt::format("\n  {}: {}, with normals of random signs", p.name, p.summary);
  surfaces +=
      "\n  lattice N[,HOLE[,M]]: a plane vector field on N x N cells (default 40), without the "
      "middle "
      "if HOLE is 1, blended from M x M random vectors"
      "\n  twin-bodden, twin-skin: plane vector fields like those of paper 001, tables 5.1 and 5.2";
  app.footer(surfaces);
}

sampling::SurfaceSample make_sample(const SampleOptions& o) {
  try {
    // Noise goes along the forms' normals.
    const auto forms = o.noise > 0 ? sampling::Forms::exact : sampling::Forms::none;
    return sampling::sample(o.common.input, o.parameters, o.vertices.value_or(10000), o.rotate,
                            forms);
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
}

void fill_report(Report& report, const SampleOptions& o, const sampling::SurfaceSample& sample) {
  report["vertices"] = sample.points.size();
  report["faces"] = sample.faces.size();
  report["noise"] = o.noise;
  Json& known = report["known"];
  known["euler_characteristic"] = sample.known.euler_characteristic;
  known["boundary_loops"] = sample.known.boundary_loops;
  if (const auto& umbilics = sample.known.umbilics)
    known["umbilics"] = {{"plus", umbilics->plus}, {"minus", umbilics->minus}};
}

const sampling::Phantom* find_phantom(const std::vector<sampling::Phantom>& phantoms,
                                      const std::string& name) {
  for (const sampling::Phantom& p : phantoms)
    if (p.name == name) return &p;
  return nullptr;
}

void fill_report(Report& report, const sampling::Phantom& phantom) {
  report["known"] = {{"euler_characteristic", phantom.known.euler_characteristic},
                     {"boundary_loops", phantom.known.boundary_loops},
                     {"orientable", phantom.known.orientable}};
}

Outcome sample_volume(Run& run, const SampleOptions& o, const sampling::Phantom& phantom) {
  if (!o.parameters.empty() || o.noise > 0 || o.rotate || o.vertices)
    throw UsageError(o.common.input + ": takes --nodes alone");
  const int nodes = o.nodes.value_or(48);
  const auto grid = run.step("sample", "sampling " + phantom.name, [&] {
    return sampling::volume_phantom(phantom.name, static_cast<std::size_t>(nodes));
  });
  run.step("write", "writing", [&] {
    run.write("-o", [&](const std::string& path) { io::write_volume(path, grid); });
  });
  run.report()["nodes"] = grid.count();
  fill_report(run.report(), phantom);
  return {fmt::format("{}: {} x {} x {} samples\n", o.common.output, nodes, nodes, nodes)};
}

Outcome sample_points(Run& run, const SampleOptions& o, const sampling::Phantom& phantom) {
  if (!o.parameters.empty() || o.rotate)
    throw UsageError(o.common.input + ": takes --vertices, --noise and --seed alone");
  const auto sample = run.step("sample", "sampling " + phantom.name, [&] {
    return sampling::point_phantom(phantom.name, o.vertices.value_or(6000), o.noise, o.seed);
  });
  run.step("write", "writing", [&] {
    run.write("-o", [&](const std::string& path) {
      io::write_points(path, sample.points, sample.normals);
    });
  });
  run.report()["vertices"] = sample.points.size();
  run.report()["noise"] = o.noise;
  fill_report(run.report(), phantom);
  return {fmt::format("{}: {} points\n", o.common.output, sample.points.size())};
}

const sampling::Scenario* find_block(const std::string& name) {
  for (const sampling::Scenario& s : sampling::scenarios())
    if (name == "block-" + s.name) return &s;
  return nullptr;
}

Outcome sample_block(Run& run, const SampleOptions& o, const sampling::Scenario& scenario) {
  if (!o.parameters.empty() || o.noise > 0 || o.rotate)
    throw UsageError(o.common.input + ": takes --vertices alone");
  const double whole =
      (scenario.cubes[0] + 1.0) * (scenario.cubes[1] + 1.0) * (scenario.cubes[2] + 1.0);
  const auto loaded = run.step("sample", "loading " + o.common.input, [&] {
    return sampling::load_block(scenario, std::cbrt(o.vertices.value_or(10000) / whole));
  });
  const auto tets = loaded.block.tets();
  run.step("write", "writing", [&] {
    run.write("-o", [&](const std::string& path) {
      io::write_tets(path, sampling::points(loaded.block), tets, "stress", loaded.stress);
    });
  });
  run.report()["vertices"] = loaded.block.nodes();
  run.report()["tetrahedra"] = tets.size();
  return {fmt::format("{}: {} vertices, {} tetrahedra\n", o.common.output, loaded.block.nodes(),
                      tets.size())};
}

bool is_planar_field(const std::string& name) {
  return name == "lattice" || name == "twin-bodden" || name == "twin-skin";
}

/// Parameter i as an integer of a range.
int integer(const SampleOptions& o, std::size_t i, int fallback, int least, int most) {
  if (o.parameters.size() <= i) return fallback;
  const double x = o.parameters[i];
  if (!(x >= least && x <= most) || x != std::floor(x))
    throw UsageError(fmt::format("{}: parameter {} is no whole number from {} to {}",
                                 o.common.input, i + 1, least, most));
  return static_cast<int>(x);
}

Outcome sample_planar_field(Run& run, const SampleOptions& o) {
  const bool lattice = o.common.input == "lattice";
  if (o.noise > 0 || o.rotate || o.parameters.size() > (lattice ? 3 : 0))
    throw UsageError(o.common.input + (lattice ? ": takes --parameters N,HOLE,M and --seed alone"
                                               : ": takes no options"));
  const auto sample = run.step("sample", "sampling " + o.common.input, [&] {
    if (o.common.input == "twin-bodden") return sampling::twin_bodden();
    if (o.common.input == "twin-skin") return sampling::twin_skin();
    return sampling::lattice_field(o.seed, integer(o, 0, 40, 1, 20000), integer(o, 1, 0, 0, 1) == 1,
                                   integer(o, 2, 0, 0, 10000));
  });
  run.step("write", "writing", [&] {
    run.write("-o", [&](const std::string& path) {
      io::write_planar_field(path, sample.points, sample.triangles, "flow", sample.vectors);
    });
  });
  run.report()["vertices"] = sample.points.size();
  run.report()["triangles"] = sample.triangles.size();
  return {fmt::format("{}: {} vertices, {} triangles\n", o.common.output, sample.points.size(),
                      sample.triangles.size())};
}

Outcome work(Run& run, const SampleOptions& o) {
  const std::string& name = o.common.input;
  if (const auto* phantom = find_phantom(sampling::volume_phantoms(), name))
    return sample_volume(run, o, *phantom);
  if (o.nodes) throw UsageError(name + ": --nodes is for volumes");
  if (const auto* phantom = find_phantom(sampling::point_phantoms(), name))
    return sample_points(run, o, *phantom);
  if (is_planar_field(name)) return sample_planar_field(run, o);
  if (const auto* block = find_block(name)) return sample_block(run, o, *block);
  sampling::SurfaceSample sample =
      run.step("sample", "sampling " + o.common.input, [&] { return make_sample(o); });
  if (o.noise > 0) {
    const double edge = sampling::mean_edge_length(sample.points, sample.faces);
    sampling::add_normal_noise(sample.points, sampling::normals(sample), o.noise * edge, o.seed);
  }
  run.step("write", "writing", [&] {
    run.write("-o",
              [&](const std::string& path) { io::write_mesh(path, sample.points, sample.faces); });
  });
  fill_report(run.report(), o, sample);
  return {fmt::format("{}: {} vertices, {} faces\n", o.common.output, sample.points.size(),
                      sample.faces.size())};
}

std::function<int()> add_sample(CLI::App& app) {
  auto options = std::make_shared<SampleOptions>();
  add_sample_options(app, *options);
  return [options] {
    return run_command({"sample",
                        options->common,
                        {".off", ".obj", ".ply", ".vtp", ".vtu", ".nrrd", ".vti", ".xyz", ".pwn"}},
                       [&](Run& run) { return work(run, *options); });
  };
}

}  // namespace

extern const Command sample_command;
const Command sample_command = {
    "sample",
    "a mesh of a surface with known answers, a volume, points or a field of tensors or vectors",
    add_sample,
    {"crest sample ellipsoid --parameters 1,1.5,2 --vertices 10000 -o ellipsoid.off",
     "crest sample blend --vertices 40000 --rotate --noise 0.01 -o blend.obj",
     "crest sample block-twist --vertices 2000 -o stress.vtu",
     "crest sample moebius-sheet --nodes 48 -o moebius.nrrd",
     "crest sample moebius-points --vertices 3000 -o strip.xyz",
     "crest sample lattice --seed 5 -o lattice.vtu",
     "crest sample twin-bodden -o twin-bodden.vtu"}};

}  // namespace crest::cli
