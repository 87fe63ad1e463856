// SPDX-License-Identifier: GPL-3.0-or-later
// The reference table: zeros, switch points, indices and the separatrices' ends of ten fields.
#include <catch2/catch.hpp>
#include <string>

#include "algorithms/sampling/planar_fields.hpp"
#include "algorithms/vector_fields/vector_fields.hpp"
#include "tests/vector_fields/counts.hpp"

using namespace crest;
using namespace crest::tests;

namespace {

struct Row {
  std::uint64_t seed;
  bool hole;
  Counts counts;
};

// saddles, sources, sinks, foci; inside touches on edges, at corners; outside ones; index; ends at
// zeros, at the boundary, in closed orbits
const Row kRows[] = {
    {1, false, {5, 3, 3, 2, 7, 0, 6, 1, 1, 22, 12, 0}},
    {1, true, {4, 3, 3, 2, 10, 2, 7, 1, 2, 27, 13, 0}},
    {2, false, {14, 8, 4, 9, 5, 0, 9, 2, -2, 38, 28, 0}},
    {2, true, {14, 7, 4, 9, 5, 3, 12, 2, -3, 33, 39, 0}},
    {3, false, {14, 6, 4, 9, 3, 0, 9, 4, -4, 33, 29, 0}},
    {4, false, {17, 7, 13, 12, 12, 0, 5, 3, 3, 76, 15, 1}},
    {5, false, {26, 13, 15, 22, 11, 0, 9, 0, 2, 82, 42, 2}},
    {6, true, {22, 16, 8, 16, 14, 4, 12, 2, 2, 70, 52, 2}},
    {7, false, {28, 17, 12, 20, 10, 0, 9, 1, 1, 103, 28, 1}},
    {8, true, {26, 14, 12, 20, 14, 1, 13, 2, 0, 84, 47, 3}},
};

}  // namespace

TEST_CASE("Skeletons of the reference fields to the last count") {
  for (const Row& row : kRows) {
    INFO("seed " << row.seed << (row.hole ? ", hole" : ", square"));
    const auto skeleton =
        vector_fields::extract_skeleton(field_of(sampling::lattice_field(row.seed, 40, row.hole)));
    CHECK(counts_of(skeleton) == row.counts);
    CHECK(skeleton.winding_sum == skeleton.index_sum);
    CHECK(skeleton.euler_characteristic == (row.hole ? 0 : 1));
  }
}

TEST_CASE("Skeletons: scaling and renumbering change no count") {
  for (const std::uint64_t seed : {3, 6}) {
    const auto sample = sampling::lattice_field(seed, 40, seed == 6);
    const Counts expected = counts_of(vector_fields::extract_skeleton(field_of(sample)));
    for (const auto& [place, vector] :
         {std::pair{1e-5, 1.0}, {1e3, 1.0}, {1.0, 1e-8}, {1e-5, 1e-8}}) {
      INFO("seed " << seed << ", positions by " << place << ", vectors by " << vector);
      auto field = field_of(sample);
      for (auto& p : field.points)
        for (double& x : p) x *= place;
      for (auto& v : field.vectors)
        for (double& x : v) x *= vector;
      CHECK(counts_of(vector_fields::extract_skeleton(field)) == expected);
    }
    CHECK(counts_of(vector_fields::extract_skeleton(renumbered(field_of(sample), seed))) ==
          expected);
  }
}

TEST_CASE("Skeletons: the twins of the thesis' data") {
  const auto bodden = vector_fields::extract_skeleton(field_of(sampling::twin_bodden()));
  const Counts b = counts_of(bodden);
  CHECK(b.saddles == 37);
  CHECK(bodden.critical_points.size() == 72);
  CHECK(bodden.separatrices.size() == 188);
  CHECK((b.inside_edges == 18 && b.inside_corners == 2 && b.outside_edges == 21 &&
         b.outside_corners == 3));
  CHECK(b.zero_ends + b.boundary_ends + b.orbit_ends == 188);
}
