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

void report_region(Report& report, const feature_lines::FeatureLines& f,
                   const certify::FeaturesMeshCertificate& certificate) {
  report["threshold"] = f.value;
  report["marked"] = f.marked;
  report["filled_patches"] = f.filled_patches;
  report["joined_ends"] = f.joined;
  report["thinnings"] = f.thinnings;
  report["thinned"] = feature_lines::count(f.thinning.before);
  report["dropped_lines"] = f.thinning.dropped.size();
  report["betti_before"] = betti_json(f.thinning.topology_before);
  report["betti_after"] = betti_json(f.thinning.topology_after);
  add_written(report, written(f, false).by,
              {{"region_vertices", feature_lines::count(certificate.marked_before)},
               {"thinned_vertices", certificate.marked_after.size()},
               {"dropped", certificate.dropped.size()},
               {"components", certificate.components},
               {"loops", certificate.betti[2].loops},
               {"complement_components", certificate.betti[3].components},
               {"complement_loops", certificate.betti[3].loops}});
}

void report_sharp(Report& report, const feature_lines::SharpLines& lines,
                  const certify::SharpEdgesCertificate& certificate) {
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
  add_written(report, written(lines, false).by,
              {{"sharp_edges", certificate.sharp.size()},
               {"sharp_ties", certificate.ties},
               {"ends", certificate.ends},
               {"nodes", certificate.nodes},
               {"patches", certificate.patches}});
}

Written written(const feature_lines::FeatureLines& f, bool certifies) {
  Written w;
  if (!f.thinning.dropped.empty()) w.by.push_back("--prune");
  if (f.filled_patches > 0) w.by.push_back("--min-patch");
  if (f.joined > 0) w.by.push_back("--close-branches");
  if (f.thinnings > 1) {
    w.kind = "simplification";
    w.whole = "marked region";
    w.share = fmt::format("{} patches filled, {} pairs of ends joined{}", f.filled_patches,
                          f.joined, certifies ? ", certified as it is then" : "");
  } else {
    w.whole = whole("thinned region", certifies);
    w.share = fmt::format("{} of {} vertices", feature_lines::count(f.marks),
                          feature_lines::count(f.thinning.after));
  }
  return w;
}

Written written(const feature_lines::SharpLines& lines, bool certifies) {
  Written w;
  if (lines.pruned > 0) w.by.push_back("--prune");
  if (lines.joined > 0) w.by.push_back("--close-branches");
  w.kind = lines.joined > 0 ? "simplification" : "subset";
  w.whole = whole("sharp edges", certifies);
  w.share = fmt::format("{} {} {}", feature_lines::count(lines.edges),
                        lines.joined > 0 ? "edges for" : "of", feature_lines::count(lines.sharp));
  return w;
}

std::string region_summary(const feature_lines::FeatureLines& f, bool certifies) {
  const auto& b = f.thinning.topology_after;
  const std::string which =
      f.thinnings == 1 ? "" : fmt::format("the last of {} rounds of ", f.thinnings);
  return fmt::format("region: {} of {} vertices from {:.6g} on\n", f.marked, f.marks.size(),
                     f.value) +
         lines_summary(f.graph) +
         fmt::format("kept by {}thinning: {} components, {} loops; complement {}, {}\n", which,
                     b.marked.b0, b.marked.b1, b.complement.b0, b.complement.b1) +
         written_line(written(f, certifies));
}

std::string sharp_summary(const feature_lines::SharpLines& lines, const std::string& degrees,
                          bool certifies) {
  return fmt::format("sharp edges: {} of {} above {} degrees\n", feature_lines::count(lines.sharp),
                     lines.sharp.size(), degrees) +
         lines_summary(lines.graph) + written_line(written(lines, certifies));
}

}  // namespace crest::cli
