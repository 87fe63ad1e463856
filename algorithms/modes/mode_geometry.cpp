// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/mode_geometry.hpp"

#include <cmath>

#include "algorithms/modes/small_matrix.hpp"

namespace crest::modes {

using kernel::Vec3;
using kernel::operator+;
using kernel::operator-;
using kernel::operator*;

ModeGeometry mode_geometry(const std::array<Vec3, 4>& corners, const std::array<Tensor, 4>& tensors,
                           const std::array<double, 4>& weights) {
  Matrix3 t{};
  std::array<Matrix3, 3> change, w{};
  for (std::size_t k = 0; k < 4; ++k) t = sum(t, weights[k], deviator(tensors[k]));
  const Vec3 a = corners[1] - corners[0], b = corners[2] - corners[0], c = corners[3] - corners[0];
  const double volume = kernel::determinant(a, b, c);
  const Matrix3 gradients{kernel::cross(b, c), kernel::cross(c, a), kernel::cross(a, b)};
  // W_i, the field's derivative along axis i.
  for (std::size_t k = 0; k < 3; ++k) {
    change[k] = sum(deviator(tensors[k + 1]), -1, deviator(tensors[0]));
    for (std::size_t i = 0; i < 3; ++i) w[i] = sum(w[i], gradients[k][i] / volume, change[k]);
  }

  // mode = 3 sqrt6 d n^(-3/2) with d = det T, n = |T|^2; d_i = <T^2, W_i>, d_ij = 2 <T W_i, W_j>.
  const double d = determinant(t), n = inner(t, t), scale = 3 * std::sqrt(6.0) / (n * std::sqrt(n));
  const Matrix3 squared = product(t, t);
  Vec3 slope, growth;
  for (std::size_t i = 0; i < 3; ++i) {
    slope[i] = inner(squared, w[i]);
    growth[i] = 2 * inner(t, w[i]);
  }
  Matrix3 hessian;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const double dij = inner(product(t, w[i]), w[j]) + inner(product(t, w[j]), w[i]);
      const double nij = 2 * inner(w[i], w[j]);
      hessian[i][j] =
          scale * (dij - 1.5 * (slope[i] * growth[j] + slope[j] * growth[i] + d * nij) / n +
                   3.75 * d * growth[i] * growth[j] / (n * n));
    }
  ModeGeometry g;
  g.mode = scale * d;
  g.gradient = scale * (slope - 1.5 * d / n * growth);
  const double length = kernel::norm(g.gradient);
  g.normal = 1 / length * g.gradient;
  const Vec3 p = across(g.normal), q = kernel::cross(g.normal, p);
  // The second fundamental form: -H / |gradient| across the normal.
  const auto form = [&](const Vec3& x, const Vec3& y) {
    return -kernel::dot(x, product(hessian, y)) / length;
  };
  const double half = (form(p, p) - form(q, q)) / 2, mixed = form(p, q),
               gap = std::hypot(half, mixed);
  const double mean = (form(p, p) + form(q, q)) / 2, turn = std::atan2(mixed, half) / 2;
  g.k1 = mean + gap;
  g.k2 = mean - gap;
  g.d1 = std::cos(turn) * p + std::sin(turn) * q;
  g.d2 = kernel::cross(g.normal, g.d1);
  return g;
}

}  // namespace crest::modes
