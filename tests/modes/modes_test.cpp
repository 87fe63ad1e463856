// SPDX-License-Identifier: GPL-3.0-or-later
// The reference table: Euler characteristic, components, boundary loops on several meshes.
#include "algorithms/modes/modes.hpp"

#include <tbb/task_arena.h>

#include <catch2/catch.hpp>
#include <random>

#include "algorithms/modes/planar_pieces.hpp"
#include "tests/modes/samples.hpp"
#include "tests/support/random.hpp"

using namespace crest;
using namespace crest::tests;
using modes::Level;

namespace {

constexpr Level kLevels[] = {{0, 1}, {3, 10}, {3, 5}, {9, 10}};

void check_level(const modes::ModeField& field, const Level& level, const ModeCounts& plus,
                 const ModeCounts& minus) {
  INFO("mode " << level.p << "/" << level.q);
  const auto r = modes::extract(field, level);
  CHECK(r.undecided.empty());
  REQUIRE(r.surfaces.size() == (level.neutral() ? 1U : 2U));
  const ModeCounts* expected[] = {&plus, &minus};
  for (std::size_t k = 0; k < r.surfaces.size(); ++k) {
    const auto& s = r.surfaces[k];
    INFO("sign " << s.sign);
    CHECK(counts_of(s) == *expected[k]);
    CHECK(s.watertight);
    for (const auto& c : s.components) CHECK(c.orientable);
    CHECK(s.unproven_pieces == 0);
    CHECK(s.max_mode_error < 1e-12);
  }
}

void check_row(const Row& row, const modes::ModeField& field) {
  check_level(field, kLevels[0], row.neutral, {});
  for (std::size_t k = 0; k < 3; ++k)
    check_level(field, kLevels[k + 1], row.pairs[k][0], row.pairs[k][1]);
}

}  // namespace

TEST_CASE("the reference fields have their counts on a grid of 3") {
  for (const Row& row : small_boxes()) {
    INFO("field " << row.name);
    check_row(row, box(row.rows, 2, 3, Cut::diagonal));
  }
}

TEST_CASE("the reference fields have their counts on mirrored grids of 5 and 8") {
  for (const Row& row : small_boxes()) {
    INFO("field " << row.name);
    check_row(row, box(row.rows, 2, 5, Cut::mirrored));
  }
  check_row(small_boxes()[2], box(small_boxes()[2].rows, 2, 8, Cut::mirrored));
}

TEST_CASE("the reference fields have their counts in a large box") {
  for (const Row& row : large_boxes()) {
    INFO("field " << row.name);
    check_row(row, box(row.rows, 60, 5, Cut::diagonal));
  }
}

TEST_CASE("the piecewise linear fields have their counts") {
  const auto& f = piecewise_linear();
  const auto one = box(f[0], 1.5, 5, Cut::diagonal), two = box(f[1], 1.5, 5, Cut::diagonal);
  check_level(one, {0, 1}, {0, 1, 2}, {});
  check_level(one, {1, 2}, {0, 1, 2}, {1, 2, 3});
  check_level(one, {4, 5}, {-3, 1, 3}, {2, 2, 2});
  check_level(two, {0, 1}, {1, 2, 3}, {});
  check_level(two, {1, 2}, {2, 2, 2}, {0, 2, 2});
  check_level(two, {4, 5}, {-1, 1, 3}, {0, 1, 2});
}

TEST_CASE("the levels at both sides of a node are surfaces") {
  const auto field = box(rows_of(node_field()), 400, 5, Cut::diagonal);
  check_level(field, {41, 100}, {0, 2, 4}, {-2, 1, 4});
  check_level(field, {21, 50}, {0, 2, 4}, {0, 2, 4});
}

TEST_CASE("thin tubes and small modes are surfaces") {
  const auto field = box(small_boxes()[2].rows, 2, 3, Cut::diagonal);
  for (const Level& level : {Level{999, 1000}, Level{1, 1'000'000}}) {
    const auto r = modes::extract(field, level);
    CHECK(r.undecided.empty());
    for (const auto& s : r.surfaces) CHECK(s.watertight);
  }
}

TEST_CASE("vertices have their mode and pieces their projection on random tensors") {
  Random random(5);
  const auto field =
      random_box(4, [&] { return std::uniform_real_distribution<double>(-1, 1)(random); });
  for (const Level& level : {Level{0, 1}, Level{1, 2}, Level{97, 100}}) {
    const auto r = modes::extract(field, level);
    CHECK(r.undecided.empty());
    for (const auto& s : r.surfaces) {
      CHECK(s.watertight);
      CHECK(s.max_mode_error < 1e-12);
      CHECK(s.unproven_pieces == 0);
    }
  }
}

// Exact zeros of f at vertices, along edges and in whole faces; projections that cross.
TEST_CASE("vertices have their mode on small integers, whatever the projections and the threads") {
  Random random(6);
  const auto field =
      random_box(5, [&] { return static_cast<double>(static_cast<int>(random() % 5) - 2); });
  modes::ModeOptions options;
  options.budget = 2000;
  for (const Level& level : {Level{0, 1}, Level{1, 2}}) {
    modes::ModeResult again;
    tbb::task_arena(1).execute([&] { again = modes::extract(field, level, options); });
    const auto r = modes::extract(field, level, options);
    for (std::size_t k = 0; k < r.surfaces.size(); ++k) {
      const auto& s = r.surfaces[k];
      CHECK(s.max_mode_error < 1e-12);
      CHECK((s.watertight || !r.undecided.empty()));
      CHECK(s.points == again.surfaces[k].points);
      CHECK(s.triangles == again.surfaces[k].triangles);
    }
  }
}

TEST_CASE("loops that cross, touch or are not nested have no triangulation") {
  // A pentagram; a square with a corner on its opposite side; two squares that cross.
  std::vector<modes::PlanarPiece> pieces(3);
  pieces[0].points = {{0, 3}, {2, -3}, {-3, 1}, {3, 1}, {-2, -3}};
  pieces[1].points = {{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}};
  pieces[2].points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 2}, {2, 6}, {6, 6}, {6, 2}};
  for (auto& piece : pieces) {
    piece.facets.assign(piece.points.size(), 0);
    piece.loops = {{0, 1, 2, 3}};
    if (piece.points.size() == 5) piece.loops[0].push_back(4);
    if (piece.points.size() == 8) piece.loops.push_back({4, 5, 6, 7});
    CHECK_FALSE(modes::triangulate(piece).has_value());
  }
}
