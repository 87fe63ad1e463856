// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Volumes of functions, spheres and random numbers.
#include <cmath>
#include <functional>

#include "algorithms/splines/quadratic.hpp"
#include "tests/support/random.hpp"

namespace crest::tests {

using kernel::SampledGrid;
using kernel::Vec3;

/// The function on [-1, 1]^3, in T.
template <class T>
SampledGrid volume_of(int n, const std::function<double(double, double, double)>& f) {
  SampledGrid grid;
  std::vector<T> samples;
  const auto at = [n](int i) { return 2.0 * i / (n - 1) - 1; };
  for (int z = 0; z < n; ++z)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x) samples.push_back(static_cast<T>(f(at(x), at(y), at(z))));
  grid.samples = samples;
  for (std::size_t k = 0; k < 3; ++k) {
    grid.size[k] = static_cast<std::size_t>(n);
    grid.spacing[k] = 2.0 / (n - 1);
    grid.origin[k] = -1;
  }
  return grid;
}

/// |2 v - (n - 1)|^2 at index v, spacing 1: the spline is 4 |p - middle|^2 + 3.
inline SampledGrid sphere_volume(int n) {
  SampledGrid grid;
  std::vector<std::int16_t> samples;
  const auto square = [n](int i) { return (2 * i - n + 1) * (2 * i - n + 1); };
  for (int z = 0; z < n; ++z)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x)
        samples.push_back(static_cast<std::int16_t>(square(x) + square(y) + square(z)));
  grid.samples = samples;
  for (std::size_t& size : grid.size) size = static_cast<std::size_t>(n);
  return grid;
}
inline double sphere_level(double radius) {
  return 4 * radius * radius + 3;
}

template <class T>
SampledGrid random_volume(const std::array<std::size_t, 3>& size, int largest, std::uint64_t seed) {
  Random random(seed);
  SampledGrid grid;
  grid.size = size;
  std::vector<T> samples(grid.count());
  const auto range = static_cast<std::uint64_t>(2 * largest + 1);
  for (T& x : samples) x = static_cast<T>(static_cast<int>(random() % range) - largest);
  grid.samples = samples;
  return grid;
}

}  // namespace crest::tests
