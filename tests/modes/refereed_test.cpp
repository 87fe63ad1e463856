// SPDX-License-Identifier: GPL-3.0-or-later
// The holes that were found in earlier statements of the theorem, each with its numbers.
#include <catch2/catch.hpp>

#include "algorithms/modes/cell_topology.hpp"
#include "algorithms/modes/modes.hpp"
#include "tests/modes/samples.hpp"

using namespace crest;
using namespace crest::tests;
using modes::Level;

namespace {

/// Tetrahedra over a triangle: the corners' rows (deviators), one apex or two.
modes::ModeField over_triangle(const Rows& rows) {
  std::vector<kernel::Vec3> points = {
      {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, 1}, {0.3, 0.3, -1}};
  points.resize(rows.size());
  std::vector<std::array<double, 6>> tensors;
  for (const auto& r : rows) {
    std::array<double, 5> x{};
    for (std::size_t k = 0; k < 5; ++k) x[k] = r[k];
    tensors.push_back(tensor_of(x));
  }
  std::vector<kernel::TetMesh::Tet> tets = {{0, 1, 2, 3}};
  if (rows.size() == 5) tets.push_back({0, 2, 1, 4});
  return {kernel::TetMesh(points, tets), tensors};
}

/// -T: its mode is the opposite.
modes::ModeField negated(modes::ModeField field) {
  for (auto& t : field.tensors)
    for (double& x : t) x = -x;
  return field;
}

}  // namespace

TEST_CASE("refereed 1: three loops and two pieces are not told apart") {
  CHECK(modes::piece_count(3, 2, 1) == std::nullopt);
  CHECK(modes::piece_count(1, 1, 1) == 1U);
  CHECK(modes::piece_count(2, 2, 1) == 2U);
  CHECK(modes::piece_count(2, 1, 1) == 1U);
  CHECK(modes::piece_count(0, 1, 0) == 0U);
}

TEST_CASE("refereed 2: a lone vertex at the mode exactly, and its mirror image") {
  // diag(-11, 13, -2) has mode +143/343; the others less.

  auto field = box({{-3, 4, 1, 1, 1}}, 1, 3, Cut::diagonal);
  for (auto& t : field.tensors) t = tensor_of({-12, 12, 0.25, 0.5, 0.125});
  field.tensors[13] = tensor_of({-11, 13, 0, 0, 0});
  const Level level{143, 343};
  const auto a = modes::extract(field, level), b = modes::extract(negated(field), level);
  CHECK(a.undecided == b.undecided);
  CHECK(counts_of(a.surfaces[0]) == counts_of(b.surfaces[1]));
  CHECK(counts_of(a.surfaces[1]) == counts_of(b.surfaces[0]));
  CHECK(a.surfaces[0].watertight);
  // A small sphere round the vertex.
  CHECK(counts_of(a.surfaces[0]) == ModeCounts{2, 1, 0});
}

TEST_CASE("refereed 2: the mirror image of a field has its levels exchanged") {
  for (const Row& row : small_boxes()) {
    const auto field = box(row.rows, 2, 3, Cut::diagonal);
    const auto a = modes::extract(field, {3, 5}), b = modes::extract(negated(field), {3, 5});
    CHECK(counts_of(a.surfaces[0]) == counts_of(b.surfaces[1]));
    CHECK(counts_of(a.surfaces[1]) == counts_of(b.surfaces[0]));
  }
}

TEST_CASE("refereed 3: det touches 0 from below at an edge's midpoint: a cap is not lost") {
  const auto field =
      over_triangle({{1, -1, 0, 0, -1}, {1, -1, 0, 0, 1}, {1, -3, 0, 0, 0}, {1, -3, 1, 0, 0}});
  const auto r = modes::extract(field, {0, 1});
  CHECK(r.undecided.empty());
  CHECK(counts_of(r.surfaces[0]) == ModeCounts{1, 1, 1});
}

TEST_CASE("refereed 4: tangent edges have two roots or none") {
  // Along the first edge det = t^2 (none), then -t^2 (two).
  for (const int sign : {1, -1}) {
    const Rows rows =
        sign > 0 ? Rows{{1, -1, 0, -1, 0}, {1, -1, 0, 1, 0}, {1, -3, 0, 0, 0}, {1, -3, 1, 0, 0}}
                 : Rows{{1, -1, 0, 0, -1}, {1, -1, 0, 0, 1}, {2, -1, 1, 0, 0}, {1, 2, 0, 1, 0}};
    const auto r = modes::extract(over_triangle(rows), {0, 1});
    for (const auto& s : r.surfaces) CHECK(s.watertight == r.undecided.empty());
  }
}

TEST_CASE("refereed 5: two sheets that touch in a point of a face are undecided, listed") {
  const auto field = over_triangle({{1, -1, 0, 2, 1},
                                    {1, -1, 0, -1, 1},
                                    {1, -1, 0, -1, -2},
                                    {-1, -1, 0, 0, 0},
                                    {-1, -1, 0, 0, 0}});
  modes::ModeOptions options;
  options.max_depth = 12;
  const auto r = modes::extract(field, {0, 1}, options);
  CHECK(r.undecided.size() == 2);
}

TEST_CASE("refereed 6: the surface is a cone where the tensor is zero") {
  auto field = box(small_boxes()[2].rows, 2, 3, Cut::diagonal);
  field.tensors[13] = {5, 5, 5, 0, 0, 0};
  for (const Level& level : {Level{0, 1}, Level{3, 5}}) {
    const auto r = modes::extract(field, level);
    CHECK(r.undecided.empty());
    for (const auto& s : r.surfaces) {
      CHECK(s.watertight);
      CHECK(s.zero_rims == 0);
      if (!s.triangles.empty()) CHECK(s.singular_points.size() <= 1);
    }
  }
}

TEST_CASE("refereed 6: surfaces end on edges where the tensor is zero") {
  auto field = box(small_boxes()[2].rows, 2, 4, Cut::diagonal);
  for (std::size_t v = 0; v < field.tensors.size(); ++v)
    if (field.mesh.points()[v][0] < 0) field.tensors[v] = {};
  const auto r = modes::extract(field, {3, 5});
  CHECK(r.undecided.empty());
  for (const auto& s : r.surfaces) CHECK(s.watertight);
}

TEST_CASE("a uniform mode carries no surface") {
  auto field = box(rows_of(node_field()), 1, 3, Cut::diagonal);
  for (auto& t : field.tensors) t = {-11, 13, -2, 0, 0, 0};
  const auto r = modes::extract(field, {143, 343});
  CHECK(r.counts.uniform == r.counts.total);
  CHECK(r.surfaces[0].triangles.empty());
  CHECK(r.surfaces[1].triangles.empty());
}

TEST_CASE("a node at the mode exactly leaves its own cells undecided") {
  const auto field = box(rows_of(node_field()), 10, 4, Cut::diagonal);
  modes::ModeOptions options;
  options.max_depth = 16;
  const auto r = modes::extract(field, {143, 343}, options);
  CHECK(!r.undecided.empty());
  CHECK(r.undecided.size() <= 6);
}
