// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// implicit_function() of foot.hpp.
#include <algorithm>

#include "certify/ridges_smooth/foot.hpp"
#include "certify/ridges_smooth/local.hpp"

namespace crest::certify::smooth {

template <class M, int n>
kernel::SparseArray<M, kernel::monomial_count(2, n)> implicit_function(
    const kernel::Jet<M, 3, n>& f, std::size_t axis) {
  constexpr kernel::JetTables<2, n> kPlane{};
  constexpr kernel::JetTables<3, n> kSpace{};
  const auto in_space = [&](int a, int b, int c) -> std::size_t {
    std::array<int, 3> e{};
    e[(axis + 1) % 3] = a;
    e[(axis + 2) % 3] = b;
    e[axis] = c;
    return kSpace.position[kSpace.digits(e[0], e[1], e[2])];
  };
  const auto in_plane = [&](int a, int b) -> std::size_t {
    return kPlane.position[kPlane.digits(a, b)];
  };
  kernel::SparseArray<M, kPlane.kCount> h;
  const M factor = -reciprocal(f[in_space(0, 0, 1)]);
  const std::size_t slope[] = {in_plane(1, 0), in_plane(0, 1)};
  for (const int i : {0, 1}) {
    const std::size_t from = in_space(1 - i, i, 0);
    if ((f.mask() >> from & 1) != 0) h.put(slope[i], M(f[from] * factor));
  }

  // G at degree d: c -> c + h_10 a + h_01 b, by Horner's scheme t times for the terms with c^t.
  kernel::SparseArray<M, kSpace.kCount> g;
  kernel::for_each_bit(f.mask(), [&](std::size_t i) { g.put(i, f[i]); });
  for (int d = 2; d <= n; ++d)
    for (int t = 0; t <= std::min(n - d, d - 1); ++t)
      for (int c = d - 1; c >= t; --c)
        for (int a = 0; a <= d - c; ++a) {
          const int b = d - c - a;
          for (const int i : {0, 1}) {
            if ((i == 0 ? a : b) == 0) continue;
            const std::size_t from = in_space(a - (1 - i), b - i, c + 1);
            if (h.has(slope[i]) && g.has(from))
              accumulate(g, in_space(a, b, c), h[slope[i]], g[from]);
          }
        }

  // Degree by degree the k of the theorem, which is h there, and its powers.
  constexpr int kMostPower = n / 2;
  std::array<kernel::SparseArray<M, kPlane.kCount>, kMostPower + 1> powers;
  const auto power = [&](int c) -> const auto& {
    return c == 1 ? h : powers[static_cast<std::size_t>(c)];
  };
  for (int d = 2; d <= n; ++d)
    for (int i = 0; i <= d; ++i) {
      const std::size_t to = in_plane(i, d - i);
      for (int c = 2; 2 * c <= d; ++c)
        for (int a = 0; a <= i; ++a)
          for (int b = 0; b <= d - i; ++b) {
            if (a + b < 2 || d - a - b < 2 * (c - 1)) continue;
            const std::size_t x = in_plane(a, b), y = in_plane(i - a, d - i - b);
            if (h.has(x) && power(c - 1).has(y))
              accumulate(powers[static_cast<std::size_t>(c)], to, h[x], power(c - 1)[y]);
          }
      const std::size_t first = in_space(i, d - i, 0);
      if (g.has(first)) h.put(to, g[first]);
      for (int a = 0; a <= i; ++a)
        for (int b = 0; b <= d - i; ++b)
          for (int c = a + b == 0 ? 2 : 1; 2 * c <= d - a - b; ++c) {
            const std::size_t from = in_space(a, b, c), y = in_plane(i - a, d - i - b);
            if (g.has(from) && power(c).has(y)) accumulate(h, to, g[from], power(c)[y]);
          }
      if (h.has(to)) h.place(to) = h[to] * factor;
    }
  return h;
}

}  // namespace crest::certify::smooth
