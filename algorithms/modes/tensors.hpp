// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Traceless symmetric tensors: the deviator of T, times 3, is D = 3 T - tr(T) I, which needs no
// division. Doubles with the error they carry; integers times a power of two.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "kernel/polynomial/dyadic.hpp"

namespace crest::modes {

/// xx yy zz xy yz xz, VTK's order.
template <class T>
using Entries = std::array<T, 6>;
using Symmetric = Entries<double>;

/// A deviator in doubles: each entry within `error` of the exact one.
struct Deviator {
  Symmetric t{};
  double error = 0;
  double largest() const {
    double m = 0;
    for (const double x : t) m = std::max(m, std::fabs(x));
    return m;
  }
};

/// The entries are t 2^exponent.
struct ExactTensor {
  Entries<kernel::Integer> t;
  long exponent = 0;
};

/// Tensors times 2^-scale are below 1.
inline int scale_of(const std::vector<Symmetric>& tensors) {
  double largest = 0;
  for (const Symmetric& t : tensors)
    for (const double x : t) largest = std::max(largest, std::fabs(x));
  return largest > 0 ? std::ilogb(largest) + 1 : 0;
}

/// D of T 2^-scale. Each entry is two sums of at most 4 max |T|, each rounded once: 8 u max |T|.
/// 2^-1070 covers what scaling loses to underflow.
inline Deviator deviator(const Symmetric& given, int scale) {
  Symmetric x;
  double m = 0;
  for (std::size_t k = 0; k < 6; ++k) {
    x[k] = std::ldexp(given[k], -scale);
    m = std::fmax(m, std::fabs(x[k]));
  }
  return {{2 * x[0] - x[1] - x[2], 2 * x[1] - x[0] - x[2], 2 * x[2] - x[0] - x[1], 3 * x[3],
           3 * x[4], 3 * x[5]},
          8 * 0x1p-53 * m + 0x1p-1070};
}

/// D of T 2^-scale, exactly.
inline ExactTensor exact_deviator(const Symmetric& given, int scale) {
  std::array<kernel::Dyadic, 6> x;
  long low = 0;
  bool any = false;
  for (std::size_t k = 0; k < 6; ++k) {
    x[k] = kernel::dyadic(given[k]);
    if (x[k].mantissa.is_zero()) continue;
    low = any ? std::min(low, x[k].exponent) : x[k].exponent;
    any = true;
  }
  Entries<kernel::Integer> y;
  for (std::size_t k = 0; k < 6; ++k) {
    y[k] = x[k].mantissa;
    if (!y[k].is_zero()) y[k] <<= static_cast<unsigned long>(x[k].exponent - low);
  }
  return {{2 * y[0] - y[1] - y[2], 2 * y[1] - y[0] - y[2], 2 * y[2] - y[0] - y[1], 3 * y[3],
           3 * y[4], 3 * y[5]},
          low - scale};
}

/// Whether T is a multiple of the identity.
inline bool is_isotropic(const Symmetric& t) {
  return t[0] == t[1] && t[1] == t[2] && t[3] == 0 && t[4] == 0 && t[5] == 0;
}

/// <A, B> = tr(A B).
template <class T>
T product(const Entries<T>& a, const Entries<T>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + T(2) * (a[3] * b[3] + a[4] * b[4] + a[5] * b[5]);
}

/// A B + B A.
template <class T>
Entries<T> anticommutator(const Entries<T>& a, const Entries<T>& b) {
  const T xy = a[3] * b[3], yz = a[4] * b[4], xz = a[5] * b[5];
  return {T(2) * (a[0] * b[0] + xy + xz),
          T(2) * (a[1] * b[1] + xy + yz),
          T(2) * (a[2] * b[2] + xz + yz),
          (a[0] + a[1]) * b[3] + a[3] * (b[0] + b[1]) + a[5] * b[4] + a[4] * b[5],
          (a[1] + a[2]) * b[4] + a[4] * (b[1] + b[2]) + a[3] * b[5] + a[5] * b[3],
          (a[0] + a[2]) * b[5] + a[5] * (b[0] + b[2]) + a[3] * b[4] + a[4] * b[3]};
}

}  // namespace crest::modes
