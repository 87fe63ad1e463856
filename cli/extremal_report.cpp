// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/extremal_report.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace crest::cli {
namespace {

using extremal::Component;
using extremal::Result;

Json to_json(const Component& c, int dimension) {
  Json json = {{"polygons", c.polygons},
               {"vertices", c.vertices},
               {"euler_characteristic", c.euler_characteristic}};
  if (dimension == 2) {
    json["ends"] = c.ends;
    json["length"] = c.area;
  } else {
    json["boundary_loops"] = c.boundary_loops;
    json["orientable"] = c.orientable;
    json["area"] = c.area;
  }
  json["isotopic"] = c.isotopic ? Json(*c.isotopic) : Json();
  json["critical_type"] = c.critical_type;
  return json;
}

Json features_json(const Result& r) {
  constexpr const char* names[] = {"discontinuity", "inflection", "trim", "border", "undecided"};
  std::size_t counts[5] = {};
  for (const extremal::Feature& f : r.features) ++counts[static_cast<std::size_t>(f.reason) - 1];
  Json json = Json::object();
  for (std::size_t i = 0; i < 5; ++i) json[names[i]] = counts[i];
  return json;
}

}  // namespace

void fill_report(Report& report, const Result& r) {
  const extremal::Counts& c = r.counts;
  report["dimension"] = r.dimension;
  report["h"] = r.h;
  report["vertices"] = r.points.size();
  report["polygons"] = r.polygons();
  report["nodes"] = c.nodes;
  report["active_nodes"] = c.active_nodes;
  report["flat_nodes"] = c.flat_nodes;
  report["cells"] = {
      {"empty", c.empty}, {"regular", c.regular}, {"cone", c.cone}, {"open", c.open}};
  report["tested_edges"] = c.edges;
  report["cone_tests"] = c.cone_tests;
  report["critical_edges"] = c.critical_edges;
  report["extremal_edges"] = c.extremal_edges;
  report["undecided_edges"] = c.undecided_edges;
  report["undecided_types"] = c.undecided_types;
  report["bisections"] = c.bisections;
  report["odd_faces"] = c.odd_faces;
  report["junction_edges"] = c.junction_edges;
  report["ambiguous_faces"] = c.ambiguous_faces;
  report["sheets_split"] = c.sheets_split;
  report["valence"] = {
      {"1", c.valence[0]}, {"2", c.valence[1]}, {"3", c.valence[2]}, {"4+", c.valence[3]}};
  report["odd_valence_edges"] = c.valence[0] + c.valence[2];
  report["odd_valence_unexplained"] = c.odd_valence_unexplained;
  report["features"] = features_json(r);
  report["octree"] = {{"leaves", c.leaves}, {"depth", c.depth}};
  report["max_residual"] = r.max_residual;
  Json components = Json::array(), undecided = Json::array();
  for (const Component& component : r.components)
    components.push_back(to_json(component, r.dimension));
  for (const extremal::UndecidedEdge& e : r.undecided)
    undecided.push_back({{"from", e.a}, {"to", e.b}, {"type_only", e.type}});
  report["components"] = components;
  report["undecided"] = undecided;
}

std::vector<std::string> extremal_warnings(const Result& r) {
  std::vector<std::string> warnings;
  const extremal::Counts& c = r.counts;
  if (r.polygons() == 0)
    warnings.push_back(
        "there is no extremal surface: the data are constant or their squares too small for "
        "binary32, or the thresholds leave nothing");
  if (c.undecided_edges > 0)
    warnings.push_back(
        fmt::format("{} of {} edges of the grid are not decided; the report lists them",
                    c.undecided_edges, c.edges));
  if (c.undecided_types > 0)
    warnings.push_back(
        fmt::format("whether extremal or merely critical is not decided at {} edges of the grid, "
                    "taken as merely critical; the report lists them",
                    c.undecided_types));
  if (c.odd_valence_unexplained > 0)
    warnings.push_back(fmt::format("{} edges of odd valence without a reason: please report this",
                                   c.odd_valence_unexplained));
  return warnings;
}

std::string extremal_summary(const Result& r) {
  const extremal::Counts& c = r.counts;
  std::size_t loops = 0, ends = 0, isotopic = 0, one_sided = 0;
  std::int64_t euler = 0;
  for (const Component& k : r.components) {
    loops += k.boundary_loops;
    ends += k.ends;
    euler += k.euler_characteristic;
    isotopic += k.isotopic.value_or(false) ? 1 : 0;
    one_sided += k.orientable ? 0 : 1;
  }
  if (r.dimension == 2)
    return fmt::format("{}, {}, {}\n", plural(r.polygons(), "segment"),
                       plural(r.components.size(), "curve"), plural(ends, "end"));
  const std::size_t tested = c.empty + c.regular + c.cone;
  return fmt::format(
      "{}, {} ({} one-sided), Euler characteristic {}, {}\n"
      "{} isotopic to one of the field; {} of {} active cells empty or regular\n"
      "edges of valence 1: {}, 2: {}, 3: {}, more: {}\n",
      plural(r.polygons(), "polygon"), plural(r.components.size(), "component"), one_sided, euler,
      plural(loops, "boundary loop"), plural(isotopic, "component"), c.empty + c.regular, tested,
      c.valence[0], c.valence[1], c.valence[2], c.valence[3]);
}

}  // namespace crest::cli
