// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Simple roots of a quartic by Descartes' rule on dyadic parts, its coefficients with errors.
#include <array>
#include <vector>

#include "certify/modes_curves/span.hpp"

namespace crest::certify::curves {

/// An interval with a single root.
struct Bracket {
  double low, high;
  int sign;  ///< at its lower end
};

/// b: Bernstein's coefficients on (low, high). Appends all roots there in ascending order; false
/// where errors or parts narrower than `least` do not tell.
template <class Number>
bool isolate(std::array<Number, 5> b, double low, double high, double least,
             std::vector<Bracket>& list) {
  int changes = 0, last = 0;
  bool certain = true;
  for (const Number& x : b) {
    const int sign = sign_of(x);
    certain &= sign != 0;
    changes += last * sign < 0;
    last = sign;
  }
  if (sign_of(b[0]) == 0 || last == 0) return false;
  if (certain && changes == 0) return true;
  if (certain && changes == 1) {
    list.push_back({low, high, sign_of(b[0])});
    return true;
  }
  if (high - low < least) return false;
  std::array<Number, 5> first;
  for (std::size_t k = 0; k < 5; ++k) {
    first[k] = b[0];
    for (std::size_t i = 0; i + k < 4; ++i) b[i] = (b[i] + b[i + 1]) * Number(0.5);
  }
  const double middle = low + (high - low) / 2;
  return isolate(first, low, middle, least, list) && isolate(b, middle, high, least, list);
}

}  // namespace crest::certify::curves
