// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Eight doubles that go through one formula together: the compiler makes vector instructions of the
// loops. Every lane gets what a double alone would get.
#include <array>
#include <cmath>
#include <cstddef>

namespace crest::kernel {

struct Lanes {
  static constexpr std::size_t count = 8;
  std::array<double, count> x;

  Lanes() = default;
  Lanes(double v) { x.fill(v); }  // NOLINT: numbers convert

  friend Lanes operator+(const Lanes& a, const Lanes& b) {
    Lanes r;
    for (std::size_t i = 0; i < count; ++i) r.x[i] = a.x[i] + b.x[i];
    return r;
  }
  friend Lanes operator-(const Lanes& a, const Lanes& b) {
    Lanes r;
    for (std::size_t i = 0; i < count; ++i) r.x[i] = a.x[i] - b.x[i];
    return r;
  }
  friend Lanes operator*(const Lanes& a, const Lanes& b) {
    Lanes r;
    for (std::size_t i = 0; i < count; ++i) r.x[i] = a.x[i] * b.x[i];
    return r;
  }
};

inline Lanes magnitude(const Lanes& a) {
  Lanes r;
  for (std::size_t i = 0; i < Lanes::count; ++i) r.x[i] = std::fabs(a.x[i]);
  return r;
}
inline Lanes larger(const Lanes& a, const Lanes& b) {
  Lanes r;
  for (std::size_t i = 0; i < Lanes::count; ++i) r.x[i] = a.x[i] < b.x[i] ? b.x[i] : a.x[i];
  return r;
}
inline Lanes smaller(const Lanes& a, const Lanes& b) {
  Lanes r;
  for (std::size_t i = 0; i < Lanes::count; ++i) r.x[i] = b.x[i] < a.x[i] ? b.x[i] : a.x[i];
  return r;
}
/// x where `bound` is at most `limit`, infinity elsewhere.
inline Lanes or_infinite(const Lanes& x, const Lanes& bound, double limit) {
  Lanes r;
  for (std::size_t i = 0; i < Lanes::count; ++i) r.x[i] = bound.x[i] <= limit ? x.x[i] : HUGE_VAL;
  return r;
}

inline double magnitude(double a) {
  return std::fabs(a);
}
inline double larger(double a, double b) {
  return a < b ? b : a;
}
inline double smaller(double a, double b) {
  return b < a ? b : a;
}
inline double or_infinite(double x, double bound, double limit) {
  return bound <= limit ? x : HUGE_VAL;
}

}  // namespace crest::kernel
