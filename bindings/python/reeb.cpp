// SPDX-License-Identifier: GPL-3.0-or-later
// crest reeb.
#include <stdexcept>

#include "algorithms/reeb/certificate.hpp"
#include "algorithms/reeb/contour_tree.hpp"
#include "algorithms/reeb/labelled_graph.hpp"
#include "algorithms/reeb/merge_trees.hpp"
#include "algorithms/reeb/reeb_graph.hpp"
#include "bindings/python/systems.hpp"
#include "io/reeb/reeb_picture.hpp"
#include "io/reeb/reeb_writer.hpp"
#include "kernel/geometry/input_error.hpp"
#include "kernel/geometry/quadratic_mesh.hpp"

namespace crest::python {
namespace {

kernel::QuadraticMesh function_of(const Arguments& a) {
  auto points = a.rows<3>("V");
  auto faces = a.cells<3>("F", points.size());
  auto values = std::get<std::vector<double>>(a.array("values").data);
  std::vector<std::array<double, 3>> midside;
  if (a.has("midside")) midside = a.rows<3>("midside");
  return {std::move(points), std::move(faces), std::move(values), midside};
}

/// The graph as arrays: the geometry has it too, but along the surface.
void add_graph(const reeb::ReebGraph& graph, Output& out) {
  std::vector<std::array<kernel::Index, 2>> arcs;
  for (const reeb::ReebArc& arc : graph.arcs) arcs.push_back({arc.lower, arc.upper});
  out.values["arcs"] = array_of(arcs);
  out.values["components"] = std::int64_t{graph.components};
  out.values["loops"] = std::int64_t{graph.loops()};
}

/// Of the whole graph, whatever is simplified.
std::vector<io::TreeLines> trees_of(const Arguments& a, const reeb::TileComplex& tiles,
                                    const reeb::ReebGraph& graph, Output& out) {
  std::vector<io::TreeLines> trees;
  const auto add = [&](const char* name, int kind, auto&& arcs) {
    if (!a.flag(name)) return;
    trees.push_back({kind, arcs()});
    out.values[name] = array_of(trees.back().arcs);
  };
  add("join_tree", io::kJoinTreeKind,
      [&] { return reeb::arcs_of(graph, reeb::reduced(reeb::augmented_join_tree(graph))); });
  add("split_tree", io::kSplitTreeKind,
      [&] { return reeb::arcs_of(graph, reeb::reduced(reeb::augmented_split_tree(graph))); });
  add("contour_tree", io::kContourTreeKind, [&] {
    try {
      return reeb::arcs_of(reeb::contour_tree(reeb::ordered(tiles)));
    } catch (const std::invalid_argument&) {
      throw kernel::InputError(
          "contour_tree: the surface is not simply connected, there need not be one; the Reeb "
          "graph serves all surfaces");
    }
  });
  return trees;
}

}  // namespace

Output run_reeb(const Arguments& a, const Progress& progress) {
  const kernel::QuadraticMesh mesh = function_of(a);
  const reeb::TileComplex tiles =
      progress.step("tessellating", [&] { return reeb::tessellate(mesh); });
  const reeb::ReebGraph graph = progress.step(
      "joining contours into the graph", [&] { return reeb::reeb_graph(reeb::ordered(tiles)); });
  Output out;
  std::string digest;
  if (a.flag("certificate"))
    digest = progress.step("composing the certificate", [&] {
      return out.certify(certify::encode(reeb::make_certificate(mesh, tiles, graph)));
    });
  const auto places =
      progress.step("placing nodes", [&] { return reeb::node_places(mesh, tiles); });
  reeb::LabelledGraph written{graph, {}, {}};
  progress.step("labelling", [&] { reeb::label(tiles, a.flag("segmentation"), written); });
  const reeb::Simplification wanted{a.flag("contract"), a.maybe_number("persistence"),
                                    a.flag("cancel_loops")};
  if (wanted.wanted()) {
    std::vector<double> values;
    for (const reeb::NodePlace& place : places) values.push_back(place.value);
    progress.step("simplifying", [&] { reeb::simplify(tiles, values, wanted, written); });
  }
  const auto lines = [&](const std::vector<double>& at) {
    std::vector<io::LevelLines> levels;
    for (const double level : at) levels.push_back({level, reeb::contours(mesh, tiles, level)});
    return levels;
  };
  const auto levels =
      progress.step("drawing level lines", [&] { return lines(a.numbers("level")); });
  const std::vector<io::TreeLines> trees =
      progress.step("merging", [&] { return trees_of(a, tiles, graph, out); });
  const auto scene = [&](const std::vector<io::LevelLines>& shown) {
    return io::ReebScene{
        mesh,  tiles, places, written.graph, written.arc_of_node, written.arc_of_tile,
        trees, shown, digest};
  };
  out.geometries["geometry"] = io::geometry_of(io::reeb_poly_data(scene(levels)));
  if (a.has("picture")) {
    const auto shown = levels.empty() ? lines(io::picture_levels(places)) : levels;
    io::write_reeb_picture(a.text("picture"), scene(shown), viewpoint_of(a));
  }
  add_graph(written.graph, out);
  out.values["data_digest"] = digest;
  return out;
}

}  // namespace crest::python
