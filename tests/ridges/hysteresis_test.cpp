// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/ridges/hysteresis.hpp"

#include <catch2/catch.hpp>
#include <limits>

using namespace crest::ridges;

namespace {

/// Points a length of 1 apart, R = 2.
Profile line(std::vector<double> z, bool loop = false) {
  Profile p;
  p.loop = loop;
  p.gap.assign(z.size() - (loop ? 0 : 1), 1.0);
  p.radius.assign(z.size(), 2.0);
  p.z = std::move(z);
  return p;
}

void check(const Runs& runs, const std::vector<std::pair<std::size_t, std::size_t>>& expected) {
  REQUIRE(runs.kept.size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    CHECK(runs.kept[i].first == expected[i].first);
    CHECK(runs.kept[i].count == expected[i].second);
  }
}

}  // namespace

TEST_CASE("hysteresis: a run goes on where z is half the threshold and holds a strong point") {
  check(hysteresis(line({0, 2, 3, 4, 2, 0, 0, 0, 3, 3, 3, 0}), 4), {{1, 4}});
  check(hysteresis(line({0, 2, 3, 3.9, 2, 0, 0, 0}), 4), {});
}

TEST_CASE("hysteresis: runs shorter than R are dropped, a strong line is kept however short") {
  const Runs runs = hysteresis(line({0, 9, 9, 0, 0, 0, 9, 9, 9, 0, 0, 0, 0}), 4);
  check(runs, {{6, 3}});
  CHECK(runs.found == 2);
  check(hysteresis(line({9, 9}), 4), {{0, 2}});
  check(hysteresis(line({9}), 4), {{0, 1}});
  check(hysteresis(line({0}), 4), {});
}

TEST_CASE("hysteresis: gaps up to R are closed, longer ones are not") {
  const Runs closed = hysteresis(line({9, 9, 9, 0, 9, 9, 9, 0, 0, 9, 9, 9}), 4);
  check(closed, {{0, 7}, {9, 3}});
  CHECK(closed.closed == 1);
}

TEST_CASE("hysteresis: gaps are closed to the ends that hold") {
  Profile p = line({0, 0, 9, 9, 9, 0, 0, 0, 0, 9, 9, 9, 0});
  check(hysteresis(p, 4), {{2, 3}, {9, 3}});
  p.holds[0] = true;
  check(hysteresis(p, 4), {{0, 5}, {9, 3}});
  p.holds[1] = true;
  check(hysteresis(p, 4), {{0, 5}, {9, 4}});
}

TEST_CASE("hysteresis: a short line is kept whole between two umbilics, a short run on a crease") {
  Profile p = line({0, 9, 0});
  p.holds[0] = p.holds[1] = true;
  p.radius.assign(3, 2.5);
  check(hysteresis(p, 4), {});
  p.between_umbilics = true;
  check(hysteresis(p, 4), {{0, 3}});
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  check(hysteresis(line({0, kInfinite, kInfinite, 0, 0, 0, kInfinite, 9, 0, 0, 0}), 4), {{1, 2}});
}

TEST_CASE("hysteresis: of a short run the piece of a crease stays") {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  const auto short_run = [&](std::vector<double> z, bool loop = false) {
    Profile p = line(std::move(z), loop);
    p.radius.assign(p.z.size(), 100.0);
    return p;
  };
  check(hysteresis(short_run({0, 3, kInfinite, 3, kInfinite, 3, 0, 0, 0}), 4), {{2, 3}});
  check(hysteresis(short_run({0, 9, kInfinite, 9, 0, 0, 0, 0, 0}), 4), {});  // no segment
  // The loop is closed as a run; its crease reaches over its first point.
  check(hysteresis(short_run({kInfinite, 0, 0, 0, 0, 0, 0, 0, 3, kInfinite}, true), 4), {{9, 2}});
  const Profile p = short_run({kInfinite, 3, kInfinite, kInfinite, 3, 3}, true);
  const Run piece = crease_piece(p, {0, 6});
  CHECK(piece.first == 0);
  CHECK(piece.count == 4);
}

TEST_CASE("hysteresis: a line that is strong on 80 % of its length is kept whole") {
  std::vector<double> z(21, 9.0);
  z[5] = z[6] = z[7] = 0;  // two gaps and two halves of 20
  check(hysteresis(line(z), 4), {{0, 21}});
  z[8] = z[9] = 0;
  check(hysteresis(line(z), 4), {{0, 5}, {10, 11}});
}

TEST_CASE("hysteresis: loops have no end") {
  check(hysteresis(line({9, 9, 0, 0, 0, 0, 9, 9}, true), 4), {{6, 4}});
  check(hysteresis(line({0, 9, 9, 9, 0, 0, 9, 9, 9, 0}, true), 4), {{1, 3}, {6, 3}});
  // Every gap closed: the loop is whole.
  check(hysteresis(line({0, 9, 9, 9, 0, 9, 9, 9}, true), 4), {{0, 8}});
  check(hysteresis(line({3, 3, 4, 3, 3}, true), 4), {{0, 5}});
  check(hysteresis(line({3, 3, 3}, true), 4), {});
  Profile small = line({3, 4, 3}, true);
  check(hysteresis(small, 4), {{0, 3}});
  small.radius.assign(3, 3.5);
  check(hysteresis(small, 4), {});
}
