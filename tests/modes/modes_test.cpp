// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/modes.hpp"

#include <catch2/catch.hpp>

#include "tests/modes/samples.hpp"

using namespace crest::tests;

TEST_CASE("points are counted by place, and those that are corners of cells") {
  const auto census = crest::modes::take_census(one_cell());
  CHECK(census.distinct == 4);
  CHECK(census.used == 4);
  auto twice = one_cell();
  twice.points.push_back(twice.points.front());
  CHECK(crest::modes::take_census(twice).distinct == 4);
  CHECK(crest::modes::take_census(twice).used == 4);
  CHECK(crest::modes::take_census({}).distinct == 0);
}
