// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A cubic polynomial of three variables about a centre, and its blossom.
#include <array>
#include <cstddef>

#include "kernel/arithmetic/vec3.hpp"

namespace crest::splines {

using kernel::Vec3;

/// Monomials by degree: 1; x, y, z; xx, xy, xz, yy, yz, zz; xxx, xxy, xxz, xyy, xyz, xzz, yyy, yyz,
/// yzz, zzz.
constexpr std::size_t kMonomials = 20;
constexpr std::array<std::size_t, 4> kMonomialsUpTo{1, 4, 10, 20};  ///< of each degree

inline std::array<double, kMonomials> monomials(const Vec3& v) {
  const auto [x, y, z] = v;
  const double xx = x * x, xy = x * y, xz = x * z, yy = y * y, yz = y * z, zz = z * z;
  return {1,      x,      y,      z,      xx,     xy,     xz,     yy,     yz,     zz,
          xx * x, xx * y, xx * z, x * yy, xy * z, x * zz, yy * y, yy * z, y * zz, zz * z};
}

struct LocalCubic {
  Vec3 centre{};
  double radius = 1;  ///< the variables are (x - centre) / radius
  std::array<double, kMonomials> c{};
  int degree = 0;
  int samples = 0;

  double value(const Vec3& at) const {
    const auto m = monomials(local(at));
    double sum = 0;
    for (std::size_t i = 0; i < kMonomials; ++i) sum += c[i] * m[i];
    return sum;
  }
  Vec3 gradient(const Vec3& at) const {
    const auto [x, y, z] = local(at);
    const double dx = c[1] + x * (2 * c[4] + 3 * c[10] * x + 2 * (c[11] * y + c[12] * z)) +
                      y * (c[5] + c[13] * y + c[14] * z) + z * (c[6] + c[15] * z);
    const double dy = c[2] + y * (2 * c[7] + 3 * c[16] * y + 2 * (c[13] * x + c[17] * z)) +
                      x * (c[5] + c[11] * x + c[14] * z) + z * (c[8] + c[18] * z);
    const double dz = c[3] + z * (2 * c[9] + 3 * c[19] * z + 2 * (c[15] * x + c[18] * y)) +
                      x * (c[6] + c[12] * x + c[14] * y) + y * (c[8] + c[17] * y);
    return {dx / radius, dy / radius, dz / radius};
  }
  /// The gradient of the linear map x -> p[a, b, x], p the blossom.
  Vec3 slope(const Vec3& a, const Vec3& b) const {
    const Vec3 middle{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
    const Vec3 at_a = gradient(a), at_b = gradient(b), between = gradient(middle);
    Vec3 s;
    for (std::size_t d = 0; d < 3; ++d) s[d] = (2 * between[d] - (at_a[d] + at_b[d]) / 2) / 3;
    return s;
  }
  /// p[a, a, x].
  double blossom(const Vec3& a, const Vec3& x) const {
    using kernel::operator-;
    return value(a) + kernel::dot(gradient(a), x - a) / 3;
  }
  double blossom(const Vec3& a, const Vec3& b, const Vec3& x) const {
    using kernel::operator-;
    return blossom(a, b) + kernel::dot(slope(a, b), x - a);
  }

 private:
  Vec3 local(const Vec3& x) const {
    return {(x[0] - centre[0]) / radius, (x[1] - centre[1]) / radius, (x[2] - centre[2]) / radius};
  }
};

}  // namespace crest::splines
