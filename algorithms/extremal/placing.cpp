// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/extremal/placing.hpp"

#include "algorithms/extremal/direction.hpp"

namespace crest::extremal {
namespace {

/// lambda1 / (lambda1 + lambda2); an image's third direction does not count.
double plateness_of(const Tensor& t, const Vec3& n, bool plane) {
  const double first = kernel::dot(n, product(t, n));
  double second;
  if (plane) {
    second = t[0] + t[1] - first;
  } else {
    const auto [u, v] = kernel::frame_across(n);
    const Vec3 tu = product(t, u), tv = product(t, v);
    const double a = kernel::dot(u, tu), b = kernel::dot(u, tv), c = kernel::dot(v, tv);
    second = 0.5 * (a + c) + std::sqrt(0.25 * (a - c) * (a - c) + b * b);
  }
  const double sum = first + second;
  return sum > 0 ? std::clamp(first / sum, 0.0, 1.0) : 1;
}

}  // namespace

Vec3 projected(const Fields& fields, const Node& cell, Vec3 t) {
  const Vec3& d = fields.grid().spacing;
  const auto clamp = [&] {
    for (double& x : t) x = std::clamp(x, 1.0 / 64, 63.0 / 64);
    if (fields.grid().dimension() == 2) t[2] = 0;
  };
  clamp();
  for (int step = 0; step < 4; ++step) {
    const Local l = fields.at(cell, t);
    const Vec3 n = dominant_direction(l.tensor);
    const double g = kernel::dot(n, l.gradient), bend = kernel::dot(n, product(l.hessian, n));
    if (bend == 0) break;
    const Vec3 before = t;
    for (std::size_t k = 0; k < 3; ++k) t[k] -= std::clamp(g / bend * n[k] / d[k], -1.0, 1.0);
    clamp();
    if (kernel::norm(t - before) < 1e-5) break;
  }
  return t;
}

double level_at(const Fields& fields, const Levels& levels, const Node& cell, const Vec3& t) {
  const Local l = fields.at(cell, t);
  double r = HUGE_VAL;
  if (levels.value) r = l.value - *levels.value;
  if (levels.strength > 0) {
    const Vec3 n = dominant_direction(l.tensor);
    r = std::min(r, kernel::dot(n, product(l.hessian, n)) - levels.strength);
  }
  return r;
}

AtPlace at_place(const Local& l, bool plane) {
  AtPlace r;
  r.normal = dominant_direction(l.tensor);
  r.slope = kernel::dot(r.normal, l.gradient);
  r.bend = kernel::dot(r.normal, product(l.hessian, r.normal));
  r.s = l.s;
  r.plateness = plateness_of(l.tensor, r.normal, plane);
  return r;
}

}  // namespace crest::extremal
