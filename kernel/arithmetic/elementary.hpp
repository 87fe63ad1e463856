// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// exp, sin, cos and log of a double with a bound of the error; the first three without MPFR's
// microseconds.
#include <array>

namespace crest::kernel {

/// A double within `error` of the exact number.
struct Approximation {
  double value, error;
};

// Requires: rounding to nearest, no contraction of a * b + c (-ffp-contract=off), a finite x.
// Guarantees: the bounds of elementary.cpp in the ranges that it names, half a unit in the last
//   place over MPFR outside.
Approximation exp_near(double x);
/// sin x, cos x.
std::array<Approximation, 2> sin_cos_near(double x);
/// Over MPFR. Requires: x > 0.
Approximation log_near(double x);

}  // namespace crest::kernel
