// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Fields of tensors on small meshes.
#include <cstddef>

#include "tests/certify_modes/reference_modes.hpp"

namespace crest::tests {

/// xx yy xy xz yz; zz makes the trace 0.
using Traceless = std::array<double, 5>;
inline std::array<double, 6> tensor(const Traceless& t) {
  return {t[0], t[1], -t[0] - t[1], t[2], t[4], t[3]};
}

/// T0 + x Tx + y Ty + z Tz.
using LinearField = std::array<Traceless, 4>;
/// Fields 1 to 6 of the reference table.
inline const std::array<LinearField, 6> kReferenceFields = {{
    {{{-4, 3, 6, 6, -5}, {-2, -5, 1, 6, 1}, {1, 4, 0, 6, -3}, {-5, 1, -6, 0, 0}}},
    {{{-6, -5, -5, -1, -4}, {5, 6, 4, -2, -2}, {3, -3, 3, -6, 3}, {4, -4, 0, 4, 0}}},
    {{{-3, 3, 2, -4, -1}, {3, 1, 4, 3, -5}, {3, -6, 1, -2, 2}, {-3, -3, 5, 1, 2}}},
    {{{-3, -2, -5, 5, 0}, {1, -4, -5, -5, -6}, {0, 2, -2, 6, 6}, {-6, -3, 2, 2, -1}}},
    {{{3, -2, 5, -1, 6}, {5, 5, 4, 2, -6}, {1, 6, -3, 4, -6}, {-4, -5, -1, 1, -3}}},
    {{{6, 3, -5, 1, 6}, {-2, -6, -6, -4, 4}, {3, 1, 6, 5, -1}, {-1, 6, -6, -2, 1}}},
}};

inline std::array<double, 6> at(const LinearField& field, const std::array<double, 3>& p) {
  Traceless t = field[0];
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 5; ++i) t[i] += p[k] * field[k + 1][i];
  return tensor(t);
}

/// A cube of n^3 small ones, each in six tetrahedra along one diagonal; mirrored every second one.
inline ModesInput grid(std::uint32_t n, double low, double high, const LinearField& field,
                       bool mirrored = false) {
  ModesInput input;
  const double step = (high - low) / n;
  for (std::uint32_t z = 0; z <= n; ++z)
    for (std::uint32_t y = 0; y <= n; ++y)
      for (std::uint32_t x = 0; x <= n; ++x) {
        input.points.push_back({low + step * x, low + step * y, low + step * z});
        input.tensors.push_back(at(field, input.points.back()));
      }
  const auto vertex = [&](std::array<std::uint32_t, 3> p) {
    return p[0] + (n + 1) * (p[1] + (n + 1) * p[2]);
  };
  constexpr std::array<std::array<std::size_t, 3>, 6> kOrders = {
      {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
  for (std::uint32_t z = 0; z < n; ++z)
    for (std::uint32_t y = 0; y < n; ++y)
      for (std::uint32_t x = 0; x < n; ++x)
        for (const auto& order : kOrders) {
          // From one corner of the diagonal to the other, an axis at a time.
          std::array<std::uint32_t, 3> p = {x, y, z}, step_to = {1, 1, 1};
          if (mirrored)
            for (std::size_t k = 0; k < 3; ++k)
              if (p[k] % 2 == 1) ++p[k], step_to[k] = ~0U;
          std::array<std::uint32_t, 4> tet = {vertex(p)};
          for (std::size_t k = 0; k < 3; ++k) {
            p[order[k]] += step_to[order[k]];
            tet[k + 1] = vertex(p);
          }
          input.tets.push_back(tet);
        }
  return input;
}

}  // namespace crest::tests
