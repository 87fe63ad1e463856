// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Scattered samples of known functions.
#include <cmath>
#include <functional>
#include <vector>

#include "algorithms/splines/local_cubic.hpp"
#include "kernel/arithmetic/vec3.hpp"
#include "tests/support/random.hpp"

namespace crest::tests {

using kernel::Vec3;

struct Samples {
  std::vector<Vec3> points;
  std::vector<double> values;
};

/// Evenly distributed in [0, 1]^3.
inline Samples sampled(std::size_t count, std::uint64_t seed,
                       const std::function<double(const Vec3&)>& f) {
  Random random(seed);
  const auto draw = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  Samples s;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = draw(), y = draw(), z = draw();
    s.points.push_back({x, y, z});
    s.values.push_back(f(s.points.back()));
  }
  return s;
}

/// (8.10), on [0, 1]^3: its range is [-0.25, 1.27] there.
inline double f_test(const Vec3& p) {
  const auto square = [](double a) { return a * a; };
  const auto [x, y, z] = p;
  return 0.5 * std::exp(-10 * (square(x - 0.25) + square(y - 0.25))) +
         0.75 * std::exp(-16 * (square(x - 0.25) + square(y - 0.25) + square(z - 0.25))) +
         0.5 * std::exp(-10 * (square(x - 0.75) + square(y - 0.125) + square(z - 0.5))) -
         0.25 * std::exp(-20 * (square(x - 0.75) + square(y - 0.75)));
}

/// A cubic with small integer coefficients and its gradient.
struct IntegerCubic {
  splines::LocalCubic p;

  explicit IntegerCubic(std::uint64_t seed) {
    Random random(seed);
    for (double& c : p.c) c = static_cast<double>(static_cast<int>(random() % 9) - 4);
  }
  double operator()(const Vec3& x) const { return p.value(x); }
};

}  // namespace crest::tests
