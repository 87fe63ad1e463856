// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The dominant eigenvector in doubles, and directions as 16-bit integers: guesses that the cone
// test proves.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "kernel/arithmetic/vec3.hpp"
#include "kernel/predicates/cone_test.hpp"

namespace crest::extremal {

using Short3 = std::array<std::int16_t, 3>;

/// A unit vector near n: closed form, then one inverse iteration. For T = c I any unit vector.
inline kernel::Vec3 dominant_direction(const kernel::Symmetric3<double>& t) {
  using kernel::operator*;
  // Of an image: beside an entry zz that is far below, a gap in the plane would be rounded away.
  if (t[4] == 0 && t[5] == 0 && t[2] < -(std::fabs(t[0]) + std::fabs(t[1]) + std::fabs(t[3]))) {
    const double half = (t[0] - t[1]) / 2, r = std::hypot(half, t[3]);
    if (!(r > 0)) return {1, 0, 0};
    const kernel::Vec3 v =
        half > 0 ? kernel::Vec3{half + r, t[3], 0} : kernel::Vec3{t[3], r - half, 0};
    return (1 / std::hypot(v[0], v[1])) * v;
  }
  const double mean = (t[0] + t[1] + t[2]) / 3;
  const double x = t[0] - mean, y = t[1] - mean, z = t[2] - mean;
  const double square = (x * x + y * y + z * z + 2 * (t[3] * t[3] + t[4] * t[4] + t[5] * t[5])) / 6;
  const double p = std::sqrt(square);
  if (!(p > 0)) return {1, 0, 0};
  const double det =
      x * (y * z - t[4] * t[4]) - t[3] * (t[3] * z - t[4] * t[5]) + t[5] * (t[3] * t[4] - y * t[5]);
  const double r = std::clamp(det / (2 * p * square), -1.0, 1.0);
  const double q = 2 * p * std::cos(std::acos(r) / 3);
  const auto a = kernel::adjugate<double>({x - q, y - q, z - q, t[3], t[4], t[5]});
  kernel::Vec3 n = a[0] >= a[1] && a[0] >= a[2] ? kernel::Vec3{a[0], a[3], a[5]}
                   : a[1] >= a[2]               ? kernel::Vec3{a[3], a[1], a[4]}
                                                : kernel::Vec3{a[5], a[4], a[2]};
  double length = kernel::norm(n);
  if (!(length > 0)) return {1, 0, 0};
  n = (1 / length) * n;
  const double rayleigh = kernel::dot(n, kernel::product(t, n));
  const kernel::Vec3 better =
      kernel::product(kernel::adjugate<double>(
                          {t[0] - rayleigh, t[1] - rayleigh, t[2] - rayleigh, t[3], t[4], t[5]}),
                      n);
  length = kernel::norm(better);
  return length > 0 ? (1 / length) * better : n;
}

/// Integers in proportion to v, the largest 2^14.
inline Short3 shortened(const kernel::Vec3& v) {
  const double largest = std::max({std::fabs(v[0]), std::fabs(v[1]), std::fabs(v[2])});
  const auto round = [&](double x) {
    return static_cast<std::int16_t>(std::lround(x / largest * 16384));
  };
  return {round(v[0]), round(v[1]), round(v[2])};
}
inline kernel::Vec3 unit(const Short3& v) {
  using kernel::operator*;
  const kernel::Vec3 r = {static_cast<double>(v[0]), static_cast<double>(v[1]),
                          static_cast<double>(v[2])};
  return (1 / kernel::norm(r)) * r;
}

}  // namespace crest::extremal
