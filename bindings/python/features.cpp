// SPDX-License-Identifier: GPL-3.0-or-later
// crest features.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "algorithms/curvature/curvature.hpp"
#include "algorithms/feature_lines/certificate.hpp"
#include "algorithms/ridges/ridges.hpp"
#include "bindings/python/systems.hpp"
#include "io/features/feature_writer.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::python {
namespace {

using feature_lines::Neighbourhood;
using kernel::Index;

Index count_of(const Arguments& a, const char* name) {
  return static_cast<Index>(a.integer(name));
}

/// The larger absolute principal curvature at each vertex.
std::vector<double> curvature_field(const Arguments& a, const kernel::TriangleMesh& mesh,
                                    Output& out) {
  std::vector<double> field;
  const auto add = [&](double k1, double k2) {
    field.push_back(std::max(std::fabs(k1), std::fabs(k2)));
  };
  if (a.text("method") == "fit") {
    ridges::FitOptions options;
    if (a.has("rings")) options.rings = a.integer("rings");
    for (const auto& form : ridges::fit_monge_forms(mesh, options).forms) add(form.k1, form.k2);
    return field;
  }
  curvature::Options options;
  options.method = curvature::method_of(a.text("method")).value();
  if (a.has("rings")) options.rings = a.integer("rings");
  const curvature::Result result = curvature::estimate(mesh, options);
  if (result.undetermined > 0)
    out.warnings.push_back(
        fmt::format("{} vertices have no finite curvature; it is zero there", result.undetermined));
  for (const auto& c : result.vertices) add(c.k1, c.k2);
  return field;
}

feature_lines::Options region_options(const Arguments& a) {
  feature_lines::Options o;
  o.seek_gap = !a.has("threshold");
  if (a.has("threshold")) o.quantile = a.number("threshold");
  o.value = a.maybe_number("value");
  const std::string& kind = a.text("neighbourhood");
  o.neighbourhood = kind == "euclidean"  ? Neighbourhood::euclidean
                    : kind == "path"     ? Neighbourhood::path
                    : kind == "geodesic" ? Neighbourhood::geodesic
                                         : Neighbourhood::rings;
  o.dilate = a.number("dilate");
  o.erode = a.number("erode");
  o.open = a.number("open");
  o.close = a.number("close");
  o.prune = count_of(a, "prune");
  o.min_patch = count_of(a, "min_patch");
  o.close_branches = count_of(a, "close_branches");
  return o;
}

void fill(const Arguments& a, const kernel::TriangleMesh& mesh,
          const feature_lines::FeatureGraph& graph, const std::vector<double>& field,
          const std::string& digest, Output& out) {
  if (a.has("picture")) {
    const bool patches = a.has("angle") && count_of(a, "over") == 0;
    io::write_feature_picture(a.text("picture"), mesh, graph, patches, viewpoint_of(a));
  }
  out.geometries["geometry"] = io::geometry_of(io::feature_poly_data(mesh, graph, field, digest));
  out.values["data_digest"] = digest;
}

void find_sharp_edges(const Arguments& a, const kernel::TriangleMesh& mesh,
                      const kernel::DecimalAngle& angle, const Progress& progress, Output& out) {
  const auto lines = progress.step("comparing angles", [&] {
    return feature_lines::extract_sharp_lines(
        mesh, angle, {count_of(a, "prune"), count_of(a, "close_branches")});
  });
  if (lines.ties > 0)
    out.warnings.push_back(
        fmt::format("edges of exactly {} degrees ({}) are not above it; a smaller angle marks them",
                    a.text("angle"), lines.ties));
  const std::string digest =
      out.certify(certify::encode(feature_lines::make_certificate(mesh, angle, lines)));
  fill(a, mesh, lines.graph, feature_lines::vertex_angles(mesh, 0), digest, out);
  out.values["value"] = angle.degrees();
}

}  // namespace

Output run_features(const Arguments& a, const Progress& progress) {
  const kernel::TriangleMesh mesh = mesh_of(a);
  const Index over = count_of(a, "over");
  Output out;
  std::optional<kernel::DecimalAngle> angle;
  try {
    if (a.has("angle")) angle.emplace(a.text("angle"));
  } catch (const std::invalid_argument& error) {
    throw kernel::InputError("angle: " + a.text("angle") + " " + error.what());
  }
  if (angle && over == 0) {
    find_sharp_edges(a, mesh, *angle, progress, out);
    return out;
  }
  feature_lines::Options options = region_options(a);
  const std::vector<double> field = progress.step("fitting curvatures", [&] {
    if (angle) return feature_lines::vertex_angles(mesh, over);
    if (!a.has("field")) return curvature_field(a, mesh, out);
    std::vector<double> given = std::get<std::vector<double>>(a.array("field").data);
    if (a.flag("absolute"))
      for (double& x : given) x = std::fabs(x);
    return given;
  });
  if (angle) options.value = angle->degrees();
  const auto lines = progress.step(
      "thinning", [&] { return feature_lines::extract_feature_lines(mesh, field, options); });
  const std::string digest =
      out.certify(certify::encode(feature_lines::make_certificate(mesh, lines.thinning)));
  fill(a, mesh, lines.graph, field, digest, out);
  out.values["value"] = lines.value;
  return out;
}

}  // namespace crest::python
