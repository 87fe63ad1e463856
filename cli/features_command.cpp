// SPDX-License-Identifier: GPL-3.0-or-later
// crest features: feature lines of a triangle mesh, with a certificate that thinning kept the
// topology.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>

#include "algorithms/curvature/curvature.hpp"
#include "algorithms/feature_lines/certificate.hpp"
#include "algorithms/feature_lines/feature_lines.hpp"
#include "algorithms/feature_lines/sharp_edges.hpp"
#include "algorithms/ridges/ridges.hpp"
#include "certify/certificate.hpp"
#include "cli/features_report.hpp"
#include "cli/one_of.hpp"
#include "cli/references.hpp"
#include "cli/run.hpp"
#include "io/features/feature_writer.hpp"
#include "io/page/scene.hpp"

namespace crest::cli {
namespace {

using feature_lines::FeatureGraph;
using feature_lines::FeatureLines;
using feature_lines::Neighbourhood;

struct FeaturesOptions {
  CommonOptions common;
  feature_lines::Options lines;
  std::string method = "fit", field, angle, patches;
  int rings = 0, over = 0;
  bool absolute = false;
  double value = 0;
  CLI::Option *quantile_given = nullptr, *value_given = nullptr, *rings_given = nullptr;
  std::vector<CLI::Option*> for_regions;  ///< that sharp edges have no use for

  /// Edges above an angle, not a region of vertices.
  bool sharp() const { return !angle.empty() && over == 0; }
};

CLI::Option* add_structure(CLI::App& app, const char* name, double& size, const char* help) {
  return app.add_option(name, size, help)->check(finite_number(0))->type_name("N");
}

std::string decimal_angle(const std::string& text) {
  try {
    kernel::DecimalAngle{text};
    return "";
  } catch (const std::invalid_argument& error) {
    return text + " " + error.what();
  }
}

void add_field_options(CLI::App& app, FeaturesOptions& o) {
  auto* quantile = o.quantile_given =
      app.add_option("--threshold", o.lines.quantile,
                     "mark the vertices from this quantile of the field on, and all of equal "
                     "value (default: 0.85, or a gap in the values that marks half to twice as "
                     "many)");
  quantile->check(CLI::Range(0.0, 1.0))->check(finite_number(0))->type_name("Q");
  o.value_given = app.add_option("--value", o.value, "mark where the field is at least V");
  o.value_given->check(finite_number(-HUGE_VAL))->type_name("V")->excludes(quantile);
  std::vector<std::string> methods = {"fit"};
  for (const curvature::Method m : curvature::kMethods)
    if (m != curvature::Method::np) methods.push_back(curvature::name_of(m));
  auto* method = app.add_option(
      "--method", o.method,
      "the field is max(|k1|, |k2|), curvatures by fit (default: a polynomial over several "
      "rings) or a method of crest curvature; ne keeps closest to sharp edges");
  method->check(CLI::IsMember(methods))->type_name("METHOD");
  o.rings_given = app.add_option("--rings", o.rings,
                                 "rings of neighbours of fit (default: until 30 points) or of "
                                 "normal-cycle (default 1)");
  o.rings_given->check(CLI::Range(0, 100))->type_name("N");
  auto* field =
      app.add_option("--field", o.field, "a scalar field of the file instead of a curvature");
  field->check([](const std::string& name) { return name.empty() ? "is empty" : std::string(); })
      ->type_name("NAME")
      ->excludes(method)
      ->excludes(o.rings_given);
  app.add_flag("--absolute", o.absolute, "take the field's absolute values")->needs(field);
  auto* angle = app.add_option("--angle", o.angle,
                               "sharp edges instead of a field: those whose faces' normals make an "
                               "angle above A degrees (a decimal, compared exactly)");
  angle->check(decimal_angle)->type_name("A");
  for (auto* other : {quantile, o.value_given, method, o.rings_given, field})
    angle->excludes(other);
  app.add_option("--over", o.over,
                 "for noisy meshes: mark the vertices of edges whose normals, summed over R rings "
                 "on each side, make an angle of at least A")
      ->check(CLI::Range(1, 100))
      ->type_name("R")
      ->needs(angle);
}

void add_features_options(CLI::App& app, FeaturesOptions& o) {
  static const std::map<std::string, Neighbourhood> kinds = {
      {"ring", Neighbourhood::rings},
      {"euclidean", Neighbourhood::euclidean},
      {"path", Neighbourhood::path},
      {"geodesic", Neighbourhood::geodesic}};
  const CLI::Range whole(0u, 1000000000u);
  add_field_options(app, o);
  o.for_regions = {add_structure(app, "--dilate", o.lines.dilate, "then dilate the marked region"),
                   add_structure(app, "--erode", o.lines.erode, "then erode it"),
                   add_structure(app, "--open", o.lines.open, "then open it (erode, dilate)"),
                   add_structure(app, "--close", o.lines.close, "then close it (dilate, erode)")};
  o.for_regions.push_back(
      app.add_option(
             "--neighbourhood", o.lines.neighbourhood,
             "what N of these four is: rings of neighbours (default), or a length in units of "
             "the input: Euclidean, along edge paths, or over the surface from the whole region")
          ->transform(one_of(kinds))
          ->type_name("ring|euclidean|path|geodesic"));
  app.add_option("--prune", o.lines.prune, "drop branches of at most M vertices (default 0)")
      ->check(whole)
      ->type_name("M");
  o.for_regions.push_back(
      app.add_option("--min-patch", o.lines.min_patch,
                     "fill patches of fewer than N vertices and thin again; the certificate is "
                     "then of this thinning, not of the first")
          ->check(whole)
          ->type_name("N"));
  app.add_option(
         "--close-branches", o.lines.close_branches,
         "join open ends at most N edges apart in one patch and thin again; the certificate "
         "is then of this thinning")
      ->check(whole)
      ->type_name("N");
  app.add_option("--patches", o.patches,
                 "the mesh with the number of its patch at each face (.vtp .ply)")
      ->type_name("FILE");
}

void check_options(FeaturesOptions& o) {
  if (o.value_given->count() > 0) o.lines.value = o.value;
  o.lines.seek_gap = o.quantile_given->count() == 0;
  if (o.sharp()) {
    for (const CLI::Option* option : o.for_regions)
      if (option->count() > 0)
        throw UsageError(option->get_name() +
                         " belongs to regions of vertices; with --angle give --over, too");
  }
  if (o.rings_given->count() > 0) {
    if (o.method != "fit" && o.method != "normal-cycle")
      throw UsageError("--rings belongs to fit and normal-cycle; " + o.method + " has none");
    if (o.method == "fit" && o.rings == 0) throw UsageError("--rings: fit needs at least one");
  }
  if (o.lines.neighbourhood != Neighbourhood::rings) return;
  for (const double size : {o.lines.dilate, o.lines.erode, o.lines.open, o.lines.close})
    if (size != std::floor(size))
      throw UsageError(fmt::format("{} rings are not a whole number; see --neighbourhood", size));
}

/// The larger absolute principal curvature of the fitted Monge forms.
std::vector<double> fitted_curvature(const kernel::TriangleMesh& mesh, int rings) {
  ridges::FitOptions options;
  options.rings = rings;
  std::vector<double> field;
  for (const kernel::MongeForm& form : ridges::fit_monge_forms(mesh, options).forms)
    field.push_back(std::max(std::fabs(form.k1), std::fabs(form.k2)));
  return field;
}

std::vector<double> estimated_curvature(const FeaturesOptions& o, const kernel::TriangleMesh& mesh,
                                        Run& run) {
  curvature::Options options;
  options.method = *curvature::method_of(o.method);
  if (o.rings_given->count() > 0) options.rings = o.rings;
  const curvature::Result result = curvature::estimate(mesh, options);
  if (result.undetermined > 0) {
    run.warn(
        fmt::format("{} vertices have no finite curvature; it is zero there", result.undetermined));
  }
  std::vector<double> field;
  for (const auto& c : result.vertices) field.push_back(std::max(std::fabs(c.k1), std::fabs(c.k2)));
  return field;
}

std::vector<double> field_of(const FeaturesOptions& o, const io::MeshFile& file, Run& run) {
  if (!o.angle.empty())
    return feature_lines::vertex_angles(file.mesh, static_cast<kernel::Index>(o.over));
  if (o.field.empty()) {
    return run.with_input([&] {
      return o.method == "fit" ? fitted_curvature(file.mesh, o.rings)
                               : estimated_curvature(o, file.mesh, run);
    });
  }
  std::vector<double> field = file.values;
  if (o.absolute)
    for (double& x : field) x = std::fabs(x);
  return field;
}

std::string field_name(const FeaturesOptions& o) {
  if (!o.angle.empty()) return "dihedral angle";
  return o.field.empty() ? "max(|k1|, |k2|)" : o.field;
}

void report_field(Report& report, const FeaturesOptions& o) {
  report["field"] = field_name(o);
  if (!o.angle.empty()) {
    report["angle"] = kernel::DecimalAngle(o.angle).degrees();
    report["over"] = o.over;
    return;
  }
  if (o.field.empty()) report["method"] = o.method;
}

std::vector<std::string> used_references(const FeaturesOptions& o) {
  std::vector<std::string> keys = {"roessl2005surfaces"};
  const char* method = o.field.empty() && o.angle.empty() ? curvature_reference(o.method) : nullptr;
  if (method) keys.push_back(method);
  if (o.lines.neighbourhood == Neighbourhood::geodesic) keys.push_back("kimmel1998computing");
  if (o.sharp()) keys = {"niven1956irrational"};
  if (!o.common.certificate.empty()) keys.push_back("mcconnell2011certifying");
  return keys;
}

void write_lines(Run& run, const FeaturesOptions& o, const kernel::TriangleMesh& mesh,
                 const FeatureGraph& graph, const std::vector<double>& field,
                 const Written& written, const std::string& digest) {
  run.write("-o",
            [&](const std::string& path) { io::write_features(path, mesh, graph, field, digest); });
  run.write("--patches",
            [&](const std::string& path) { io::write_patches(path, mesh, graph.face_patch); });
  run.write("--picture", [&](const std::string& path) {
    io::write_feature_picture(path, mesh, graph, o.sharp(), o.common.viewpoint,
                              legend_note(written.kind, written.by));
  });
  run.show_page([&] {
    io::Scene scene =
        io::feature_scene(mesh, graph, field_name(o), field, o.sharp(), o.common.viewpoint);
    scene.note = legend_note(written.kind, written.by);
    scene.data_digest = digest;
    return scene;
  });
  report_lines(run.report(), mesh, graph);
}

/// Fields whose lines say nothing about the shape.
void warn_of_flat_field(const FeaturesOptions& o, const kernel::TriangleMesh& mesh,
                        const std::vector<double>& field, Run& run) {
  const auto [least, most] = std::minmax_element(field.begin(), field.end());
  double extent = 0;
  for (const kernel::Vec3& p : mesh.points())
    for (std::size_t k = 0; k < 3; ++k)
      extent = std::max(extent, std::fabs(p[k] - mesh.points()[0][k]));
  const bool curvature = o.field.empty() && o.angle.empty();
  if (*least == *most)
    run.warn("the field has one value, so that no vertices stand out");
  else if (curvature && *most * extent < 0x1p-30)
    run.warn(
        fmt::format("the curvatures are zero but for rounding, at most {:.3g}, so that those which "
                    "stand out mean nothing; --angle finds sharp edges",
                    *most));
}

/// A region of vertices, thinned.
Outcome thin_region(Run& run, FeaturesOptions& o, const io::MeshFile& file) {
  const kernel::TriangleMesh& mesh = file.mesh;
  const std::vector<double> field =
      run.step("fit", "fitting curvatures", [&] { return field_of(o, file, run); });
  warn_of_flat_field(o, mesh, field, run);
  if (!o.angle.empty()) o.lines.value = kernel::DecimalAngle(o.angle).degrees();
  const FeatureLines f = run.step("extract", "thinning", [&] {
    return run.with_input(
        [&] { return feature_lines::extract_feature_lines(mesh, field, o.lines); });
  });
  const auto stated = feature_lines::make_certificate(mesh, f.thinning);
  const certify::Bytes certificate =
      run.step("certificate", "composing the certificate", [&] { return certify::encode(stated); });
  const std::string digest = certify::hex(certify::data_digest(certificate));
  const bool certifies = run.wanted("--certificate");
  run.step("write", "writing", [&] {
    write_lines(run, o, mesh, f.graph, field, written(f, certifies), digest);
    run.write_certificate("features-mesh", certificate);
  });
  report_region(run.report(), f, stated);
  run.report()["data_digest"] = digest;
  return {region_summary(f, certifies), used_references(o)};
}

Outcome find_sharp_edges(Run& run, const FeaturesOptions& o, const kernel::TriangleMesh& mesh) {
  const kernel::DecimalAngle angle(o.angle);
  const auto lines = run.step("extract", "comparing angles", [&] {
    return run.with_input([&] {
      return feature_lines::extract_sharp_lines(mesh, angle,
                                                {o.lines.prune, o.lines.close_branches});
    });
  });
  if (lines.ties > 0) {
    run.warn(
        fmt::format("edges of exactly {} degrees ({}) are not above it; a smaller --angle marks "
                    "them",
                    o.angle, lines.ties));
  }
  const auto stated = feature_lines::make_certificate(mesh, angle, lines);
  const certify::Bytes certificate =
      run.step("certificate", "composing the certificate", [&] { return certify::encode(stated); });
  const std::string digest = certify::hex(certify::data_digest(certificate));
  const bool certifies = run.wanted("--certificate");
  run.step("write", "writing", [&] {
    write_lines(run, o, mesh, lines.graph, feature_lines::vertex_angles(mesh, 0),
                written(lines, certifies), digest);
    run.write_certificate("sharp-edges", certificate);
  });
  report_sharp(run.report(), lines, stated);
  run.report()["data_digest"] = digest;
  return {sharp_summary(lines, o.angle, certifies), used_references(o)};
}

Outcome work(Run& run, FeaturesOptions& o) {
  io::MeshRequest request;
  if (!o.field.empty()) request.field = o.field;
  const io::MeshFile file = run.read_mesh(request);
  report_field(run.report(), o);
  return o.sharp() ? find_sharp_edges(run, o, file.mesh) : thin_region(run, o, file);
}

int run_features(FeaturesOptions& o) {
  check_options(o);
  return run_command(
      {"features", o.common, {".vtp", ".obj"}, {{"--patches", o.patches, {".vtp", ".ply"}}}},
      [&](Run& run) { return work(run, o); });
}

std::function<int()> add_features(CLI::App& app) {
  auto options = std::make_shared<FeaturesOptions>();
  add_common_options(app, options->common, fmt::format("mesh ({})", kMeshFormats),
                     "feature lines as polylines, with labelled mesh (.vtp .obj)");
  add_features_options(app, *options);
  add_clean_options(app, options->common.clean, true);
  add_step_option(app, options->common);
  return [options] { return run_features(*options); };
}

}  // namespace

extern const Command features_command;
const Command features_command = {
    "features",
    "feature lines of a triangle mesh",
    add_features,
    {"crest features ellipsoid.off --angle 10 --prune 2 -o edges.vtp --patches patches.vtp",
     "crest features ellipsoid.off --threshold 0.9 --close 1 --prune 4 -o features.vtp",
     "crest features ellipsoid.off --method ne --value 1.5 --certificate features.crest --picture "
     "features.svg --page features.html"}};

}  // namespace crest::cli
