// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 6: vertices near the level, by doubles and by rationals.
#include "certify/modes/near_vertices.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <iostream>
#include <random>

#include "tests/certify_modes/reference_modes.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/random.hpp"

using namespace crest;
using namespace crest::certify::modes;
using namespace crest::tests;

namespace {

double mode_of(const std::array<double, 6>& t) {
  std::array<double, 6> d = t;
  for (unsigned k = 0; k < 3; ++k) d[k] -= (t[0] + t[1] + t[2]) / 3;
  const double det = d[0] * (d[1] * d[2] - d[4] * d[4]) - d[3] * (d[3] * d[2] - d[4] * d[5]) +
                     d[5] * (d[3] * d[4] - d[1] * d[5]);
  double norm = 0;
  for (unsigned k = 0; k < 6; ++k) norm += (k < 3 ? 1 : 2) * d[k] * d[k];
  return 3 * std::sqrt(6.0) * det / std::pow(norm, 1.5);
}

using Tensors = std::vector<std::array<double, 6>>;

double mode_at(const Tensors& tensors, const std::array<double, 3>& w) {
  std::array<double, 6> t{};
  for (unsigned i = 0; i < 4; ++i)
    for (unsigned k = 0; k < 6; ++k)
      t[k] += (i < 3 ? w[i] : 1 - w[0] - w[1] - w[2]) * tensors[i][k];
  return mode_of(t);
}

Tensors random_tensors(Random& random) {
  std::uniform_int_distribution<int> entry(-9, 9);
  Tensors tensors(4);
  for (auto& t : tensors)
    for (double& x : t) x = entry(random);
  return tensors;
}

/// With tensors times a number: of those so large or so small only rationals tell.
bool is_near_scaled(Tensors tensors, double factor, const certify::ModeLevel& level,
                    const std::array<double, 3>& weights, int sign) {
  for (auto& t : tensors)
    for (double& x : t) x *= factor;
  const Field field(tensors);
  const Trees trees;
  const LevelContext context(level, field, trees);
  ExactTensors exact(field);
  return is_near<4>(context, {0, 1, 2, 3}, weights, sign, exact);
}

}  // namespace

TEST_CASE("modes: what is near a level, doubles and rationals agree, and know its sign") {
  Random random(kSeed);
  std::uniform_real_distribution<double> part(0.05, 0.3), exponent(-13.5, -10.5);
  std::array<int, 2> seen{};
  for (std::uint64_t i = 0; i < scaled(200); ++i) {
    const Tensors tensors = random_tensors(random);
    const std::array<double, 3> weights = {part(random), part(random), part(random)};
    const double mode = mode_at(tensors, weights);
    const bool neutral = std::fabs(mode) < 0.05;
    // The level as a fraction, off the mode by what may be near or not.
    certify::ModeLevel level;
    level.denominator = std::uint64_t{1} << 50U;
    const double off = std::pow(10, exponent(random)) * (random() % 2 == 0 ? 1 : -1);
    if (!neutral)
      level.numerator = static_cast<std::uint64_t>(std::ldexp(std::fabs(mode) + off, 50));
    const int sign = mode < 0 ? -1 : 1;
    const bool near = is_near_scaled(tensors, 1, level, weights, sign);
    CHECK(near == is_near_scaled(tensors, 0x1p950, level, weights, sign));
    CHECK(near == is_near_scaled(tensors, 0x1p-950, level, weights, sign));
    if (!neutral) CHECK_FALSE(is_near_scaled(tensors, 1, level, weights, -sign));
    if (!neutral) CHECK_FALSE(is_near_scaled(tensors, 0x1p950, level, weights, -sign));
    // Clear of 2^-40 by more than doubles lose.
    const double left = std::fabs(off) / 0x1p-40 - 1;
    if (!neutral && std::fabs(left) > 0.1) CHECK(near == (left < 0));
    ++seen[near ? 0 : 1];
  }
  std::cout << seen[0] << " near, " << seen[1] << " not\n";
  CHECK(seen[0] > 30);
  CHECK(seen[1] > 30);
}

TEST_CASE("modes: a tensor that is zero is near no level, one of mode 0 is near small ones") {
  const Tensors opposite = {
      {1, -1, 0, 0, 0, 0}, {-1, 1, 0, 0, 0, 0}, {2, 1, 5, 1, 0, 3}, {1, 0, 0, 0, 0, 0}};
  certify::ModeLevel level;
  for (const double factor : {1.0, 0x1p950}) {
    CHECK_FALSE(is_near_scaled(opposite, factor, level, {0.5, 0.5, 0}, 1));
    // Mode 0 exactly, for a level below and above 2^-40.
    for (const int below : {0, 1}) {
      certify::ModeLevel small;
      small.numerator = 1;
      small.denominator = std::uint64_t{1} << (below != 0 ? 41U : 39U);
      for (const int sign : {1, -1})
        CHECK(is_near_scaled(opposite, factor, small, {0.25, 0.75, 0}, sign) == (below != 0));
    }
  }
}
