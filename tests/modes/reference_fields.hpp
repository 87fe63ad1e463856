// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Linear fields with known mode surfaces and degenerate curves, sampled on tet meshes of a box.
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "kernel/arithmetic/vec3.hpp"

namespace crest::tests {

/// T0, Tx, Ty, Tz; each xx yy xy xz yz (zz = -xx - yy).
using LinearField = std::array<std::array<int, 5>, 4>;

inline const std::array<LinearField, 6>& reference_fields() {
  static const std::array<LinearField, 6> fields{{
      {{{-4, 3, 6, 6, -5}, {-2, -5, 1, 6, 1}, {1, 4, 0, 6, -3}, {-5, 1, -6, 0, 0}}},
      {{{-6, -5, -5, -1, -4}, {5, 6, 4, -2, -2}, {3, -3, 3, -6, 3}, {4, -4, 0, 4, 0}}},
      {{{-3, 3, 2, -4, -1}, {3, 1, 4, 3, -5}, {3, -6, 1, -2, 2}, {-3, -3, 5, 1, 2}}},
      {{{-3, -2, -5, 5, 0}, {1, -4, -5, -5, -6}, {0, 2, -2, 6, 6}, {-6, -3, 2, 2, -1}}},
      {{{3, -2, 5, -1, 6}, {5, 5, 4, 2, -6}, {1, 6, -3, 4, -6}, {-4, -5, -1, 1, -3}}},
      {{{6, 3, -5, 1, 6}, {-2, -6, -6, -4, 4}, {3, 1, 6, 5, -1}, {-1, 6, -6, -2, 1}}},
  }};
  return fields;
}

/// mu* = 143/343, the node at the origin.
inline const LinearField& node_field() {
  static const LinearField field{
      {{11, -13, 0, 0, 0}, {0, 0, 1, 0, 0}, {0, 0, 0, 1, 0}, {0, 0, 0, 0, 1}}};
  return field;
}

struct SampledField {
  std::vector<kernel::Vec3> points;
  std::vector<std::array<std::uint32_t, 4>> tets;
  std::vector<std::array<double, 6>> tensors;  ///< xx yy zz xy yz xz
};

/// VTK's order.
inline std::array<double, 6> tensor_at(const LinearField& field, const kernel::Vec3& x) {
  std::array<double, 5> t{};
  for (std::size_t k = 0; k < 5; ++k)
    t[k] = field[0][k] + field[1][k] * x[0] + field[2][k] * x[1] + field[3][k] * x[2];
  return {t[0], t[1], -t[0] - t[1], t[2], t[4], t[3]};
}

/// The box [-size, size]^3 in n^3 cubes of six tets along the diagonal (0,0,0)-(1,1,1); mirrored:
/// every cube's split is its neighbours' mirror image.
inline SampledField box_mesh(std::uint32_t n, double size, bool mirrored = false) {
  SampledField field;
  const auto at = [n](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
    return i + (n + 1) * (j + (n + 1) * k);
  };
  for (std::uint32_t k = 0; k <= n; ++k)
    for (std::uint32_t j = 0; j <= n; ++j)
      for (std::uint32_t i = 0; i <= n; ++i)
        field.points.push_back(
            {size * (2.0 * i / n - 1), size * (2.0 * j / n - 1), size * (2.0 * k / n - 1)});
  const std::array<std::array<std::size_t, 3>, 6> orders{
      {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {1, 0, 2}, {2, 1, 0}}};
  for (std::uint32_t k = 0; k < n; ++k)
    for (std::uint32_t j = 0; j < n; ++j)
      for (std::uint32_t i = 0; i < n; ++i)
        for (std::size_t order = 0; order < 6; ++order) {
          std::array<std::uint32_t, 3> step{};
          std::array<std::uint32_t, 4> tet{};
          const std::array<std::uint32_t, 3> cube{i, j, k};
          std::uint32_t turns = 0;
          for (const std::uint32_t c : cube) turns += mirrored ? c % 2 : 0;
          for (std::size_t s = 0; s < 4; ++s) {
            std::array<std::uint32_t, 3> corner{};
            for (std::size_t d = 0; d < 3; ++d)
              corner[d] = cube[d] + (mirrored && cube[d] % 2 ? 1 - step[d] : step[d]);
            tet[s] = at(corner[0], corner[1], corner[2]);
            if (s < 3) step[orders[order][s]] = 1;
          }
          if ((order >= 3) != (turns % 2 == 1)) std::swap(tet[2], tet[3]);
          field.tets.push_back(tet);
        }
  return field;
}

inline SampledField sampled(const LinearField& field, std::uint32_t n, double size,
                            bool mirrored = false) {
  SampledField result = box_mesh(n, size, mirrored);
  for (const kernel::Vec3& x : result.points) result.tensors.push_back(tensor_at(field, x));
  return result;
}

/// The sum of w[i] t[i].
template <std::size_t K>
std::array<double, 6> blend(const std::array<std::array<double, 6>, K>& t,
                            const std::array<double, K>& w) {
  std::array<double, 6> sum{};
  for (std::size_t i = 0; i < K; ++i)
    for (std::size_t k = 0; k < 6; ++k) sum[k] += w[i] * t[i][k];
  return sum;
}

/// In [-1, 1].
inline double mode_of(const std::array<double, 6>& a) {
  const double m = (a[0] + a[1] + a[2]) / 3, x = a[0] - m, y = a[1] - m, z = a[2] - m;
  const double det =
      x * (y * z - a[4] * a[4]) - a[3] * (a[3] * z - a[4] * a[5]) + a[5] * (a[3] * a[4] - y * a[5]);
  const double n = x * x + y * y + z * z + 2 * (a[3] * a[3] + a[4] * a[4] + a[5] * a[5]);
  return 3 * std::sqrt(6.0) * det / (n * std::sqrt(n));
}

}  // namespace crest::tests
