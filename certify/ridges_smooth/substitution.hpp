// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Derivatives by the coordinates along three vectors from those by x, y and z.
#include <array>
#include <cmath>
#include <utility>

#include "certify/ridges_smooth/surface.hpp"
#include "kernel/arithmetic/taylor_combinations.hpp"

namespace crest::certify::smooth {

/// The Taylor coefficients of a -> F(x + a_0 p + a_1 q + a_2 m), from those of F at x; p, q, m the
/// vectors of `frame`.
///
/// Theorem. They are g_a = sum over |b| = |a| of W_ba f_b, W_ba the coefficient of the monomial a
/// in (sum_k frame[k] a_k)^b. With r the largest sum of |frame[k][i]| over k, |W_ba| <= r^d at
/// degree d, and W in floating point errs by at most 4 d u r^d: by induction, each degree takes
/// sums of three products of |W| <= r^(d - 1) and an entry of the frame, three roundings each.
/// Number: double, or Lanes for frames side by side.
template <class M, int n, class Number>
kernel::Jet<M, 3, n> in_frame(const kernel::Jet<M, 3, n>& f,
                              const std::array<std::array<Number, 3>, 3>& frame) {
  using kernel::larger, kernel::magnitude;
  constexpr kernel::JetTables<3, n> kTables{};
  constexpr std::size_t kMost = (n + 1) * (n + 2) / 2;  // monomials of degree n
  Number r = 0;
  for (std::size_t i = 0; i < 3; ++i)
    r = larger(r, magnitude(frame[0][i]) + magnitude(frame[1][i]) + magnitude(frame[2][i]));
  kernel::Jet<M, 3, n> g;
  if ((f.mask() & 1) != 0) g.set(0, f[0]);
  // W of one degree, [b][a], both counted from the first monomial of that degree.
  std::array<std::array<Number, kMost>, kMost> w{}, of_last{};
  w[0][0] = 1;
  std::size_t first = 0, count = 1;
  Number power = 1;
  for (std::size_t d = 1; d <= n && f.mask() >> (first + count) != 0; ++d) {
    const std::size_t last_first = std::exchange(first, first + count);
    const std::size_t last_count = std::exchange(count, (d + 1) * (d + 2) / 2);
    std::swap(w, of_last);
    power = power * r;
    typename kernel::CombinationsOf<M, kMost>::Type sums;
    std::array<std::size_t, kMost> which{};
    for (std::size_t b = 0; b < count; ++b) {
      auto e = kTables.kMonomials.exponents[first + b];
      const std::size_t i = e[0] > 0 ? 0 : e[1] > 0 ? 1 : 2;
      --e[i];
      const auto& from = of_last[kTables.position[kTables.digits(e[0], e[1], e[2])] - last_first];
      w[b].fill(0);
      for (std::size_t a = 0; a < last_count; ++a)
        for (std::size_t k = 0; k < 3; ++k) {
          Number& sum = w[b][kTables.product[last_first + a][3 - k] - first];
          sum = sum + from[a] * frame[k][i];
        }
      if ((f.mask() >> (first + b) & 1) == 0) continue;
      which[sums.size()] = b;
      sums.add(f[first + b]);
    }
    const Number error = (4 * static_cast<double>(d) * 0x1p-53) * power;
    for (std::size_t a = 0; a < count && sums.size() > 0; ++a) {
      std::array<Number, kMost> weights;
      for (std::size_t k = 0; k < sums.size(); ++k) weights[k] = w[which[k]][a];
      g.set(first + a, sums.of(weights, error));
    }
  }
  return g;
}

}  // namespace crest::certify::smooth
