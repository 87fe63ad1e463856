// SPDX-License-Identifier: GPL-3.0-or-later
// What is written of a Reeb graph, read back and looked at.
#include <algorithm>
#include <catch2/catch.hpp>

#include "algorithms/reeb/certificate.hpp"
#include "io/read/mesh_reader.hpp"
#include "io/read/quadratic_reader.hpp"
#include "io/reeb/graph_layout.hpp"
#include "io/reeb/reeb_picture.hpp"
#include "io/reeb/reeb_writer.hpp"
#include "kernel/geometry/input_error.hpp"
#include "tests/support/quadratic_files.hpp"
#include "tests/support/temporary_folder.hpp"

namespace {

using namespace crest::tests;
using crest::io::GraphLayout;
using crest::io::kNoColumn;
using crest::reeb::NodeKind;
using crest::reeb::ReebArc;
using crest::reeb::ReebGraph;

/// All that a scene refers to.
struct Stage {
  crest::kernel::QuadraticMesh mesh;
  crest::reeb::TileComplex tiles = crest::reeb::tessellate(mesh);
  std::vector<crest::reeb::NodePlace> places = crest::reeb::node_places(mesh, tiles);
  crest::reeb::GraphAndArcs labelled =
      crest::reeb::reeb_graph_and_arcs(crest::reeb::ordered(tiles));
  ReebGraph graph = labelled.graph;
  std::vector<Index> arc_of_node = labelled.arc_of_vertex;
  std::vector<Index> no_tiles = {}, arc_of_tile = std::vector<Index>(tiles.tiles.size(), 0);
  std::vector<crest::io::TreeLines> trees = {{3, {{0, 1}, {1, 2}}}};
  std::vector<crest::io::LevelLines> levels = {{0.3, crest::reeb::contours(mesh, tiles, 0.3)}};

  crest::io::ReebScene scene(bool with_tiles = false) const {
    return {mesh,  tiles,  places, graph, arc_of_node, with_tiles ? arc_of_tile : no_tiles,
            trees, levels, "abc"};
  }
};

Stage torus_stage() {
  return {mesh_of(torus_grid(12, 8, [](const Vec3& p) { return p[0] + 0.01 * p[1]; }))};
}

ReebGraph graph_of(std::size_t nodes, const std::vector<std::pair<Index, Index>>& arcs) {
  ReebGraph graph;
  for (Index v = 0; v < nodes; ++v) graph.nodes.push_back({v, NodeKind::saddle, 0, 1, 0});
  for (const auto& [low, high] : arcs) graph.arcs.push_back({low, high, 0, 0, 0});
  return graph;
}

std::vector<double> ranks(std::size_t n) {
  std::vector<double> heights;
  for (std::size_t i = 0; i < n; ++i) heights.push_back(static_cast<double>(i));
  return heights;
}

}  // namespace

TEST_CASE("the tiles of a VTU read back as the mesh they subdivide", "[io]") {
  const Stage stage = torus_stage();
  const TemporaryFolder folder;
  crest::io::write_reeb(folder / "a.vtu", stage.scene());
  const auto file = crest::io::read_quadratic_mesh(folder / "a.vtu", {"value", {}, false});
  CHECK(file.mesh.linear());
  CHECK(file.mesh.faces() == stage.tiles.tiles);
  CHECK(file.mesh.vertex_count() == stage.tiles.node_count());
  for (Index v = 0; v < stage.tiles.node_count(); ++v)
    CHECK(file.mesh.values()[v] == stage.places[v].value);
  // A subdivision with the nodes' values has the same critical points (ties apart).
  const auto tiles = crest::reeb::tessellate(file.mesh);
  const ReebGraph again = crest::reeb::reeb_graph(crest::reeb::ordered(tiles));
  CHECK(again.nodes.size() == stage.graph.nodes.size());
  CHECK(again.loops() == stage.graph.loops());
  crest::io::write_reeb(folder / "b.vtu", stage.scene(true));
  CHECK(read_text(folder / "b.vtu").find("Name=\"arc\"") != std::string::npos);
}

TEST_CASE("the VTP holds nodes, arcs, lines and tiles on request, the same bytes each time",
          "[io]") {
  const Stage stage = torus_stage();
  const TemporaryFolder folder;
  crest::io::write_reeb(folder / "a.vtp", stage.scene(true));
  const auto mesh = crest::io::read_mesh(folder / "a.vtp").mesh;
  CHECK(mesh.face_count() == stage.tiles.tiles.size());
  const std::string text = read_text(folder / "a.vtp");
  const std::size_t nodes = stage.graph.nodes.size();
  CHECK(text.find("NumberOfVerts=\"" + std::to_string(nodes) + "\"") != std::string::npos);
  const std::size_t lines =
      stage.graph.arcs.size() + stage.levels[0].contours.size() + stage.trees[0].arcs.size();
  CHECK(text.find("NumberOfLines=\"" + std::to_string(lines) + "\"") != std::string::npos);
  for (const char* name : {"value", "node", "type", "multiplicity", "on_boundary", "kind", "arc",
                           "lower", "upper", "face", "level", "data_digest"}) {
    INFO(name);
    CHECK(text.find("Name=\"" + std::string(name) + "\"") != std::string::npos);
  }
  crest::io::write_reeb(folder / "b.vtp", stage.scene(true));
  CHECK(read_text(folder / "b.vtp") == text);
  crest::io::write_reeb(folder / "c.vtp", stage.scene(false));
  CHECK(read_text(folder / "c.vtp").find("NumberOfPolys=\"0\"") != std::string::npos);
  CHECK_THROWS_AS(crest::io::write_reeb(folder / "a.ply", stage.scene()),
                  crest::kernel::InputError);
}

TEST_CASE("arcs run upwards from node to node along the middles of what lies on them", "[io]") {
  const Stage stage = torus_stage();
  const auto lines = crest::io::arc_polylines(stage.scene());
  REQUIRE(lines.size() == stage.graph.arcs.size());
  double left = 0, right = 0;
  for (std::size_t a = 0; a < lines.size(); ++a) {
    CHECK(lines[a].size() <= 14);
    for (std::size_t i = 0; i + 1 < lines[a].size(); ++i)
      CHECK(lines[a][i].value <= lines[a][i + 1].value);
    for (const auto& place : lines[a]) {
      left = std::min(left, place.point[1]);
      right = std::max(right, place.point[1]);
    }
  }
  // The two arcs around the hole do not fall together.
  CHECK(left < -1);
  CHECK(right > 1);
}

TEST_CASE("pictures are the same each time, in both formats", "[io]") {
  const TemporaryFolder folder;
  const Stage stages[] = {
      torus_stage(),
      {mesh_of(moebius_grid(12, [](const Vec3& p) { return p[0] * p[1]; }))},
      {mesh_of(square_grid(3, [](const Vec3& p) { return p[0] * p[0] - p[1]; }))},
      {mesh_of(square_grid(3, [](const Vec3&) { return 1.0; }))}};
  for (const Stage& stage : stages) {
    crest::io::write_reeb_picture(folder / "a.svg", stage.scene());
    crest::io::write_reeb_picture(folder / "b.svg", stage.scene());
    CHECK(read_text(folder / "a.svg") == read_text(folder / "b.svg"));
    const std::string svg = read_text(folder / "a.svg");
    std::size_t circles = 0;
    for (auto at = svg.find("<circle"); at != svg.npos; at = svg.find("<circle", at + 1)) ++circles;
    CHECK(circles >= stage.graph.nodes.size());  // all in the graph, those in sight on the surface
    const auto image = svg.find("base64,"), rest = svg.find('"', image);
    CHECK(svg.find("nan", rest) == svg.npos);
    CHECK(svg.find("inf", rest) == svg.npos);
    crest::io::write_reeb_picture(folder / "a.png", stage.scene());
    CHECK(read_text(folder / "a.png").starts_with("\x89PNG"));
  }
  CHECK_THROWS_AS(crest::io::write_reeb_picture(folder / "a.pdf", stages[0].scene()),
                  crest::kernel::InputError);
}

TEST_CASE("a graph's branches get columns of their own where they overlap", "[io]") {
  // Node 0 up to 5; a loop from 1 to 4 beside; a twig from 2 to 3 off the main branch.
  const ReebGraph graph = graph_of(6, {{0, 1}, {1, 2}, {1, 4}, {2, 3}, {2, 4}, {4, 5}});
  const GraphLayout layout = crest::io::lay_out(graph, ranks(6));
  CHECK(layout.left_out == 0);
  CHECK(layout.columns == 3);
  const auto column = layout.node_column[0];
  for (const std::size_t v : {1u, 4u, 5u}) CHECK(layout.node_column[v] == column);
  CHECK(layout.arc_column[0] == layout.arc_column[5]);
  CHECK(layout.arc_column[1] != layout.arc_column[2]);
  CHECK(layout.arc_column[3] != layout.arc_column[4]);
  for (const int c : layout.arc_column) {
    CHECK(c >= 0);
    CHECK(c < layout.columns);
  }
  // Parallel arcs, components, a lone node.
  const GraphLayout two =
      crest::io::lay_out(graph_of(7, {{0, 1}, {1, 2}, {1, 2}, {2, 3}, {4, 5}}), ranks(7));
  CHECK(two.arc_column[1] != two.arc_column[2]);
  CHECK(two.node_column[4] != kNoColumn);
  CHECK(two.node_column[6] != kNoColumn);
  CHECK(two.node_column[4] != two.node_column[0]);
  const GraphLayout few = crest::io::lay_out(graph, ranks(6), 1);
  CHECK(few.left_out > 0);
  CHECK(few.columns == 1);
}
