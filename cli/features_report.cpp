// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/features_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace crest::cli {
namespace {

using feature_lines::FeatureGraph;
using feature_lines::LineKind;

Json betti_json(const feature_lines::Topology& t) {
  const auto one = [](const feature_lines::Betti& b) {
    return Json{{"euler_characteristic", b.euler},
                {"components", b.b0},
                {"loops", b.b1},
                {"closed_surfaces", b.b2}};
  };
  return {{"marked", one(t.marked)}, {"complement", one(t.complement)}};
}

Json lengths_json(const FeatureGraph& graph) {
  std::array<double, 4> length{};
  for (const auto& line : graph.lines) length[static_cast<std::size_t>(line.kind)] += line.length;
  return {
      {"arcs", length[0]}, {"branches", length[1]}, {"loops", length[2]}, {"isolated", length[3]}};
}

std::string lines_summary(const FeatureGraph& graph) {
  return fmt::format("lines: {} arcs, {} branches, {} loops, {} isolated; {} nodes, {} patches\n",
                     graph.count(LineKind::arc), graph.count(LineKind::branch),
                     graph.count(LineKind::loop), graph.count(LineKind::isolated),
                     graph.nodes.size(), graph.patch_sizes.size());
}

}  // namespace

void report_lines(Report& report, const kernel::TriangleMesh& mesh, const FeatureGraph& graph) {
  report["vertices"] = mesh.vertex_count();
  report["faces"] = mesh.face_count();
  report["euler_characteristic"] = mesh.euler_characteristic();
  report["boundary_loops"] = mesh.boundary_loops();
  report["line_vertices"] =
      mesh.vertex_count() -
      std::count(graph.labels.begin(), graph.labels.end(), feature_lines::Label::patch);
  report["nodes"] = graph.nodes.size();
  report["arcs"] = graph.count(LineKind::arc);
  report["branches"] = graph.count(LineKind::branch);
  report["loops"] = graph.count(LineKind::loop);
  report["isolated"] = graph.count(LineKind::isolated);
  report["patches"] = graph.patch_sizes.size();
  report["length"] = lengths_json(graph);
}

void report_region(Report& report, const feature_lines::FeatureLines& f) {
  report["threshold"] = f.value;
  report["marked"] = f.marked;
  report["filled_patches"] = f.filled_patches;
  report["joined_ends"] = f.joined;
  report["thinnings"] = f.thinnings;
  report["thinned"] = feature_lines::count(f.thinning.before);
  report["dropped_lines"] = f.thinning.dropped.size();
  report["betti_before"] = betti_json(f.thinning.topology_before);
  report["betti_after"] = betti_json(f.thinning.topology_after);
}

void report_sharp(Report& report, const feature_lines::SharpLines& lines) {
  report["sharp_edges"] = feature_lines::count(lines.sharp);
  report["sharp_ties"] = lines.ties;
  report["line_edges"] = feature_lines::count(lines.edges);
  report["joined_ends"] = lines.joined;
  report["dropped_lines"] = lines.pruned;
  const kernel::StageCounts& counts = lines.decided;
  report["predicates"]["dihedral_angle"] = {{"calls", counts.calls},
                                            {"interval", counts.interval},
                                            {"exact", counts.exact},
                                            {"symbolic", counts.symbolic}};
}

std::string region_summary(const feature_lines::FeatureLines& f) {
  const auto& b = f.thinning.topology_after;
  const std::string which =
      f.thinnings == 1 ? "" : fmt::format("the last of {} rounds of ", f.thinnings);
  return fmt::format("region: {} of {} vertices from {:.6g} on\n", f.marked, f.marks.size(),
                     f.value) +
         lines_summary(f.graph) +
         fmt::format("kept by {}thinning: {} components, {} loops; complement {}, {}\n", which,
                     b.marked.b0, b.marked.b1, b.complement.b0, b.complement.b1);
}

std::string sharp_summary(const feature_lines::SharpLines& lines, const std::string& degrees) {
  return fmt::format("sharp edges: {} of {} above {} degrees\n", feature_lines::count(lines.sharp),
                     lines.sharp.size(), degrees) +
         lines_summary(lines.graph);
}

}  // namespace crest::cli
