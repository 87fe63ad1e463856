// SPDX-License-Identifier: GPL-3.0-or-later
// Sharp edges and the graphs of edges: boxes with known answers, pruning, joining, collapsing.
#include "algorithms/feature_lines/sharp_edges.hpp"

#include <catch2/catch.hpp>
#include <numeric>

#include "algorithms/feature_lines/feature_lines.hpp"
#include "tests/feature_lines/meshes.hpp"
#include "tests/support/environment.hpp"

using namespace crest::tests;
namespace fl = crest::feature_lines;
using crest::kernel::DecimalAngle;

namespace {

double total_length(const fl::FeatureGraph& graph) {
  double sum = 0;
  for (const auto& line : graph.lines) sum += line.length;
  return sum;
}

void require_box(const fl::FeatureGraph& graph, double length) {
  CHECK(graph.nodes.size() == 8);
  CHECK(graph.count(fl::LineKind::arc) == 12);
  CHECK(graph.lines.size() == 12);
  CHECK(graph.node_edges.empty());
  CHECK(graph.patch_sizes.size() == 6);
  CHECK(total_length(graph) == Approx(length).epsilon(1e-12));
}

/// Turned about two axes, scaled, moved.
TriangleMesh moved(const TriangleMesh& mesh, double turn, double scale) {
  std::vector<Vec3> points;
  const double c = std::cos(turn), s = std::sin(turn);
  for (const Vec3& p : mesh.points()) {
    const Vec3 q = {c * p[0] - s * p[1], s * p[0] + c * p[1], p[2]};
    points.push_back(
        {scale * (q[0] + 1), scale * (c * q[1] - s * q[2]), scale * (s * q[1] + c * q[2])});
  }
  return TriangleMesh(points, mesh.faces());
}

/// A sheet folded along x = 4, `up` and down again along x = 6 if asked for.
TriangleMesh folded(double slope, bool twice) {
  const TriangleMesh flat = grid(10, 8);
  std::vector<Vec3> points = flat.points();
  for (Vec3& p : points)
    p[2] = slope * (std::max(0.0, p[0] - 4) - (twice ? std::max(0.0, p[0] - 6) : 0));
  return TriangleMesh(points, flat.faces());
}

}  // namespace

TEST_CASE("the sharp edges of a box are its twelve edges, however coarse, turned or scaled") {
  for (const int s : {1, 2, 5}) {
    const TriangleMesh box = plate(0, s);
    for (const char* angle : {"0", "30", "60", "89.9999999999999999999"}) {
      const auto lines = fl::extract_sharp_lines(box, DecimalAngle(angle), {});
      INFO(s << " a side, " << angle << " degrees");
      require_box(lines.graph, 20.0 * s);
      CHECK(fl::count(lines.sharp) == static_cast<Index>(20 * s));
      CHECK(lines.ties == (std::string(angle) == "0" ? box.edge_count() - 20u * Index(s) : 0u));
      CHECK(lines.decided.calls == box.edge_count());
      // Patches are numbered by their first faces.
      Index seen = 0;
      for (const Index patch : lines.graph.face_patch) {
        CHECK(patch <= seen);
        seen = std::max(seen, patch + 1);
      }
    }
    const auto right = fl::extract_sharp_lines(box, DecimalAngle("90"), {});
    CHECK(fl::count(right.sharp) == 0);
    CHECK(right.ties == static_cast<Index>(20 * s));
    CHECK(right.graph.patch_sizes.size() == 1);
    CHECK(right.graph.lines.empty());
    for (const double scale : {1e-30, 1.0, 1e40})
      require_box(fl::extract_sharp_lines(moved(box, 0.7, scale), DecimalAngle("60"), {}).graph,
                  20 * s * scale);
  }
}

TEST_CASE("a fold from boundary to boundary is an arc between two patches") {
  const TriangleMesh sheet = folded(1, false);
  CHECK(fl::count(fl::extract_sharp_lines(sheet, DecimalAngle("45"), {}).sharp) == 0);
  CHECK(fl::extract_sharp_lines(sheet, DecimalAngle("45"), {}).ties == 8);
  const auto fold = fl::extract_sharp_lines(sheet, DecimalAngle("44"), {});
  REQUIRE(fold.graph.lines.size() == 1);
  CHECK(fold.graph.lines[0].kind == fl::LineKind::arc);
  CHECK(fold.graph.lines[0].ends[0] == fl::EndKind::boundary);
  CHECK(fold.graph.lines[0].length == 8);
  CHECK(fold.graph.patch_sizes.size() == 2);
  CHECK(fl::extract_sharp_lines(folded(1, true), DecimalAngle("44"), {}).graph.patch_sizes.size() ==
        3);
  // No angle is above 180 degrees, none without a second face.
  CHECK(fl::count(fl::extract_sharp_lines(sheet, DecimalAngle("180"), {}).sharp) == 0);
}

TEST_CASE("sharp edges: short open lines are pruned, gaps are closed, of one edge too") {
  const TriangleMesh mesh = grid(14, 8);
  const auto row = [&](Marks& edges, Index from, Index to) {
    for (Index e = 0; e < mesh.edge_count(); ++e) {
      const auto& [v0, v1, f0, f1] = mesh.edges()[e];
      if (v0 / 15 == 4 && v1 == v0 + 1 && v0 % 15 >= from && v1 % 15 <= to) edges[e] = 1;
    }
  };
  for (const Index gap : {1u, 2u, 3u}) {
    Marks edges(mesh.edge_count(), 0);
    row(edges, 2, 6);
    row(edges, 6 + gap, 12);
    const fl::FeatureGraph graph = fl::build_edge_graph(mesh, edges);
    CHECK(graph.count(fl::LineKind::isolated) == 2);
    CHECK(graph.patch_sizes.size() == 1);
    INFO("a gap of " << gap);
    CHECK(fl::joining_paths(mesh, graph, {1, gap - 1}).empty());
    const auto paths = fl::joining_paths(mesh, graph, {1, gap});
    REQUIRE(paths.size() == 1);
    CHECK(paths[0].size() == gap + 1);
  }
  // The fold ends in the sheet: pruned from as many vertices on as it has.
  std::vector<Vec3> points = grid(10, 8).points();
  for (Vec3& p : points) p[2] = p[1] < 4.5 ? std::max(0.0, p[0] - 4) * (4.5 - p[1]) : 0;
  const TriangleMesh fading(points, grid(10, 8).faces());
  const auto all = fl::extract_sharp_lines(fading, DecimalAngle("40"), {});
  REQUIRE(all.graph.count(fl::LineKind::branch) + all.graph.count(fl::LineKind::isolated) > 0);
  const auto none = fl::extract_sharp_lines(fading, DecimalAngle("40"), {1000, 0});
  CHECK(none.graph.count(fl::LineKind::branch) + none.graph.count(fl::LineKind::isolated) == 0);
  CHECK(none.pruned > 0);
  CHECK(none.sharp == all.sharp);
}

TEST_CASE("angles over rings: exact on folds, small across noise, the field of the vertices") {
  const TriangleMesh sheet = folded(1, false);
  for (const Index rings : {0u, 1u, 2u, 3u}) {
    const auto angles = fl::vertex_angles(sheet, rings);
    for (Index v = 0; v < sheet.vertex_count(); ++v) {
      const double x = sheet.points()[v][0];
      INFO(rings << " rings, vertex " << v);
      if (x == 4) CHECK(angles[v] == Approx(45).epsilon(1e-9));
      if (std::abs(x - 4) > rings + 1) CHECK(angles[v] == Approx(0).margin(1e-6));
      if (rings > 0 && x != 4) CHECK(angles[v] < (std::abs(x - 4) == 1 ? 45.001 : 44));
    }
  }
  // The whole pipeline: one arc along the fold although noise gives single edges large angles.
  Random random(kSeed);
  std::vector<Vec3> points = folded(1, false).points();
  for (Vec3& p : points)
    for (double& x : p) x += 0.15 * (static_cast<double>(random() % 1000000) * 2e-6 - 1);
  const TriangleMesh noisy(points, sheet.faces());
  const auto field = fl::vertex_angles(noisy, 2);
  fl::Options options;
  options.value = 30;
  options.prune = 2;
  const auto lines = fl::extract_feature_lines(noisy, field, options);
  CHECK(lines.graph.count(fl::LineKind::arc) >= 1);
  for (Index v = 0; v < noisy.vertex_count(); ++v)
    if (lines.marks[v]) CHECK(std::abs(sheet.points()[v][0] - 4) <= 1);
}

TEST_CASE("collapsing marked faces keeps the topology, patches are those of the complement") {
  Random random(kSeed + 5);
  Index collapsed = 0;
  for (const auto& [name, mesh] : sample_meshes()) {
    for (int i = 0; i < 20; ++i) {
      Marks region = random_marks(mesh, random, i % 2 ? 0.25 : 0.06, Index(i % 3));
      const Marks marks = i % 4 == 3 ? region : fl::thin(mesh, region, Index(i % 3)).after;
      INFO(name << ", set " << i);
      if (fl::count(marks) == mesh.vertex_count()) continue;
      const fl::FeatureGraph graph = fl::build_feature_graph(mesh, marks);
      const fl::Topology topology = fl::topology_of(mesh, marks);
      CHECK(graph.patch_sizes.size() == topology.complement.b0);
      CHECK(std::accumulate(graph.patch_sizes.begin(), graph.patch_sizes.end(), Index{0}) +
                fl::count(marks) ==
            mesh.vertex_count());
      // Vertices and edges of lines and nodes, each once.
      std::set<Index> vertices;
      std::set<std::pair<Index, Index>> edges;
      Index ends = 0, listed = static_cast<Index>(graph.node_edges.size());
      const auto add = [&](Index a, Index b) { edges.insert(std::minmax(a, b)); };
      for (const auto& [a, b] : graph.node_edges) add(a, b);
      for (const auto& node : graph.nodes) vertices.insert(node.begin(), node.end());
      for (const auto& line : graph.lines) {
        vertices.insert(line.vertices.begin(), line.vertices.end());
        const auto n = static_cast<Index>(line.vertices.size());
        const Index steps = line.kind == fl::LineKind::loop ? n : n - 1;
        listed += steps;
        for (Index k = 0; k < steps; ++k) add(line.vertices[k], line.vertices[(k + 1) % n]);
        ends += line.kind == fl::LineKind::branch;
      }
      CHECK(vertices.size() == fl::count(marks));
      CHECK(edges.size() == listed);
      CHECK(static_cast<int>(vertices.size()) - static_cast<int>(edges.size()) ==
            topology.marked.euler);
      Index in_set = 0;
      for (const auto& e : mesh.edges()) in_set += marks[e.v0] && marks[e.v1];
      collapsed += in_set - listed;
      // Every vertex knows the patch of its faces.
      for (Index v = 0; v < mesh.vertex_count(); ++v)
        for (const Index f : mesh.fan(v))
          if (!marks[v]) CHECK(graph.face_patch[f] == graph.patch_of[v]);
    }
  }
  CHECK(collapsed > 50);
}
