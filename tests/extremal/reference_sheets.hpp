// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The sheets that experiments show: volumes in [-1, 1]^3 whose ridges
// are known surfaces.
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "algorithms/extremal/extremal.hpp"

namespace crest::tests {

using Function = std::function<double(double, double, double)>;

inline double profile(double d) {
  return std::exp(-(d / 0.09) * (d / 0.09));
}
inline double sphere_sheet(double x, double y, double z) {
  return profile(std::hypot(x, y, z) - 0.6);
}
inline double torus_sheet(double x, double y, double z) {
  return profile(std::hypot(std::hypot(x, y) - 0.5, z) - 0.28);
}
inline double genus2_sheet(double x, double y, double z) {
  const double a = std::hypot(std::hypot(x - 0.36, y) - 0.34, z);
  const double b = std::hypot(std::hypot(x + 0.36, y) - 0.34, z);
  return profile(-0.06 * std::log(std::exp(-a / 0.06) + std::exp(-b / 0.06)) - 0.17);
}
inline double moebius_sheet(double x, double y, double z) {
  const double u = std::atan2(y, x), r = std::hypot(x, y) - 0.6;
  const double d = -std::sin(u / 2) * r + std::cos(u / 2) * z;
  const double t = std::cos(u / 2) * r + std::sin(u / 2) * z;
  return profile(d) * profile(std::max(0.0, std::fabs(t) - 0.27));
}
inline double junction_sheet(double x, double y, double) {
  double best = 0;
  for (int m = 0; m < 3; ++m) {
    const double angle = 2 * M_PI * m / 3 + 0.2;
    const double t = std::cos(angle) * x + std::sin(angle) * y;
    const double d = -std::sin(angle) * x + std::cos(angle) * y;
    best = std::max(best, std::exp(-(d * d + std::min(t, 0.0) * std::min(t, 0.0)) / 0.0081));
  }
  return best;
}

/// Samples at -1 + 2 i / (n - 1), spacing 2 / (n - 1) unless given.
inline extremal::Volume sampled(const Function& f, unsigned n) {
  extremal::Volume v;
  const double h = 2.0 / (n - 1);
  v.size = {n, n, n};
  v.spacing = {h, h, h};
  v.origin = {-1, -1, -1};
  std::vector<float> samples;
  samples.reserve(std::size_t{n} * n * n);
  for (unsigned k = 0; k < n; ++k)
    for (unsigned j = 0; j < n; ++j)
      for (unsigned i = 0; i < n; ++i)
        samples.push_back(static_cast<float>(f(-1 + h * i, -1 + h * j, -1 + h * k)));
  v.samples = std::move(samples);
  return v;
}

}  // namespace crest::tests
