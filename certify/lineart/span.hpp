// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Numbers between two doubles, for boxes of candidates: no rounding mode, no exact numbers.
#include <cmath>

#include "certify/lineart/boxes.hpp"

namespace crest::certify {

/// Every operation moves its bounds outwards by a double; what is no number is any number.
struct Span {
  double low = 0, high = 0;

  Span() = default;
  explicit Span(double x) : low(x), high(x) {}
  Span(double l, double h)
      : low(std::isnan(l) ? -HUGE_VAL : std::nextafter(l, -HUGE_VAL)),
        high(std::isnan(h) ? HUGE_VAL : std::nextafter(h, HUGE_VAL)) {}
};

inline Span operator+(Span a, Span b) {
  return {a.low + b.low, a.high + b.high};
}
inline Span operator-(Span a, Span b) {
  return {a.low - b.high, a.high - b.low};
}
inline Span operator*(Span a, Span b) {
  const double p = a.low * b.low, q = a.low * b.high, r = a.high * b.low, s = a.high * b.high;
  if (std::isnan(p + q + r + s)) return {-HUGE_VAL, HUGE_VAL};
  return {std::min({p, q, r, s}), std::max({p, q, r, s})};
}
inline Span operator/(Span a, Span b) {
  if (!(b.low > 0)) return {-HUGE_VAL, HUGE_VAL};
  return {a.low / (a.low < 0 ? b.low : b.high), a.high / (a.high < 0 ? b.high : b.low)};
}

inline PlaneBox box_of(const std::array<Span, 2>& place) {
  PlaneBox box;
  for (std::size_t n = 0; n < 2; ++n) {
    box.low[n] = place[n].low;
    box.high[n] = place[n].high;
  }
  return box;
}

}  // namespace crest::certify
