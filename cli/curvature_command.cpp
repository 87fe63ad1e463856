// SPDX-License-Identifier: GPL-3.0-or-later
// crest curvature: the curvature tensor of a mesh by the methods of paper 001, section 3.3.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "algorithms/curvature/curvature.hpp"
#include "algorithms/curvature/focal.hpp"
#include "algorithms/sampling/surfaces.hpp"
#include "cli/mesh_workers.hpp"
#include "cli/references.hpp"
#include "cli/run.hpp"
#include "io/curvature/curvature_picture.hpp"
#include "io/curvature/curvature_writer.hpp"
#include "io/formats/files.hpp"
#include "io/page/scene.hpp"
#include "kernel/geometry/parallel.hpp"

namespace crest::cli {
namespace {

using curvature::PointCurvature;
using kernel::TriangleMesh;

struct CurvatureOptions {
  CommonOptions common;
  curvature::Options estimate;
  std::string method = "ne", normals, colour = "H", focal, focal_picture, reference;
  double focal_share = 0.1;
  bool focal_averaged = false, rotate = false, corners = false;
  std::vector<double> parameters;
};

void add_options(CLI::App& app, CurvatureOptions& o) {
  app.add_option("INPUT", o.common.input, fmt::format("mesh ({})", kMeshFormats))->required();
  app.add_option("-o,--output", o.common.output,
                 "the mesh with its curvatures (.vtp .pvtp .vtu .pvtu .ply)")
      ->type_name("FILE");
  std::vector<std::string> names;
  for (const curvature::Method m : curvature::kMethods) names.push_back(curvature::name_of(m));
  app.add_option("--method", o.method, "default ne: normal-based, normals estimated")
      ->check(CLI::IsMember(names));
  app.add_option("--normals", o.normals,
                 "the file's, estimated ones, or the gradient of --reference")
      ->check(CLI::IsMember({"file", "estimated", "gradient"}));
  app.add_option("--degree", o.estimate.degree, "of jet's polynomial (default 4)")
      ->check(CLI::Range(2, 6))
      ->type_name("N");
  app.add_option("--rings", o.estimate.rings, "of normal-cycle's region (default 1)")
      ->check(CLI::Range(0, 20))
      ->type_name("N");
  app.add_option("--focal", o.focal, "focal surfaces of K and H (.vtp)")->type_name("FILE");
  app.add_option(
         "--focal-picture", o.focal_picture,
         "curves of the focal surface of H (of K with --colour K) over the mesh (.svg .png)")
      ->type_name("FILE");
  app.add_option("--focal-share", o.focal_share,
                 "their height as a share of the bounding box's diagonal (default 0.1)")
      ->check(CLI::Range(1e-6, 10.0))
      ->type_name("F");
  app.add_flag("--focal-averaged", o.focal_averaged,
               "focal surfaces of the vertex means, not of independent triangles (np, ne)");
  app.add_option("--picture", o.common.picture, "the mesh in colours of a curvature (.svg .png)")
      ->type_name("FILE");
  app.add_flag("--corners", o.corners,
               "the tensors at the corners of each triangle, too (np, ne; .vtp .vtu)");
  add_view_options(app, o.common.viewpoint);
  add_page_option(app, o.common);
  app.add_option("--colour", o.colour, "what the picture shows (default H)")
      ->check(CLI::IsMember({"K", "H", "k1", "k2"}));
  app.add_option("--reference", o.reference,
                 "compare with a surface of `crest sample`: the report has the distances")
      ->type_name("SURFACE");
  app.add_option("--parameters", o.parameters, "the surface's parameters, separated by commas")
      ->delimiter(',')
      ->type_name("A,B,..");
  app.add_flag("--rotate", o.rotate, "the surface was sampled with --rotate");
  app.add_option("--report", o.common.report, "curvatures and times (.json)")->type_name("FILE");
  app.add_flag("--cite", o.common.cite, "print the references this run used (BibTeX)");
  add_run_options(app, o.common);
  add_clean_options(app, o.common.clean, true);
}

std::optional<sampling::Surface> reference_of(const CurvatureOptions& o) {
  if (o.reference.empty()) {
    if (!o.parameters.empty() || o.rotate)
      throw UsageError("--parameters and --rotate belong to --reference");
    return std::nullopt;
  }
  try {
    return sampling::make_surface(o.reference, o.parameters, o.rotate);
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
}

void check_corners(const CurvatureOptions& o) {
  if (!o.corners) return;
  if (o.estimate.method != curvature::Method::np && o.estimate.method != curvature::Method::ne)
    throw UsageError("--corners belongs to --method np and ne");
  if (io::lower_extension(o.common.output) == ".ply")
    throw UsageError("--corners: .ply has no place for them, write .vtp or .vtu");
}

/// The normals option, its default by the method, against what is there.
std::string normals_source(const CurvatureOptions& o) {
  const bool perfect = o.estimate.method == curvature::Method::np;
  if (!o.normals.empty()) {
    if (perfect && o.normals == "estimated")
      throw UsageError("--normals estimated: with these np is ne; say --method ne");
    if (o.estimate.method == curvature::Method::ne && o.normals != "estimated")
      throw UsageError("--normals " + o.normals + ": ne estimates them; say --method np");
    if (o.normals == "gradient" && o.reference.empty())
      throw UsageError("--normals gradient needs --reference");
    return o.normals;
  }
  if (!perfect) return "estimated";
  return o.reference.empty() ? "file" : "gradient";
}

std::vector<kernel::Vec3> given_normals(const std::string& source, const io::MeshFile& file,
                                        const std::optional<sampling::Surface>& surface) {
  if (source != "gradient") return file.normals;
  std::vector<kernel::Vec3> normals;
  for (const kernel::Vec3& p : file.mesh.points())
    normals.push_back(sampling::to_vec3(surface->gradient(sampling::to_point(p)).gradient));
  return normals;
}

std::vector<PointCurvature> exact_curvatures(const TriangleMesh& mesh,
                                             const sampling::Surface& surface) {
  std::vector<PointCurvature> exact;
  try {
    for (const kernel::Vec3& p : mesh.points()) {
      const auto foot = sampling::to_vec3(surface.project(sampling::to_point(p)));
      const kernel::MongeForm form = surface.monge_form(foot);
      PointCurvature c;
      c.k1 = form.k1;
      c.k2 = form.k2;
      c.K = form.k1 * form.k2;
      c.H = 0.5 * (form.k1 + form.k2);
      c.d1 = form.d1;
      c.d2 = kernel::minimal_direction(form);
      exact.push_back(c);
    }
  } catch (const std::invalid_argument&) {
    throw UsageError("--reference: the mesh does not lie on this surface");
  }
  return exact;
}

struct Spread {
  double min, median, max;
};

Spread spread_of(const std::vector<PointCurvature>& vertices, double PointCurvature::*member) {
  std::vector<double> values;
  values.reserve(vertices.size());
  for (const PointCurvature& c : vertices) values.push_back(c.*member);
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  return {*std::min_element(values.begin(), middle + 1), *middle,
          *std::max_element(middle, values.end())};
}

constexpr std::pair<const char*, double PointCurvature::*> kQuantities[] = {
    {"k1", &PointCurvature::k1},
    {"k2", &PointCurvature::k2},
    {"K", &PointCurvature::K},
    {"H", &PointCurvature::H},
    {"asymmetry", &PointCurvature::asymmetry}};

using Spreads = std::array<Spread, std::size(kQuantities)>;

Spreads spreads_of(const std::vector<PointCurvature>& vertices) {
  Spreads spreads{};
  kernel::parallel_for(std::size_t{0}, spreads.size(), [&](std::size_t i) {
    spreads[i] = spread_of(vertices, kQuantities[i].second);
  });
  return spreads;
}

void fill_report(Report& report, const CurvatureOptions& o, const TriangleMesh& mesh,
                 const curvature::Result& result, const Spreads& spreads,
                 const std::string& source) {
  report["vertices"] = mesh.vertex_count();
  report["faces"] = mesh.face_count();
  report["method"] = o.method;
  report["normals"] = source;
  for (std::size_t i = 0; i < spreads.size(); ++i) {
    const auto& [min, median, max] = spreads[i];
    report[kQuantities[i].first] = {{"min", min}, {"median", median}, {"max", max}};
  }
  report["lowered"] = result.lowered;
  report["complex"] = result.complex;
  report["undetermined"] = result.undetermined;
  if (result.undetermined > 0) {
    report.warn(
        fmt::format("{} vertices have no finite estimate and are zero", result.undetermined));
  }
}

std::vector<curvature::FocalSurface> focal_surfaces(const CurvatureOptions& o,
                                                    const io::MeshFile& file,
                                                    const curvature::Result& result) {
  const TriangleMesh& mesh = file.mesh;
  const bool triangles = !o.focal_averaged && (o.estimate.method == curvature::Method::np ||
                                               o.estimate.method == curvature::Method::ne);
  std::vector<curvature::FocalSurface> surfaces;
  for (const auto q : {curvature::Quantity::gaussian, curvature::Quantity::mean}) {
    surfaces.push_back(triangles
                           ? curvature::focal_of_triangles(mesh, result.normals, q, o.focal_share)
                           : curvature::focal_of_vertices(mesh, result, q, o.focal_share));
    for (kernel::Index& face : surfaces.back().faces)
      face = static_cast<kernel::Index>(file.numbers.face(face));
  }
  return surfaces;
}

void write_picture(const std::string& path, const CurvatureOptions& o, const TriangleMesh& mesh,
                   const curvature::Result& result) {
  const std::pair<const char*, double PointCurvature::*> shown =
      o.colour == "K"    ? std::pair{"gaussian curvature", &PointCurvature::K}
      : o.colour == "k1" ? std::pair{"larger principal curvature", &PointCurvature::k1}
      : o.colour == "k2" ? std::pair{"smaller principal curvature", &PointCurvature::k2}
                         : std::pair{"mean curvature", &PointCurvature::H};
  std::vector<double> values;
  for (const PointCurvature& c : result.vertices) values.push_back(c.*shown.second);
  io::ColourPicture picture;
  picture.label = shown.first;
  picture.view = o.common.viewpoint.view;
  picture.up = o.common.viewpoint.up;
  io::write_colour_picture(path, mesh, values, picture);
}

std::string summary_text(const CurvatureOptions& o, const TriangleMesh& mesh,
                         const Spreads& spreads) {
  std::string text =
      fmt::format("{}: {} vertices, {} faces\n", o.method, mesh.vertex_count(), mesh.face_count());
  for (std::size_t i = 0; i + 1 < spreads.size(); ++i) {  // all but the asymmetry
    const auto& [min, median, max] = spreads[i];
    text += fmt::format("{}: {:.6g} to {:.6g}, median {:.6g}\n", kQuantities[i].first, min, max,
                        median);
  }
  return text;
}

/// Into the report; returns the line for the terminal.
std::string compare(Run& run, const CurvatureOptions& o, const TriangleMesh& mesh,
                    const curvature::Result& result, const sampling::Surface& surface) {
  const auto distances = run.step("reference", "comparing", [&] {
    return curvature::distances(result.vertices, exact_curvatures(mesh, surface));
  });
  run.report()["dist_K"] = distances.K;
  run.report()["dist_H"] = distances.H;
  run.report()["dist_P"] = distances.P;
  return fmt::format("distance from {}: K {:.4g}, H {:.4g}, directions {:.4g}\n", o.reference,
                     distances.K, distances.H, distances.P);
}

void write_results(Run& run, const CurvatureOptions& o, const io::MeshFile& file,
                   const curvature::Result& result) {
  const TriangleMesh& mesh = file.mesh;
  run.write("-o", [&](const std::string& path) {
    io::write_curvature(path, mesh, result,
                        o.corners ? curvature::corner_curvatures(mesh, result.normals)
                                  : std::vector<curvature::CornerCurvatures>{});
  });
  std::vector<curvature::FocalSurface> focal;
  if (run.wanted("--focal") || run.wanted("--focal-picture")) {
    focal = focal_surfaces(o, file, result);
    run.write("--focal", [&](const std::string& path) { io::write_focal(path, focal); });
    run.write("--focal-picture", [&](const std::string& path) {
      io::ColourPicture picture;
      const bool gaussian = o.colour == "K";
      picture.label = gaussian ? "gaussian curvature" : "mean curvature";
      picture.view = o.common.viewpoint.view;
      picture.up = o.common.viewpoint.up;
      io::write_focal_picture(path, mesh, focal[gaussian ? 0 : 1], picture);
    });
  }
  run.write("--picture", [&](const std::string& path) { write_picture(path, o, mesh, result); });
  run.show_page([&] {
    return io::curvature_scene(mesh, result, o.colour, focal,
                               {"", 1200, o.common.viewpoint.view, o.common.viewpoint.up});
  });
}

Outcome work(Run& run, CurvatureOptions& o, const std::string& source,
             const std::optional<sampling::Surface>& surface) {
  io::MeshRequest request;
  request.normals = source == "file";
  const io::MeshFile file = run.read_mesh(request);
  const TriangleMesh& mesh = file.mesh;
  o.estimate.normals = given_normals(source, file, surface);
  const curvature::Result result = run.step("estimate", "estimating curvatures", [&] {
    return run.with_input(
        [&] { return curvature::estimate(mesh, o.estimate, mesh_workers().curvature); });
  });
  const Spreads spreads = spreads_of(result.vertices);
  fill_report(run.report(), o, mesh, result, spreads, source);
  std::string summary = summary_text(o, mesh, spreads);
  if (surface) summary += compare(run, o, mesh, result, *surface);
  run.step("write", "writing", [&] { write_results(run, o, file, result); });
  std::vector<std::string> references = {"roessl2005surfaces"};
  if (const char* key = curvature_reference(o.method)) references.push_back(key);
  return {summary, references};
}

int run(CurvatureOptions& o) {
  o.estimate.method = *curvature::method_of(o.method);
  check_corners(o);
  const std::string source = normals_source(o);
  const std::optional<sampling::Surface> surface = reference_of(o);
  return run_command(
      {"curvature",
       o.common,
       {".vtp", ".pvtp", ".vtu", ".pvtu", ".ply"},
       {{"--focal", o.focal, {".vtp"}}, {"--focal-picture", o.focal_picture, {".svg", ".png"}}}},
      [&](Run& run) { return work(run, o, source, surface); });
}

std::function<int()> add_curvature(CLI::App& app) {
  auto options = std::make_shared<CurvatureOptions>();
  add_options(app, *options);
  return [options] { return run(*options); };
}

}  // namespace

extern const Command curvature_command;
const Command curvature_command = {
    "curvature",
    "the curvature tensor of a triangle mesh, by seven methods",
    add_curvature,
    {"crest curvature ellipsoid.off -o ellipsoid-curvature.vtp --picture ellipsoid-curvature.png "
     "--page ellipsoid-curvature.html",
     "crest curvature ellipsoid.off --method cf --reference ellipsoid --parameters 1,1.5,2 "
     "--report ellipsoid-curvature.json"}};

}  // namespace crest::cli
