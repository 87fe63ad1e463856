// SPDX-License-Identifier: GPL-3.0-or-later
// The index relation and the sectors at zeros of higher order, on random fields with ties.
#include <catch2/catch.hpp>

#include "algorithms/vector_fields/boundary.hpp"
#include "algorithms/vector_fields/sectors.hpp"
#include "tests/support/failures.hpp"
#include "tests/support/random.hpp"
#include "tests/vector_fields/counts.hpp"

using namespace crest;
using namespace crest::tests;
using namespace crest::vector_fields;

namespace {

double uniform(Random& random) {
  return static_cast<double>(random() >> 11) * 0x1p-52 - 1;
}

/// Vectors at random; `range` > 0: integers up to it.
PlanarField random_field(Random& random, int cells, bool hole, int range) {
  PlanarField field = field_of(sampling::lattice_field(1, cells, hole));
  const auto one = [&] {
    return range > 0
               ? static_cast<double>(
                     static_cast<int>(random() % (2u * static_cast<unsigned>(range) + 1)) - range)
               : uniform(random);
  };
  for (auto& v : field.vectors) v = {one(), one()};
  return field;
}

struct Tally {
  int zeros = 0, fans = 0, loops = 0;
};

void check_relations(const PlanarField& field, Tally& tally) {
  const Domain domain(field);
  auto zeros = find_zeros(domain);
  std::vector<FanPortrait> portraits;
  classify_fans(domain, zeros, portraits);
  const Boundary boundary = examine_boundary(domain);
  int sum = 0;
  for (const ZeroComponent& z : zeros) {
    const CriticalPoint& item = z.item;
    ++tally.zeros;
    sum += item.index.value_or(0);
    if (!item.sectors || !item.index) continue;
    ++tally.fans;
    REQUIRE(2 * *item.index == 2 + item.sectors->elliptic - item.sectors->hyperbolic);
  }
  REQUIRE(sum == winding_around(domain, boundary, zeros));
  for (const BoundaryLoop& l : boundary.loops) {
    if (!l.winding) continue;
    ++tally.loops;
    REQUIRE(2 * (*l.winding - l.turning) == l.interior - l.exterior);
  }
}

}  // namespace

TEST_CASE("Index relation on random fields, with holes, and on integer ones") {
  Random random(19);
  Tally plain, tied;
  for (int i = 0; i < 1000 * multiplier(); ++i)
    check_relations(random_field(random, 8, i % 2 == 0, 0), plain);
  for (int i = 0; i < 600 * multiplier(); ++i)
    check_relations(random_field(random, 8, i % 2 == 0, 1 + i % 6), tied);
  CHECK(plain.loops >= 1500);
  CHECK(plain.zeros >= 10000);
  CHECK(tied.fans >= 1000);
  CHECK(tied.loops >= 100);
}
