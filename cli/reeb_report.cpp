// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/reeb_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "algorithms/reeb/contraction.hpp"
#include "kernel/geometry/disjoint_sets.hpp"

namespace crest::cli {
namespace {

using kernel::Index;
using kernel::kNone;
using reeb::NodeKind;
using reeb::ReebGraph;

struct Counts {
  std::size_t minima = 0, saddles = 0, maxima = 0;
  std::int64_t index_sum = 0;
};

/// Saddles with their multiplicity.
Counts count_kinds(const ReebGraph& graph) {
  Counts counts;
  for (const reeb::ReebNode& node : graph.nodes) {
    if (node.kind == NodeKind::minimum) ++counts.minima;
    if (node.kind == NodeKind::maximum) ++counts.maxima;
    if (node.kind == NodeKind::saddle) counts.saddles += node.multiplicity;
    counts.index_sum += node.index;
  }
  return counts;
}

std::int64_t euler_characteristic(const kernel::QuadraticMesh& mesh) {
  return std::int64_t{mesh.vertex_count()} - mesh.edge_count() + mesh.face_count();
}

/// Every boundary vertex has two boundary edges: as many loops as components of these edges.
std::size_t boundary_loops(const kernel::QuadraticMesh& mesh) {
  kernel::DisjointSets joined(mesh.vertex_count());
  std::size_t loops = 0;
  for (const kernel::Edge& e : mesh.edges()) {
    if (e.f1 != kNone) continue;
    if (!joined.unite(e.v0, e.v1)) ++loops;  // the edge that closes one
  }
  return loops;
}

Json graph_json(const ReebGraph& graph) {
  return {{"nodes", graph.nodes.size()},
          {"arcs", graph.arcs.size()},
          {"loops", graph.loops()},
          {"components", graph.components}};
}

std::string graph_words(const ReebGraph& graph) {
  return fmt::format("{} nodes, {} arcs, {} loops, {} components", graph.nodes.size(),
                     graph.arcs.size(), graph.loops(), graph.components);
}

/// Nodes whose value is that of the one before in the order.
std::int64_t tied_values(const ReebRun& run) {
  return std::count(run.tiles.tied.begin(), run.tiles.tied.end(), std::uint8_t{1});
}

const char* tree_name(int kind) {
  if (kind == io::kJoinTreeKind) return "join_tree";
  return kind == io::kSplitTreeKind ? "split_tree" : "contour_tree";
}

/// Ends of one arc only, roots included.
std::size_t leaves(const io::TreeLines& tree) {
  std::unordered_map<Index, int> degree;
  for (const auto& arc : tree.arcs)
    for (const Index v : arc) ++degree[v];
  return static_cast<std::size_t>(std::count_if(degree.begin(), degree.end(),
                                                [](const auto& node) { return node.second == 1; }));
}

}  // namespace

void fill_report(Report& report, const ReebRun& run) {
  for (const auto& [name, counts] : run.predicates) {
    report["predicates"][name] = {{"calls", counts.calls},
                                  {"interval", counts.interval},
                                  {"integer", counts.integer},
                                  {"exact", counts.exact},
                                  {"symbolic", counts.symbolic}};
  }
  const Counts counts = count_kinds(run.graph);
  report["function"] = run.function;
  report["degree"] = run.mesh.linear() ? 1 : 2;
  report["vertices"] = run.mesh.vertex_count();
  report["faces"] = run.mesh.face_count();
  report["euler_characteristic"] = euler_characteristic(run.mesh);
  report["boundary_loops"] = boundary_loops(run.mesh);
  report["line_critical"] = run.tiles.critical_edges.size();
  report["face_critical"] = run.tiles.critical_faces.size();
  report["tiles"] = run.tiles.tiles.size();
  report["ties"] = tied_values(run);
  report["critical_points"] = {{"minima", counts.minima},
                               {"saddles", counts.saddles},
                               {"maxima", counts.maxima},
                               {"index_sum", counts.index_sum}};
  report["graph"] = graph_json(run.graph);
  const std::size_t tied_arcs = reeb::count_ties(run.graph, run.tiles.rank, run.tiles.tied).arcs;
  report["tied_arcs"] = tied_arcs;
  if (tied_arcs > 0 && &run.written == &run.graph) {
    report.warn(
        fmt::format("{} values are tied, {} arcs join equal values by their numbers alone; "
                    "--contract gives the "
                    "graph of the function itself",
                    tied_values(run), tied_arcs));
  }
  // "graph", the tie-broken one, whatever is written.
  report["certificate_is_of"] = run.certified ? Json("graph") : Json();
  report["written"] = graph_json(run.written);
  add_written(report, run.simplified_by, graph_json(run.graph));
  for (const io::TreeLines& tree : run.trees)
    report[tree_name(tree.kind)] = {{"arcs", tree.arcs.size()}, {"leaves", leaves(tree)}};
  report["levels"] = Json::array();
  for (const LevelCount& level : run.levels) {
    report["levels"].push_back(
        {{"level", level.level}, {"paths", level.paths}, {"cycles", level.cycles}});
  }
}

std::string summary_text(const ReebRun& run) {
  const Counts counts = count_kinds(run.graph);
  std::string text =
      fmt::format("surface: {} vertices, {} faces, Euler characteristic {}, {} boundary loops\n",
                  run.mesh.vertex_count(), run.mesh.face_count(), euler_characteristic(run.mesh),
                  boundary_loops(run.mesh));
  text += fmt::format("function: {}, {}; {} monotone tiles\n", run.function,
                      run.mesh.linear() ? "linear" : "quadratic", run.tiles.tiles.size());
  text += fmt::format("critical points: {} minima, {} saddles, {} maxima\n", counts.minima,
                      counts.saddles, counts.maxima);
  text += "Reeb graph: " + graph_words(run.graph) + "\n";
  for (const io::TreeLines& tree : run.trees) {
    text += fmt::format("{}: {} arcs, {} leaves\n", tree_name(tree.kind), tree.arcs.size(),
                        leaves(tree));
  }
  text += written_line({"simplification", whole("Reeb graph", run.certified),
                        graph_words(run.written), run.simplified_by});
  if (const auto ties = tied_values(run); ties > 0) {
    text += fmt::format(
        "ties: {} values equal the one before; the Reeb graph orders them by number, {} of its "
        "arcs "
        "join equal values; --contract gives the graph of the function itself\n",
        ties, reeb::count_ties(run.graph, run.tiles.rank, run.tiles.tied).arcs);
  }
  for (const LevelCount& level : run.levels)
    text += fmt::format("level {}: {} paths, {} cycles\n", level.level, level.paths, level.cycles);
  return text;
}

}  // namespace crest::cli
