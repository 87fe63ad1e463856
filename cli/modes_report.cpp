// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/modes_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "algorithms/modes/field_counts.hpp"

namespace crest::cli {
namespace {

Json to_json(const kernel::Vec3& p) {
  return std::vector<double>(p.begin(), p.end());
}

Json to_json(const modes::ModeSurface& s) {
  Json components = Json::array();
  for (const auto& c : s.components)
    components.push_back({{"euler_characteristic", c.euler_characteristic},
                          {"boundary_loops", c.boundary_loops},
                          {"orientable", c.orientable},
                          {"complete", c.complete}});
  Json singular = Json::array();
  for (const auto& p : s.singular_points) singular.push_back(to_json(p));
  return {{"mode", s.mode},
          {"vertices", s.points.size()},
          {"triangles", s.triangles.size()},
          {"max_mode_error", s.max_mode_error},
          {"watertight", s.watertight},
          {"euler_characteristic", s.euler_characteristic},
          {"components", components},
          {"face_loops", s.face_loops},
          {"zero_rims", s.zero_rims},
          {"positions_unproven", s.unproven_pieces},
          {"singular_points", singular},
          {"perturbed",
           {{"vertices", s.perturbed.vertices},
            {"edge_touches", s.perturbed.edge_touches},
            {"uniform_tets", s.perturbed.uniform_tets}}}};
}

std::string summary_line(const modes::ModeSurface& s) {
  std::size_t loops = 0;
  for (const auto& c : s.components) loops += c.boundary_loops;
  return fmt::format(
      "mode {}: {} triangles, {} components, Euler characteristic {}, {} boundary loops{}\n",
      s.sign == 0 ? "0" : fmt::format("{:+}", s.mode), s.triangles.size(), s.components.size(),
      s.euler_characteristic, loops, s.watertight ? "" : ", open at undecided cells");
}

}  // namespace

ModesReport::ModesReport(Report& report, const modes::ModeField& field, const io::TensorFile& file,
                         const modes::ZeroSet& zeros)
    : report_(report), file_(file), zeros_(zeros) {
  std::size_t flat = 0, inverted = 0;
  for (kernel::Index t = 0; t < field.mesh.tets().size(); ++t) {
    const int s = field.mesh.orientation(t);
    flat += s == 0 ? 1 : 0;
    inverted += s < 0 ? 1 : 0;
  }
  const modes::FieldCounts counts = modes::count_field(field);
  report_["tensor"] = file.field;
  report_["vertices"] = field.mesh.points().size();
  report_["field"] = {{"zero_vertices", counts.zero_vertices - zeros.simplices.size()},
                      {"inner_zeros", zeros.simplices.size()},
                      {"flat_tets", flat},
                      {"negative_tets", inverted},
                      {"constant_tets", counts.constant_tets},
                      {"rank_deficient_tets", counts.rank_deficient_tets},
                      {"max_asymmetry", file.max_asymmetry}};
  if (!zeros.simplices.empty())
    warnings_.push_back(
        fmt::format("vertices were put where the tensor is zero: {}", zeros.simplices.size()));
  if (flat > 0) warnings_.push_back(fmt::format("{} tetrahedra are flat", flat));
}

/// As the file numbers cells.
std::int64_t ModesReport::cell(kernel::Index tet) const {
  return file_.cell_of[zeros_.tet_of[tet]];
}

void ModesReport::add(const modes::ModeResult& r) {
  for (const auto& s : r.surfaces) {
    Json surface = to_json(s);
    Json undecided = Json::array();
    for (const kernel::Index t : r.undecided) undecided.push_back(cell(t));
    surface["undecided"] = undecided;
    surfaces_.push_back(std::move(surface));
    summary_ += summary_line(s);
  }
  const auto& c = r.counts;
  counts_.total = c.total;
  counts_.rejected_bound += c.rejected_bound;
  counts_.rejected_bernstein += c.rejected_bernstein;
  counts_.active += c.active;
  counts_.cones += c.cones;
  counts_.graph_at_once += c.graph_at_once;
  counts_.graph_cells += c.graph_cells;
  counts_.uniform += c.uniform;
  counts_.tests += c.tests;
  counts_.exact_tests += c.exact_tests;
  counts_.max_depth = std::max(counts_.max_depth, c.max_depth);
  if (c.uniform > 0)
    warnings_.push_back(
        fmt::format("mode {}: {} tetrahedra have this mode everywhere and carry no surface",
                    r.level.value(), c.uniform));
  undecided_ += r.undecided.size();
  exhausted_ = exhausted_ || r.exhausted;
  if (!r.undecided.empty()) {
    std::string names;
    for (std::size_t i = 0; i < std::min<std::size_t>(r.undecided.size(), 5); ++i)
      names += fmt::format("{}{}", i == 0 ? "" : ", ", cell(r.undecided[i]));
    warnings_.push_back(
        fmt::format("mode {}: {} tetrahedra are not decided ({}{}){}", r.level.value(),
                    r.undecided.size(), names, r.undecided.size() > 5 ? ", .." : "",
                    r.level.neutral() ? "; a small mode that is not 0 may be, --mode 1/1000" : ""));
  }
}

void ModesReport::finish() {
  report_["surfaces"] = surfaces_;
  report_["tets"] = {{"total", counts_.total},
                     {"rejected_bound", counts_.rejected_bound},
                     {"rejected_bernstein", counts_.rejected_bernstein},
                     {"active", counts_.active},
                     {"cones", counts_.cones},
                     {"uniform", counts_.uniform},
                     {"graph_at_once", counts_.graph_at_once},
                     {"graph_cells", counts_.graph_cells},
                     {"tests", counts_.tests},
                     {"exact_tests", counts_.exact_tests},
                     {"max_depth", counts_.max_depth}};
}

}  // namespace crest::cli
