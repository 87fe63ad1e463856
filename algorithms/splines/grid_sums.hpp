// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Numbers on a box of places, and the maps that the C1 equations consist of: differences and sums
// of neighbours along an axis, and their transposes.
#include <array>
#include <cstddef>
#include <vector>

namespace crest::splines {

struct GridArray {
  std::array<std::size_t, 3> size{};
  std::vector<double> x{};  ///< the first axis is the fastest

  explicit GridArray(const std::array<std::size_t, 3>& s) : size(s), x(s[0] * s[1] * s[2]) {}
  double& at(std::size_t i, std::size_t j, std::size_t k) {
    return x[i + size[0] * (j + size[1] * k)];
  }
  GridArray& operator+=(const GridArray& b) { return add(1, b); }
  GridArray& operator-=(const GridArray& b) { return add(-1, b); }
  GridArray& add(double factor, const GridArray& b) {
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += factor * b.x[i];
    return *this;
  }
};

/// x(i + 1) + sign x(i), one place less along the axis.
inline GridArray neighbours(const GridArray& a, std::size_t axis, double sign) {
  auto size = a.size;
  --size[axis];
  GridArray r(size);
  const std::size_t stride = axis == 0 ? 1 : axis == 1 ? a.size[0] : a.size[0] * a.size[1];
  const std::size_t inner = stride * size[axis], outer = a.x.size() / (stride * a.size[axis]);
  for (std::size_t o = 0; o < outer; ++o) {
    const double* const from = &a.x[o * stride * a.size[axis]];
    double* const to = r.x.data() + o * inner;
    for (std::size_t i = 0; i < inner; ++i) to[i] = from[i + stride] + sign * from[i];
  }
  return r;
}
inline GridArray difference(const GridArray& a, std::size_t axis) {
  return neighbours(a, axis, -1);
}
inline GridArray sum(const GridArray& a, std::size_t axis) {
  return neighbours(a, axis, 1);
}

/// The transpose: one place more.
inline GridArray neighbours_transposed(const GridArray& a, std::size_t axis, double sign) {
  auto size = a.size;
  ++size[axis];
  GridArray r(size);
  const std::size_t stride = axis == 0 ? 1 : axis == 1 ? a.size[0] : a.size[0] * a.size[1];
  const std::size_t inner = stride * a.size[axis], outer = a.x.size() / inner;
  for (std::size_t o = 0; o < outer; ++o) {
    const double* const from = a.x.data() + o * inner;
    double* const to = &r.x[o * stride * size[axis]];
    for (std::size_t i = 0; i < inner; ++i) {
      to[i + stride] += from[i];
      to[i] += sign * from[i];
    }
  }
  return r;
}
inline GridArray difference_transposed(const GridArray& a, std::size_t axis) {
  return neighbours_transposed(a, axis, -1);
}
inline GridArray sum_transposed(const GridArray& a, std::size_t axis) {
  return neighbours_transposed(a, axis, 1);
}

}  // namespace crest::splines
