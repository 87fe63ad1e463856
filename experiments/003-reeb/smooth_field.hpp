// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Smooth random functions of space, and their piecewise quadratic interpolants on a mesh.
#include <cmath>
#include <numbers>
#include <random>

#include "kernel/geometry/quadratic_mesh.hpp"

namespace crest::experiments {

using kernel::Index;
using kernel::Vec3;

/// A sum of plane waves with wave lengths from `shortest` to four times that.
class SmoothField {
 public:
  SmoothField(double shortest, std::uint64_t seed, int waves = 64) {
    std::mt19937_64 draw(seed);
    const auto uniform = [&] { return static_cast<double>(draw() >> 11) * 0x1p-53; };
    for (int i = 0; i < waves; ++i) {
      const double z = 2 * uniform() - 1, turn = 2 * std::numbers::pi * uniform();
      const double wave = 2 * std::numbers::pi / (shortest * (1 + 3 * uniform()));
      const double r = std::sqrt(1 - z * z) * wave;
      waves_.push_back(
          {{r * std::cos(turn), r * std::sin(turn), z * wave}, 2 * std::numbers::pi * uniform()});
    }
  }
  double operator()(const Vec3& p) const {
    double sum = 0;
    for (const Wave& w : waves_)
      sum += std::cos(w.k[0] * p[0] + w.k[1] * p[1] + w.k[2] * p[2] + w.phase);
    return sum;
  }

 private:
  struct Wave {
    Vec3 k;
    double phase;
  };
  std::vector<Wave> waves_;
};

inline Vec3 middle(const Vec3& a, const Vec3& b) {
  return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
}

/// f at the vertices and the edges' midpoints.
template <class Field>
kernel::QuadraticMesh quadratic_interpolant(const std::vector<Vec3>& points,
                                            const std::vector<kernel::Triangle>& faces,
                                            const Field& f) {
  std::vector<double> values;
  std::vector<std::array<double, 3>> midside;
  for (const Vec3& p : points) values.push_back(f(p));
  for (const kernel::Triangle& t : faces) {
    midside.emplace_back();
    for (std::size_t k = 0; k < 3; ++k)
      midside.back()[k] = f(middle(points[t[k]], points[t[(k + 1) % 3]]));
  }
  return {points, faces, std::move(values), midside};
}

}  // namespace crest::experiments
