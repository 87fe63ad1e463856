// SPDX-License-Identifier: GPL-3.0-or-later
// Dependent and constant tensors of tetrahedra: doubles against exact ranks.
#include "algorithms/modes/field_counts.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "kernel/arithmetic/rational.hpp"
#include "tests/support/random.hpp"

namespace {

using namespace crest;
using namespace crest::modes;
using Tensor = std::array<double, 6>;

ModeField one_tet(const std::array<Tensor, 4>& t) {
  return {kernel::TetMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}),
          {t.begin(), t.end()}};
}

/// Of the deviators, by their Gram matrix's determinant in rationals.
bool are_dependent(const std::array<Tensor, 4>& t) {
  using kernel::Rational;
  std::array<std::array<Rational, 6>, 4> d;
  for (std::size_t i = 0; i < 4; ++i) {
    const Rational trace = Rational(t[i][0]) + Rational(t[i][1]) + Rational(t[i][2]);
    for (std::size_t k = 0; k < 6; ++k)
      d[i][k] = k < 3 ? Rational(3 * Rational(t[i][k]) - trace) : Rational(3 * Rational(t[i][k]));
  }
  std::array<std::size_t, 4> order = {0, 1, 2, 3};
  Rational determinant = 0;
  do {
    int sign = 1;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t k = i + 1; k < 4; ++k) sign = order[i] > order[k] ? -sign : sign;
    Rational term = sign;
    for (std::size_t i = 0; i < 4; ++i) {
      Rational product = 0;
      for (std::size_t k = 0; k < 6; ++k) product += d[i][k] * d[order[i]][k];
      term *= product;
    }
    determinant += term;
  } while (std::next_permutation(order.begin(), order.end()));
  return determinant == 0;
}

}  // namespace

TEST_CASE("modes: dependent tensors of a tet are counted exactly", "[modes]") {
  tests::Random random(17);
  std::size_t dependent = 0;
  for (int round = 0; round < 400; ++round) {
    std::array<Tensor, 4> t;
    for (Tensor& x : t)
      for (double& e : x) e = static_cast<double>(static_cast<int>(random() % 5) - 2);
    if (round % 2 == 0)
      for (std::size_t k = 0; k < 6; ++k) t[3][k] = t[0][k] - 2 * t[1][k] + t[2][k];
    // Nearly parallel, by exact steps.
    if (round % 3 == 0)
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t k = 0; k < 6; ++k) t[i][k] = 1 + 0x1p-30 * t[i][k];
    const FieldCounts counts = count_field(one_tet(t));
    const bool expected = are_dependent(t);
    INFO("round " << round);
    CHECK(counts.rank_deficient_tets == (expected ? 1 : 0));
    dependent += expected ? 1 : 0;
  }
  CHECK(dependent > 100);
  CHECK(dependent < 300);
}

TEST_CASE("modes: deviators far below the rounding of their tensors count as they are", "[modes]") {
  // Of size 2^-18 beside 2^33: the double of the first one's deviator is (4 or 6, -4, -1) 2^-20,
  // exactly it is (5, -4, -1) 2^-20, half of the second one's.
  const auto near_pressure = [](double a) {
    return Tensor{0x1p33 + 0x1p-19 * a, 0x1p33 - 0x1p-20 * a, 0x1p33, 0, 0, 0};
  };
  const std::array<Tensor, 4> t = {near_pressure(1), near_pressure(2), Tensor{0, 0, 0, 1, 0, 0},
                                   Tensor{0, 0, 0, 0, 1, 0}};
  REQUIRE(are_dependent(t));
  CHECK(count_field(one_tet(t)).rank_deficient_tets == 1);
  CHECK(count_field(one_tet(t)).constant_tets == 0);
}
