// SPDX-License-Identifier: GPL-3.0-or-later
// crest features: feature lines of a triangle mesh, with a certificate that thinning kept the
// topology.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "algorithms/curvature/curvature.hpp"
#include "algorithms/feature_lines/certificate.hpp"
#include "algorithms/feature_lines/feature_lines.hpp"
#include "algorithms/ridges/ridges.hpp"
#include "certify/certificate.hpp"
#include "cli/references.hpp"
#include "cli/run.hpp"
#include "io/features/feature_writer.hpp"

namespace crest::cli {
namespace {

using feature_lines::FeatureLines;
using feature_lines::LineKind;
using feature_lines::Neighbourhood;

struct FeaturesOptions {
  CommonOptions common;
  feature_lines::Options lines;
  std::string method = "fit", field;
  int rings = 0;
  bool absolute = false;
  double value = 0;
  CLI::Option *value_given = nullptr, *rings_given = nullptr;
};

void add_structure(CLI::App& app, const char* name, double& size, const char* help) {
  app.add_option(name, size, help)->check(finite_number(0))->type_name("N");
}

void add_field_options(CLI::App& app, FeaturesOptions& o) {
  auto* quantile =
      app.add_option("--threshold", o.lines.quantile,
                     "mark the vertices from this quantile of the field on (default 0.85)");
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
}

void add_features_options(CLI::App& app, FeaturesOptions& o) {
  static const std::map<std::string, Neighbourhood> kinds = {
      {"ring", Neighbourhood::rings},
      {"euclidean", Neighbourhood::euclidean},
      {"path", Neighbourhood::path},
      {"geodesic", Neighbourhood::geodesic}};
  const CLI::Range whole(0u, 1000000000u);
  add_field_options(app, o);
  add_structure(app, "--dilate", o.lines.dilate, "then dilate the marked region");
  add_structure(app, "--erode", o.lines.erode, "then erode it");
  add_structure(app, "--open", o.lines.open, "then open it (erode, dilate)");
  add_structure(app, "--close", o.lines.close, "then close it (dilate, erode)");
  app.add_option(
         "--neighbourhood", o.lines.neighbourhood,
         "what N of these four is: rings of neighbours (default), or a length in units of "
         "the input: Euclidean, along edge paths, or over the surface from the whole region")
      ->transform(CLI::CheckedTransformer(kinds))
      ->type_name("ring|euclidean|path|geodesic");
  app.add_option("--prune", o.lines.prune, "drop branches of at most M vertices (default 0)")
      ->check(whole)
      ->type_name("M");
  app.add_option("--min-patch", o.lines.min_patch,
                 "fill patches of fewer than N vertices and thin again; the certificate is then "
                 "of this thinning, not of the first")
      ->check(whole)
      ->type_name("N");
  app.add_option(
         "--close-branches", o.lines.close_branches,
         "join open ends at most N edges apart in one patch and thin again; the certificate "
         "is then of this thinning")
      ->check(whole)
      ->type_name("N");
}

void check_options(FeaturesOptions& o) {
  if (o.value_given->count() > 0) o.lines.value = o.value;
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

Json betti_json(const feature_lines::Topology& t) {
  const auto one = [](const feature_lines::Betti& b) {
    return Json{{"euler_characteristic", b.euler},
                {"components", b.b0},
                {"loops", b.b1},
                {"closed_surfaces", b.b2}};
  };
  return {{"marked", one(t.marked)}, {"complement", one(t.complement)}};
}

Json lengths_json(const feature_lines::FeatureGraph& graph) {
  std::array<double, 4> length{};
  for (const auto& line : graph.lines) length[static_cast<std::size_t>(line.kind)] += line.length;
  return {
      {"arcs", length[0]}, {"branches", length[1]}, {"loops", length[2]}, {"isolated", length[3]}};
}

void fill_report(Report& report, const FeaturesOptions& o, const kernel::TriangleMesh& mesh,
                 const FeatureLines& f, const std::string& digest) {
  report["vertices"] = mesh.vertex_count();
  report["faces"] = mesh.face_count();
  report["euler_characteristic"] = mesh.euler_characteristic();
  report["boundary_loops"] = mesh.boundary_loops();
  report["field"] = o.field.empty() ? "max(|k1|, |k2|)" : o.field;
  if (o.field.empty()) report["method"] = o.method;
  report["threshold"] = f.value;
  report["marked"] = f.marked;
  report["line_vertices"] = feature_lines::count(f.marks);
  report["nodes"] = f.graph.nodes.size();
  report["arcs"] = f.graph.count(LineKind::arc);
  report["branches"] = f.graph.count(LineKind::branch);
  report["loops"] = f.graph.count(LineKind::loop);
  report["isolated"] = f.graph.count(LineKind::isolated);
  report["patches"] = f.graph.patch_sizes.size();
  report["length"] = lengths_json(f.graph);
  report["filled_patches"] = f.filled_patches;
  report["joined_ends"] = f.joined;
  report["thinnings"] = f.thinnings;
  report["thinned"] = feature_lines::count(f.thinning.before);
  report["dropped_lines"] = f.thinning.dropped.size();
  report["betti_before"] = betti_json(f.thinning.topology_before);
  report["betti_after"] = betti_json(f.thinning.topology_after);
  report["data_digest"] = digest;
}

std::string summary_text(const FeatureLines& f) {
  const auto& b = f.thinning.topology_after;
  const std::string which =
      f.thinnings == 1 ? "" : fmt::format("the last of {} rounds of ", f.thinnings);
  return fmt::format("region: {} of {} vertices from {:.6g} on\n", f.marked, f.marks.size(),
                     f.value) +
         fmt::format("lines: {} arcs, {} branches, {} loops, {} isolated; {} nodes, {} patches\n",
                     f.graph.count(LineKind::arc), f.graph.count(LineKind::branch),
                     f.graph.count(LineKind::loop), f.graph.count(LineKind::isolated),
                     f.graph.nodes.size(), f.graph.patch_sizes.size()) +
         fmt::format("kept by {}thinning: {} components, {} loops; complement {}, {}\n", which,
                     b.marked.b0, b.marked.b1, b.complement.b0, b.complement.b1);
}

std::vector<std::string> used_references(const FeaturesOptions& o) {
  std::vector<std::string> keys = {"roessl2005surfaces"};
  const char* method = o.field.empty() ? curvature_reference(o.method) : nullptr;
  if (method) keys.push_back(method);
  if (o.lines.neighbourhood == Neighbourhood::geodesic) keys.push_back("kimmel1998computing");
  if (!o.common.certificate.empty()) keys.push_back("mcconnell2011certifying");
  return keys;
}

Outcome work(Run& run, const FeaturesOptions& o) {
  io::MeshRequest request;
  if (!o.field.empty()) request.field = o.field;
  const io::MeshFile file = run.read_mesh(request);
  const kernel::TriangleMesh& mesh = file.mesh;
  const std::vector<double> field =
      run.step("fit", "fitting curvatures", [&] { return field_of(o, file, run); });
  const FeatureLines f = run.step("extract", "thinning", [&] {
    return run.with_input(
        [&] { return feature_lines::extract_feature_lines(mesh, field, o.lines); });
  });
  const certify::Bytes certificate = run.step("certificate", "composing the certificate", [&] {
    return certify::encode(feature_lines::make_certificate(mesh, f.thinning));
  });
  const std::string digest = certify::hex(certify::data_digest(certificate));
  run.step("write", "writing", [&] {
    run.write("-o", [&](const std::string& path) {
      io::write_features(path, mesh, f.graph, field, digest);
    });
    run.write("--picture",
              [&](const std::string& path) { io::write_feature_picture(path, mesh, f.graph); });
    run.write_certificate("features-mesh", certificate);
  });
  fill_report(run.report(), o, mesh, f, digest);
  return {summary_text(f), used_references(o)};
}

int run_features(FeaturesOptions& o) {
  check_options(o);
  return run_command({"features", o.common, {".vtp", ".obj"}},
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
    {"crest features ellipsoid.off --threshold 0.9 --close 1 --prune 4 -o features.vtp",
     "crest features ellipsoid.off --method ne --value 1.5 --certificate features.crest --picture "
     "features.svg"}};

}  // namespace crest::cli
