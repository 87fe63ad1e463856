// SPDX-License-Identifier: GPL-3.0-or-later
// crest ridges of a mesh.
#include "algorithms/ridges/ridges.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "algorithms/ridges/auto_scale.hpp"
#include "algorithms/ridges/certificate.hpp"
#include "bindings/python/systems.hpp"
#include "io/ridges/ridge_picture.hpp"
#include "io/ridges/ridge_writer.hpp"

namespace crest::python {
namespace {

ridges::FilterOptions filter_of(const Arguments& a) {
  ridges::FilterOptions filter;
  filter.min_sharpness = a.number("min_sharpness");
  filter.min_strength = a.number("min_strength");
  filter.min_length = a.number("min_length");
  filter.crest_only = a.flag("crest_only");
  filter.min_level = a.flag("salient") ? 2 : a.flag("significant") ? 1 : 0;
  return filter;
}

void warn_about_fit(const ridges::FitResult& fit, int degree, Output& out) {
  std::size_t lowered = 0;
  for (const ridges::FitQuality& q : fit.quality) lowered += q.degree < degree ? 1 : 0;
  if (lowered > 0)
    out.warnings.push_back(fmt::format(
        "{} vertices were fitted with a lower degree (too few or badly placed neighbours)",
        lowered));
}

std::string note_of(const ridges::RidgeGraph& graph, const ridges::FilterOptions& filter,
                    const ridges::FilterReport& dropped) {
  const bool cut = ridges::open_ends(graph) > 0;
  std::vector<std::string> by;
  if (dropped.by_sharpness > 0) by.push_back("min_sharpness");
  if (dropped.by_strength > 0) by.push_back("min_strength");
  if (dropped.by_length > 0) by.push_back("min_length");
  if (dropped.by_crest > 0 || (cut && filter.crest_only)) by.push_back("crest_only");
  if (dropped.by_level > 0 || (cut && filter.min_level > 0)) by.push_back("significance");
  return by.empty() ? std::string() : fmt::format("subset by {}", fmt::join(by, ", "));
}

/// As crest ridges draws it: what is significant, with salient lines in full width.
void draw(const Arguments& a, const kernel::TriangleMesh& mesh, const ridges::FitResult& fit,
          const std::optional<ridges::SalienceReport>& salience, ridges::RidgeGraph graph,
          ridges::FilterOptions filter) {
  io::PictureOptions picture;
  picture.view = viewpoint_of(a).view;
  picture.up = viewpoint_of(a).up;
  picture.order = a.integer("order");
  ridges::FilterReport dropped;
  if (salience) {
    constexpr double kAll = 0.95;  // of the length: then nothing needs to stand back
    picture.by_salience = true;
    for (const ridges::CurvatureError& e : fit.errors)
      picture.spur += e.radius / static_cast<double>(fit.errors.size());
    picture.full_level = salience->length_significant >= kAll * salience->length ? 1 : 2;
    filter.min_level = std::max(filter.min_level, 1);
  }
  dropped = ridges::filter(graph, filter);
  picture.note = note_of(graph, filter, dropped);
  io::write_picture(a.text("picture"), mesh, graph, picture);
}

}  // namespace

Output run_ridges(const Arguments& a, const Progress& progress) {
  const kernel::TriangleMesh mesh = mesh_of(a);
  ridges::FitOptions fitting;
  ridges::GraphOptions joining;
  ridges::SalienceOptions salience;
  salience.z = a.number("significance");
  salience.min_weight = a.number("min_weight");
  fitting.errors = salience.z > 0;
  fitting.rings = a.integer("rings");
  fitting.scale = a.number("scale");
  fitting.smooth = a.integer("smooth");
  joining.umbilic_patch = a.number("umbilic_patch");
  if (a.flag("auto_scale"))
    fitting.min_points =
        progress
            .step("choosing the fits' support",
                  [&] { return ridges::choose_support(mesh, fitting, joining, salience); })
            .points;
  const ridges::FitResult fit =
      progress.step("fitting Monge forms", [&] { return ridges::fit_monge_forms(mesh, fitting); });
  Output out;
  warn_about_fit(fit, fitting.degree, out);
  ridges::CertifiedRidges certified = progress.step("extracting ridges and umbilics", [&] {
    return ridges::extract_certified(mesh, fit.forms, joining);
  });
  ridges::RidgeGraph& graph = certified.graph;
  std::optional<ridges::SalienceReport> marked;
  if (fitting.errors) {
    marked = progress.step("measuring salience",
                           [&] { return ridges::mark_salience(mesh, fit, graph, salience); });
  }
  if (a.has("picture"))
    progress.step("drawing", [&] { draw(a, mesh, fit, marked, graph, filter_of(a)); });
  std::vector<kernel::Index> umbilic_faces;
  for (const ridges::Umbilic& umbilic : graph.umbilics) umbilic_faces.push_back(umbilic.face);
  ridges::filter(graph, filter_of(a));
  const std::string digest = out.certify(std::move(certified.certificate));
  out.geometries["geometry"] = io::geometry_of(io::ridge_poly_data(mesh, fit, graph, digest));
  out.values["umbilic_face"] = array_of(umbilic_faces);
  out.values["twice_index_sum"] = std::int64_t{graph.twice_index_sum};
  out.values["euler_characteristic"] = std::int64_t{mesh.euler_characteristic()};
  out.values["closed"] = mesh.closed();
  out.values["data_digest"] = digest;
  return out;
}

}  // namespace crest::python
