// SPDX-License-Identifier: GPL-3.0-or-later

// The spline pair at nodes, where 27 coefficients are all that count.
#include <algorithm>
#include <cmath>

#include "algorithms/extremal/fields.hpp"
#include "kernel/arithmetic/rational.hpp"
#include "kernel/polynomial/spline_net.hpp"

namespace crest::extremal {
namespace {

using kernel::Rational;
template <class T>
using Near = std::array<T, 27>;  ///< x fastest

template <class T>
Near<T> near_node(const Grid& g, const std::vector<float>& c, const Node& v) {
  std::array<std::array<std::size_t, 3>, 3> at;
  for (std::size_t k = 0; k < 3; ++k)
    for (int i = 0; i < 3; ++i)
      at[k][static_cast<std::size_t>(i)] =
          static_cast<std::size_t>(std::clamp(v[k] - 1 + i, 0, g.size[k] - 1)) * g.stride[k];
  Near<T> r;
  for (std::size_t z = 0, n = 0; z < 3; ++z)
    for (std::size_t y = 0; y < 3; ++y)
      for (std::size_t x = 0; x < 3; ++x, ++n)
        r[n] = T(static_cast<double>(c[at[2][z] + at[1][y] + at[0][x]]));
  return r;
}

/// 1 4 1, -1 0 1 and 1 -2 1: six, two and one times the derivatives of order 0, 1, 2.
template <class T>
T combine(const T& a, const T& b, const T& c, int order) {
  if (order == 0) return a + T(4) * b + c;
  if (order == 1) return c - a;
  return a - T(2) * b + c;
}

template <class T>
T node_value(const Near<T>& c, int x, int y, int z) {
  std::array<T, 9> rows;
  for (std::size_t i = 0; i < 9; ++i) rows[i] = combine(c[3 * i], c[3 * i + 1], c[3 * i + 2], x);
  std::array<T, 3> planes;
  for (std::size_t i = 0; i < 3; ++i)
    planes[i] = combine(rows[3 * i], rows[3 * i + 1], rows[3 * i + 2], y);
  return combine(planes[0], planes[1], planes[2], z);
}

double largest(const Near<double>& c) {
  double r = 0;
  for (const double x : c) r = std::max(r, std::fabs(x));
  return r;
}

/// Hess of the spline itself, times s.
template <class T>
kernel::Symmetric3<T> node_hessian(const Near<T>& l, const Vec3& spacing, double sign) {
  const T dx(spacing[0]), dy(spacing[1]), dz(spacing[2]), s(sign);
  return {s * node_value(l, 2, 0, 0) / (T(36) * dx * dx),
          s * node_value(l, 0, 2, 0) / (T(36) * dy * dy),
          s * node_value(l, 0, 0, 2) / (T(36) * dz * dz),
          s * node_value(l, 1, 1, 0) / (T(24) * dx * dy),
          s * node_value(l, 0, 1, 1) / (T(24) * dy * dz),
          s * node_value(l, 1, 0, 1) / (T(24) * dx * dz)};
}
template <class T>
kernel::Vector3<T> node_gradient(const Near<T>& l, const Vec3& spacing, double sign) {
  const T s(sign), f(72);
  return {s * node_value(l, 1, 0, 0) / (f * T(spacing[0])),
          s * node_value(l, 0, 1, 0) / (f * T(spacing[1])),
          s * node_value(l, 0, 0, 1) / (f * T(spacing[2]))};
}

}  // namespace

// Errors: less than 16 roundings of sums whose absolute weights are 1 (order 0), 1 (order 1) and 4
// (order 2).
Fields::AtNode Fields::at_node(const Node& v) const {
  const auto l = near_node<double>(grid_, scalars_, v);
  const Vec3& d = grid_.spacing;
  const double least = std::min({d[0], d[1], d[2]}), scalar = largest(l);
  // Wider than these roundings: what is certain here must be so by the checker's bounds.
  const double error = grid_.dimension() == 2 ? 0x1p-38 : 0x1p-42;
  AtNode r;
  r.gradient = node_gradient(l, d, sign_);
  r.gradient_error = 0x1p-48 * scalar / least;
  r.tensor = {};
  if (structure_) {
    double size = 0;
    for (std::size_t i = 0; i < tensors_.size(); ++i) {
      const auto c = near_node<double>(grid_, tensors_[i], v);
      size = std::max(size, largest(c));
      r.tensor[entry(i)] = node_value(c, 0, 0, 0) / 216;
    }
    r.tensor_error = error * size;
  } else {
    r.tensor = node_hessian(l, d, sign_);
    r.tensor_error = error * scalar / (least * least);
  }
  if (grid_.dimension() == 2) r.tensor[2] = below(r.tensor);
  r.tensor_size = 0;
  for (const double x : r.tensor) r.tensor_size = std::max(r.tensor_size, std::fabs(x));
  return r;
}

std::pair<kernel::Symmetric3<Rational>, kernel::Vector3<Rational>> Fields::exact_at_node(
    const Node& v) const {
  const auto l = near_node<Rational>(grid_, scalars_, v);
  kernel::Symmetric3<Rational> t = {0, 0, 0, 0, 0, 0};
  if (structure_)
    for (std::size_t i = 0; i < tensors_.size(); ++i)
      t[entry(i)] = node_value(near_node<Rational>(grid_, tensors_[i], v), 0, 0, 0);
  else
    t = node_hessian(l, grid_.spacing, sign_);
  if (grid_.dimension() == 2) t[2] = -2 * (abs(t[0]) + abs(t[1]) + abs(t[3])) - 1;
  return {t, node_gradient(l, grid_.spacing, sign_)};
}

ExactLocal Fields::exact_at(const Node& v, const Vec3& t) const {
  std::array<std::array<std::array<Rational, 4>, 3>, 3> w;
  for (std::size_t k = 0; k < 3; ++k)
    for (int order = 0; order < 3; ++order)
      w[k][static_cast<std::size_t>(order)] = kernel::spline_weights(Rational(t[k]), order);
  const auto value = [&](const std::vector<float>& spline, std::size_t a, std::size_t b,
                         std::size_t c) {
    const Coefficients near = coefficients(spline, v);
    kernel::SplineCell<Rational, 3> cell;
    std::copy(near.begin(), near.end(), cell.begin());
    return kernel::spline_value<Rational, 3>(cell, {w[0][a], w[1][b], w[2][c]});
  };
  const Rational s(sign_), x(grid_.spacing[0]), y(grid_.spacing[1]), z(grid_.spacing[2]);
  ExactLocal r;
  r.value = value(scalars_, 0, 0, 0);
  r.hessian = {s * value(scalars_, 2, 0, 0) / (x * x), s * value(scalars_, 0, 2, 0) / (y * y),
               s * value(scalars_, 0, 0, 2) / (z * z), s * value(scalars_, 1, 1, 0) / (x * y),
               s * value(scalars_, 0, 1, 1) / (y * z), s * value(scalars_, 1, 0, 1) / (x * z)};
  r.tensor = r.hessian;
  if (structure_) {
    r.tensor = {0, 0, 0, 0, 0, 0};
    for (std::size_t i = 0; i < tensors_.size(); ++i)
      r.tensor[entry(i)] = value(tensors_[i], 0, 0, 0);
  }
  if (grid_.dimension() == 2)
    r.tensor[2] = -2 * (abs(r.tensor[0]) + abs(r.tensor[1]) + abs(r.tensor[3])) - 1;
  return r;
}

}  // namespace crest::extremal
