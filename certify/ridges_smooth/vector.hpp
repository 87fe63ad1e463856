// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Vectors of three over any number type.
#include <array>
#include <concepts>

namespace crest::certify::smooth {

template <class F>
F dot(const std::array<F, 3>& a, const std::array<F, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class F>
F dot(const std::array<F, 3>& a,
      const std::array<double, 3>& b) requires(!std::same_as<F, double>) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class F>
std::array<F, 3> cross(const std::array<F, 3>& a, const std::array<F, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// p + s m.
template <class F>
std::array<F, 3> along(const std::array<F, 3>& p, const F& s, const std::array<F, 3>& m) {
  return {p[0] + s * m[0], p[1] + s * m[1], p[2] + s * m[2]};
}

}  // namespace crest::certify::smooth
