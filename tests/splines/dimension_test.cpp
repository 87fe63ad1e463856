// SPDX-License-Identifier: GPL-3.0-or-later
// Dimensions of spline spaces (theorem 7.1, table 7.1) by the rank of their conditions.
#include "algorithms/splines/dimension.hpp"

#include <bit>
#include <catch2/catch.hpp>

#include "algorithms/splines/normal_form.hpp"

using namespace crest;
using namespace crest::splines;

namespace {

/// Table 7.1's formulas.
std::size_t continuous_dimension(std::size_t q, std::size_t n) {
  return (4 * q * q + 1) * q * n * n * n + 6 * q * q * n * n + 3 * q * n + 1;
}
std::size_t smooth_dimension(std::size_t q, std::size_t n) {
  if (q == 2) return 3 * n * n + 9 * n + 4;
  return (4 * q * q * q + 53 * q - 24 * q * q - 45) * n * n * n +
         6 * (2 * q * q + 7 - 7 * q) * n * n + 9 * (q - 1) * n + 4;
}

template <int q>
void check_dimensions(int n) {
  CAPTURE(q, n);
  const Dimensions d = dimensions<q>({n, n, n});
  CHECK(d.continuous == continuous_dimension(q, static_cast<std::size_t>(n)));
  CHECK(d.smooth == smooth_dimension(q, static_cast<std::size_t>(n)));
}

}  // namespace

// The other rows of the table, up to q = 9 and n = 4: experiments/001-splines/dimension_table.
TEST_CASE("dimensions of C0 and C1 splines are those of table 7.1") {
  check_dimensions<2>(1);
  check_dimensions<3>(1);
  check_dimensions<4>(1);
  check_dimensions<5>(1);
  check_dimensions<2>(2);
  check_dimensions<3>(2);
  check_dimensions<4>(2);
  check_dimensions<2>(3);
  check_dimensions<3>(3);
}

TEST_CASE(
    "the equations V and E of cubic splines are independent and leave theorem 7.1's dimension") {
  for (const std::size_t n : {1, 2, 3}) {
    CAPTURE(n);
    const auto side = static_cast<kernel::Index>(n);
    const splines::Domain domain{{0, 0, 0}, {1, 1, 1}, {side, side, side}};
    Rank rank;
    splines::for_each_place(domain.cubes, [&](const splines::Place& cube) {
      // What is left of the targets' eight equations once the centre satisfies four.
      for (const std::size_t product : {3U, 5U, 6U, 7U}) {
        std::vector<std::pair<std::size_t, int>> equation;
        for (std::size_t unknown = 0; unknown < 8 * 4 + 12 * 2; ++unknown) {
          splines::CubeNumbers<int> unit{};
          std::size_t vertex, number;
          if (unknown < 32) {
            const std::size_t c = unknown / 4;
            (unknown % 4 == 0 ? unit.f[c] : unit.h[c][unknown % 4 - 1]) = 1;
            vertex = domain.vertex(splines::corner_of(cube, c));
            number = unknown % 4;
          } else {
            const std::size_t e = (unknown - 32) / 2;
            unit.t[e][unknown % 2] = 1;
            vertex = domain.vertex(splines::corner_of(cube, splines::lower_corner(e)));
            number = 4 + e / 4 * 2 + unknown % 2;
          }
          const auto targets = splines::fourfold_targets(unit);
          int sum = 0;
          for (std::size_t c = 0; c < 8; ++c)
            sum += std::popcount(c & product) % 2 == 0 ? targets[c] : -targets[c];
          if (sum != 0) equation.emplace_back(10 * vertex + number, sum);
        }
        rank.add(equation);
      }
    });
    CHECK(rank.rank() == 4 * n * n * n);
    const std::size_t numbers = 4 * (n + 1) * (n + 1) * (n + 1) + 6 * n * (n + 1) * (n + 1);
    CHECK(numbers - rank.rank() == smooth_dimension(3, n));
  }
}
