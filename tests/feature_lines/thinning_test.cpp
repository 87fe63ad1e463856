// SPDX-License-Identifier: GPL-3.0-or-later
// Thinning: topology kept on random sets, thin results, pruning with history.
#include <catch2/catch.hpp>

#include "algorithms/feature_lines/feature_lines.hpp"
#include "kernel/geometry/input_error.hpp"
#include "tests/feature_lines/meshes.hpp"
#include "tests/support/environment.hpp"

using namespace crest::tests;
namespace fl = crest::feature_lines;

namespace {

/// The marked vertices of a grid of width m + 1, by a picture: rows from y = 0, '#' marked.
Marks picture(const std::vector<std::string>& rows) {
  Marks marks;
  for (const auto& row : rows)
    for (const char c : row) marks.push_back(c == '#' ? 1 : 0);
  return marks;
}

std::vector<std::string> rows_of(const Marks& marks, std::size_t width) {
  std::vector<std::string> rows;
  for (std::size_t v = 0; v < marks.size(); ++v) {
    if (v % width == 0) rows.emplace_back();
    rows.back() += marks[v] ? '#' : '.';
  }
  return rows;
}

}  // namespace

TEST_CASE("thinning keeps the topology of random sets, replayed by brute force") {
  Random random(kSeed);
  std::uint64_t removed = 0;
  for (const auto& [name, mesh] : sample_meshes()) {
    for (std::uint64_t i = 0; i < scaled(12); ++i) {
      const double density = i % 3 == 0 ? 0.5 : 0.06;
      const Marks region = random_marks(mesh, random, density, Index(i % 4));
      const Index prune = Index(i % 5);
      INFO(name << ", set " << i << ", prune " << prune);
      std::vector<double> field;
      if (i % 2 == 1)
        for (Index v = 0; v < mesh.vertex_count(); ++v) field.push_back(double(random() % 50));
      const fl::Thinning t = fl::thin(mesh, region, prune, field);
      CHECK(t.before == region);
      CHECK(t.topology_before == t.topology_after);
      CHECK(betti_by_ranks(mesh, t.after, 1) == betti_by_ranks(mesh, region, 1));
      CHECK(betti_by_ranks(mesh, t.after, 0) == betti_by_ranks(mesh, region, 0));
      // The order of removals leads from before to after.
      Marks marks = t.before;
      bool simple = true;
      for (const Index v : t.removed) {
        simple = simple && marks[v] && fl::is_simple(mesh, marks, v);
        marks[v] = 0;
      }
      CHECK(simple);
      CHECK(marks == t.after);
      removed += t.removed.size();
      for (Index v = 0; v < mesh.vertex_count(); ++v)
        if (marks[v] && fl::is_simple(mesh, marks, v))
          CHECK(fl::marked_neighbours(mesh, marks, v) == 1);
      for (const Index v : t.dropped) CHECK(fl::marked_neighbours(mesh, marks, v) == 0);
      // The same input gives the same order.
      CHECK(fl::thin(mesh, region, prune, field).removed == t.removed);
    }
  }
  CHECK(removed > 1000);
}

TEST_CASE(
    "with a field, lines run along its crest, and the numbering of vertices does not matter") {
  // The band has two middle rows; the crest wanders between them.
  const TriangleMesh mesh = grid(40, 11);
  const auto crest = [](double x) { return 5.5 + 0.5 * std::sin(0.3 * x); };
  std::vector<double> field;
  Marks band(mesh.vertex_count(), 0);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const Vec3& p = mesh.points()[v];
    // No two values alike.
    field.push_back(-std::abs(p[1] - crest(p[0])) - 1e-9 * v);
    band[v] = p[0] > 1 && p[0] < 39 && std::abs(p[1] - 5.5) < 2 ? 1 : 0;
  }
  const auto distance = [&](const Marks& marks) {
    double sum = 0;
    for (Index v = 0; v < mesh.vertex_count(); ++v) sum += marks[v] ? -field[v] : 0;
    return sum / fl::count(marks);
  };
  const fl::Thinning with = fl::thin(mesh, band, 3, field), without = fl::thin(mesh, band, 3);
  CHECK(with.topology_before == with.topology_after);
  CHECK(distance(with.after) < 0.85 * distance(without.after));
  // The same mesh with its vertices numbered backwards.
  const Index last = mesh.vertex_count() - 1;
  std::vector<Vec3> points(mesh.points().rbegin(), mesh.points().rend());
  std::vector<Triangle> faces = mesh.faces();
  for (Triangle& f : faces)
    for (Index& v : f) v = last - v;
  const TriangleMesh turned(points, faces);
  std::reverse(field.begin(), field.end());
  std::reverse(band.begin(), band.end());
  Marks after = fl::thin(turned, band, 3, field).after;
  std::reverse(after.begin(), after.end());
  CHECK(after == with.after);
}

TEST_CASE("skeletonize ends when no simple vertex is beside a centre") {
  Random random(kSeed + 1);
  for (const auto& [name, mesh] : sample_meshes()) {
    for (int i = 0; i < 6; ++i) {
      fl::Thinner thinner(mesh, random_marks(mesh, random, 0.1, 2));
      thinner.skeletonize();
      const Marks& marks = thinner.marks();
      const auto centre = [&](Index v) {
        return marks[v] && fl::marked_neighbours(mesh, marks, v) == mesh.ring(v).size();
      };
      INFO(name);
      for (Index v = 0; v < mesh.vertex_count(); ++v) {
        if (!marks[v] || centre(v) || !fl::is_simple(mesh, marks, v)) continue;
        const auto ring = mesh.ring(v);
        CHECK(std::none_of(ring.begin(), ring.end(), centre));
      }
    }
  }
}

TEST_CASE("a bar becomes its middle line, a frame a loop, a band across a sheet stays anchored") {
  const TriangleMesh mesh = grid(10, 6);
  const Marks bar = picture({"...........", "...........", ".#########.", ".#########.",
                             ".#########.", "...........", "..........."});
  const fl::Thinning line = fl::thin(mesh, bar, 0);
  const auto rows = rows_of(line.after, 11);
  CHECK(line.topology_after.marked == Betti{1, 1, 0, 0});
  CHECK(fl::count(line.after) >= 6);
  CHECK(rows[3].find("######") != std::string::npos);

  const Marks frame = picture({"...........", ".#########.", ".#########.", ".###...###.",
                               ".#########.", ".#########.", "..........."});
  const fl::Thinning loop = fl::thin(mesh, frame, 0);
  CHECK(loop.topology_after.marked == Betti{0, 1, 1, 0});
  CHECK(loop.topology_after.complement == Betti{1, 2, 1, 0});
  const fl::FeatureGraph graph = fl::build_feature_graph(mesh, fl::thin(mesh, frame, 4).after);
  REQUIRE(graph.lines.size() == 1);
  CHECK(graph.lines[0].kind == fl::LineKind::loop);
  CHECK(graph.patch_sizes.size() == 2);

  const Marks band = picture({"....###....", "....###....", "....###....", "....###....",
                              "....###....", "....###....", "....###...."});
  const fl::Thinning across = fl::thin(mesh, band, 3);
  // The two sides stay apart: a rule that looks at the marked set alone would open the ends.
  CHECK(across.topology_after.complement.b0 == 2);
  const fl::FeatureGraph cut = fl::build_feature_graph(mesh, across.after);
  REQUIRE(cut.lines.size() == 1);
  CHECK(cut.lines[0].kind == fl::LineKind::arc);
  CHECK(cut.lines[0].ends[0] == fl::EndKind::boundary);
  CHECK(cut.lines[0].ends[1] == fl::EndKind::boundary);
}

TEST_CASE("pruning drops short branches and gives long ones their length back") {
  const TriangleMesh mesh = grid(14, 8);
  // A loop with a branch of 4 vertices to the right and one of 2 to the left, a line, a point.
  const Marks lines = picture({"...............", ".............#.", "....####.......",
                               "....#..#.......", "..###..#####...", "....#..#.......",
                               "....####.......", "...............", ".#######......."});
  const auto left = [](const Marks& m) { return m[2 + 15 * 4] + m[3 + 15 * 4]; };
  const auto right = [](const Marks& m) {
    return m[8 + 15 * 4] + m[9 + 15 * 4] + m[10 + 15 * 4] + m[11 + 15 * 4];
  };
  const fl::Thinning none = fl::thin(mesh, lines, 0);
  CHECK(left(none.after) == 2);
  CHECK(none.dropped.empty());
  const fl::Thinning two = fl::thin(mesh, lines, 2);
  CHECK(left(two.after) == 0);
  CHECK(right(two.after) == 4);
  CHECK(two.dropped == std::vector<Index>{13 + 15});
  const fl::Thinning four = fl::thin(mesh, lines, 4);
  CHECK(right(four.after) == 0);
  CHECK(four.after[1 + 15 * 8] + four.after[7 + 15 * 8] == 2);
  const fl::Thinning seven = fl::thin(mesh, lines, 7);
  CHECK(seven.dropped.size() == 2);
  CHECK(seven.topology_after == seven.topology_before);
  CHECK(fl::build_feature_graph(mesh, seven.after).count(fl::LineKind::loop) == 1);
}

TEST_CASE("a thin zigzag strip is not eaten from its end") {
  // Two marked rows: no centre; the numbering runs along the strip in either orientation.
  for (const bool along : {true, false}) {
    const TriangleMesh mesh = along ? grid(40, 3) : grid(3, 40);
    Marks marks(mesh.vertex_count(), 0);
    for (Index k = 3; k <= 37; ++k)
      for (const Index row : {1u, 2u}) marks[along ? k + 41 * row : row + 4 * k] = 1;
    const fl::Thinning t = fl::thin(mesh, marks, 0);
    CHECK(fl::count(t.after) >= 33);
    CHECK(fl::count(t.after) <= 37);
  }
}

TEST_CASE("whole and empty sets stay as they are") {
  for (const auto& [name, mesh] : sample_meshes()) {
    INFO(name);
    for (const std::uint8_t mark : {std::uint8_t{0}, std::uint8_t{1}}) {
      const fl::Thinning t = fl::thin(mesh, Marks(mesh.vertex_count(), mark), 3);
      CHECK(t.removed.empty());
      CHECK(t.topology_before == t.topology_after);
      const auto graph = fl::build_feature_graph(mesh, t.after);
      CHECK(graph.lines.empty());
      CHECK(graph.patch_sizes.size() == (mark ? 0u : 1u));
    }
  }
}

TEST_CASE("a field of another length or with a NaN is bad input") {
  const TriangleMesh mesh = grid(3, 3);
  std::vector<double> field(mesh.vertex_count(), 1);
  CHECK_NOTHROW(fl::extract_feature_lines(mesh, field, {}));
  field[5] = std::nan("");
  CHECK_THROWS_AS(fl::extract_feature_lines(mesh, field, {}), crest::kernel::InputError);
  field.pop_back();
  CHECK_THROWS_AS(fl::extract_feature_lines(mesh, field, {}), crest::kernel::InputError);
  CHECK_THROWS_AS(fl::field_quantile({}, 0.5), crest::kernel::InputError);
}

TEST_CASE("filling and joining thin again: the certified thinning is the last one") {
  const TriangleMesh mesh = grid(10, 6);
  const Marks frame = picture({"...........", ".#########.", ".#.......#.", ".#.......#.",
                               ".#.......#.", ".#########.", "..........."});
  const std::vector<double> field(frame.begin(), frame.end());
  fl::Options options;
  options.value = 1;
  const fl::FeatureLines once = fl::extract_feature_lines(mesh, field, options);
  CHECK(once.thinnings == 1);
  CHECK(once.thinning.before == frame);
  options.min_patch = 25;
  const fl::FeatureLines twice = fl::extract_feature_lines(mesh, field, options);
  CHECK(twice.thinnings == 2);
  CHECK(twice.filled_patches == 1);
  CHECK(fl::count(twice.thinning.before) == fl::count(once.marks) + 21);
  CHECK(twice.thinning.topology_before == twice.thinning.topology_after);
}
