// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The test functions of chapters 8 and 9, all on [0, 1]^3 but ml (on [-1, 1]^3), and samples.
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include "kernel/arithmetic/vec3.hpp"
#include "kernel/geometry/sampled_grid.hpp"

namespace crest::experiments {

using kernel::Vec3;
using Function = double (*)(const Vec3&);

inline double square(double x) {
  return x * x;
}

/// (8.10), whose printed domain is another one; range [-0.25, 1.27] here.
inline double f_test(const Vec3& p) {
  const auto [x, y, z] = p;
  return 0.5 * std::exp(-10 * (square(x - 0.25) + square(y - 0.25))) +
         0.75 * std::exp(-16 * (square(x - 0.25) + square(y - 0.25) + square(z - 0.25))) +
         0.5 * std::exp(-10 * (square(x - 0.75) + square(y - 0.125) + square(z - 0.5))) -
         0.25 * std::exp(-20 * (square(x - 0.75) + square(y - 0.75)));
}

/// No setting was chosen on this one.
inline double f_other(const Vec3& p) {
  const auto [x, y, z] = p;
  return 0.4 * std::sin(5 * x) * std::cos(4 * y + 1) * std::sin(3 * z + 0.5) +
         0.6 * std::exp(-12 * (square(x - 0.6) + square(y - 0.4) + square(z - 0.7)));
}

/// Truncated powers (section 9.5).
inline double g_powers(const Vec3& p) {
  const auto [x, y, z] = p;
  const auto power = [](double t) { return t > 0 ? t * square(t * t) : 0; };
  return power(x - 0.5) + power(x * (y - 0.5) * (z - 1)) + power(x * (y - 1) * (z - 0.5));
}

/// Marschner and Lobb's (8.9), fM = 6, alpha = 0.25.
inline double marschner_lobb(const Vec3& p) {
  const auto [x, y, z] = p;
  const double pi = std::numbers::pi, alpha = 0.25;
  const double r = std::cos(12 * pi * std::cos(pi * std::sqrt(x * x + y * y) / 2));
  return (1 - std::sin(pi * z / 2) + alpha * (1 + r)) / (2 * (1 + alpha));
}

/// A function's values in floats, n along each axis of [-half, half]^3.
inline kernel::SampledGrid volume_of(Function f, int n, double half = 1) {
  kernel::SampledGrid grid;
  std::vector<float> samples;
  const auto at = [&](int i) { return half * (2.0 * i / (n - 1) - 1); };
  for (int z = 0; z < n; ++z)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x) samples.push_back(static_cast<float>(f({at(x), at(y), at(z)})));
  grid.samples = std::move(samples);
  grid.size.fill(static_cast<std::size_t>(n));
  grid.spacing.fill(2 * half / (n - 1));
  grid.origin.fill(-half);
  return grid;
}

/// Uniform numbers of [0, 1).
class Uniform {
 public:
  explicit Uniform(std::uint64_t seed) : generator_(seed) {}
  double operator()() { return static_cast<double>(generator_() >> 11) * 0x1p-53; }
  Vec3 point() {
    const double x = (*this)(), y = (*this)(), z = (*this)();
    return {x, y, z};
  }

 private:
  std::mt19937_64 generator_;
};

struct Samples {
  std::vector<Vec3> points;
  std::vector<double> values;
};

/// Random ones of the unit cube.
inline Samples samples_of(Function f, std::size_t count, std::uint64_t seed) {
  Uniform draw(seed);
  Samples s;
  for (std::size_t i = 0; i < count; ++i) {
    s.points.push_back(draw.point());
    s.values.push_back(f(s.points.back()));
  }
  return s;
}

}  // namespace crest::experiments
