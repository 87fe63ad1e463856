// SPDX-License-Identifier: GPL-3.0-or-later
// Thresholds and morphological operators with known answers.
#include <catch2/catch.hpp>

#include "algorithms/feature_lines/marks.hpp"
#include "kernel/geometry/input_error.hpp"
#include "tests/feature_lines/meshes.hpp"
#include "tests/support/environment.hpp"

using namespace crest::tests;
namespace fl = crest::feature_lines;
using Kind = fl::Neighbourhood;

namespace {

Marks one(const TriangleMesh& mesh, Index v) {
  Marks marks(mesh.vertex_count(), 0);
  marks[v] = 1;
  return marks;
}

bool within(const Marks& a, const Marks& b) {
  for (std::size_t v = 0; v < a.size(); ++v)
    if (a[v] && !b[v]) return false;
  return true;
}

}  // namespace

TEST_CASE("quantiles and values mark the vertices from them on") {
  const std::vector<double> field = {3, 1, 4, 1, 5, 9, 2, 6, 5, 3};
  CHECK(fl::field_quantile(field, 0) == 1);
  CHECK(fl::field_quantile(field, 0.5) == 4);
  CHECK(fl::field_quantile(field, 0.85) == 6);
  CHECK(fl::field_quantile(field, 1) == 9);
  CHECK(fl::count(fl::threshold_by_value(field, 5)) == 4);
  CHECK(fl::count(fl::threshold_by_value(field, 9.5)) == 0);
}

TEST_CASE("thresholds do not split values that are equal but for rounding") {
  // Ten flat vertices, five whose values differ in the last bits, one peak.
  std::vector<double> field(10, 0.1);
  for (const int ulps : {3, -2, 0, 1, -1}) field.push_back(4 + ulps * 0x1p-50);
  field.push_back(9);
  for (const double quantile : {0.63, 0.7, 0.8, 0.85, 0.9}) {
    CHECK(fl::count(fl::threshold_by_value(field, fl::quantile_threshold(field, quantile))) == 6);
    CHECK(fl::quantile_threshold(field, quantile) <= fl::field_quantile(field, quantile));
  }
  CHECK(fl::quantile_threshold(field, 0.5) == 0.1);
  CHECK(fl::quantile_threshold(field, 0.95) == 9);
  // Noise around zero is equal, too, beside values that are not.
  std::vector<double> noise = {5};
  for (int i = 1; i < 20; ++i) noise.push_back(i % 3 * 1e-16);
  CHECK(fl::quantile_threshold(noise, 0.5) == 0);
  // Without groups the threshold stays where it is, to a millionth.
  std::vector<double> smooth;
  for (int i = 0; i < 5000; ++i) smooth.push_back(1 + std::sin(i * 0.7) + 1e-7 * i);
  for (const double quantile : {0.1, 0.5, 0.85}) {
    const double moved = fl::quantile_threshold(smooth, quantile);
    CHECK(moved <= fl::field_quantile(smooth, quantile));
    CHECK(moved >= fl::field_quantile(smooth, quantile) * (1 - 0x1p-20));
    CHECK(fl::gap_threshold(smooth, quantile) == moved);
  }
  CHECK(fl::quantile_threshold({2, 2, 2}, 0.9) == 2);
  CHECK_THROWS_AS(fl::quantile_threshold({}, 0.5), crest::kernel::InputError);
}

TEST_CASE("a guessed quantile moves to a gap that marks half to twice as many") {
  const auto marked = [](std::size_t low, std::size_t middle, std::size_t high) {
    std::vector<double> field;
    for (std::size_t i = 0; i < low; ++i) field.push_back(1 + 0.001 * static_cast<double>(i));
    for (std::size_t i = 0; i < middle; ++i) field.push_back(2 + 0.001 * static_cast<double>(i));
    for (std::size_t i = 0; i < high; ++i) field.push_back(4 + 0.001 * static_cast<double>(i));
    return fl::count(fl::threshold_by_value(field, fl::gap_threshold(field, 0.85)));
  };
  CHECK(marked(76, 0, 24) == 24);   // below the quantile
  CHECK(marked(90, 0, 10) == 10);   // above it
  CHECK(marked(60, 0, 40) == 15);   // too far below
  CHECK(marked(96, 0, 4) == 15);    // too far above: not a few outliers instead
  CHECK(marked(75, 15, 10) == 10);  // two gaps: the wider one
  CHECK(marked(75, 20, 5) == 25);
  // Values below zero have no ratio.
  std::vector<double> negative;
  for (int i = 0; i < 100; ++i) negative.push_back(i < 80 ? -8 : -1);
  CHECK(fl::gap_threshold(negative, 0.85) == -1);
}

TEST_CASE("dilation of one vertex of a grid: rings, Euclidean balls, edge paths") {
  // Inside the grid a vertex has six neighbours: four at distance 1, two along the diagonal.
  const TriangleMesh mesh = grid(10, 10);
  const Marks seed = one(mesh, 5 + 11 * 5);
  CHECK(fl::count(fl::dilate(mesh, seed, {Kind::rings, 0})) == 1);
  CHECK(fl::count(fl::dilate(mesh, seed, {Kind::rings, 1})) == 7);
  CHECK(fl::count(fl::dilate(mesh, seed, {Kind::rings, 2})) == 19);
  CHECK(fl::count(fl::dilate(mesh, seed, {Kind::euclidean, 0.9})) == 1);
  CHECK(fl::count(fl::dilate(mesh, seed, {Kind::euclidean, 1})) == 5);
  // (1, -1) is at distance 1.41 and reached through (1, 0), which is in the ball.
  CHECK(fl::count(fl::dilate(mesh, seed, {Kind::euclidean, 1.5})) == 9);
  CHECK(fl::count(fl::dilate(mesh, seed, {Kind::euclidean, 2})) == 13);
  CHECK(fl::count(fl::dilate(mesh, seed, {Kind::path, 1})) == 5);
  CHECK(fl::count(fl::dilate(mesh, seed, {Kind::path, 1.5})) == 7);
  // Along edges (1, -1) is 2 away.
  CHECK(fl::count(fl::dilate(mesh, seed, {Kind::path, 2})) == 13);
}

TEST_CASE("Euclidean balls do not jump between sheets") {
  // Two parallel sheets 0.1 apart in one mesh: components of their own.
  std::vector<Vec3> points = grid(4, 4).points();
  std::vector<Triangle> faces = grid(4, 4).faces();
  for (Index v = 0; v < 25; ++v) points.push_back({points[v][0], points[v][1], 0.1});
  for (std::size_t f = 0; f < 32; ++f)
    faces.push_back({faces[f][0] + 25, faces[f][1] + 25, faces[f][2] + 25});
  const TriangleMesh mesh(points, faces);
  const Marks grown = fl::dilate(mesh, one(mesh, 12), {Kind::euclidean, 1});
  CHECK(fl::count(grown) == 5);
}

TEST_CASE("erosion, opening and closing on a grid") {
  const TriangleMesh mesh = grid(10, 10);
  Marks square(mesh.vertex_count(), 0);
  for (Index y = 3; y <= 7; ++y)
    for (Index x = 3; x <= 7; ++x) square[x + 11 * y] = 1;
  CHECK(fl::count(fl::erode(mesh, square, {Kind::rings, 1})) == 9);
  CHECK(fl::count(fl::erode(mesh, square, {Kind::rings, 2})) == 1);
  CHECK(fl::count(fl::erode(mesh, square, {Kind::rings, 3})) == 0);
  // A spike goes with opening, a hole with closing.
  Marks spiked = square;
  spiked[8 + 11 * 5] = 1;
  const Marks opened = fl::opening(mesh, spiked, {Kind::rings, 1});
  CHECK(opened[8 + 11 * 5] == 0);
  Marks holed = square;
  holed[5 + 11 * 5] = 0;
  CHECK(fl::closing(mesh, holed, {Kind::rings, 1})[5 + 11 * 5] == 1);
}

TEST_CASE("adjunction: opening shrinks, closing grows, both are idempotent") {
  Random random(kSeed);
  for (const auto& [name, mesh] : sample_meshes()) {
    for (const Kind kind : {Kind::rings, Kind::euclidean, Kind::path}) {
      const fl::Structure s{kind, kind == Kind::rings ? 2.0 : 1.5};
      for (std::uint64_t i = 0; i < scaled(4); ++i) {
        const Marks marks = random_marks(mesh, random, 0.1, Index(i % 3));
        INFO(name << ", kind " << static_cast<int>(kind));
        const Marks opened = fl::opening(mesh, marks, s), closed = fl::closing(mesh, marks, s);
        CHECK(within(opened, marks));
        CHECK(within(marks, closed));
        CHECK(within(fl::erode(mesh, marks, s), marks));
        CHECK(fl::opening(mesh, opened, s) == opened);
        CHECK(fl::closing(mesh, closed, s) == closed);
      }
    }
  }
}
