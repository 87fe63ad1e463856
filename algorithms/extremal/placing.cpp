// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/extremal/placing.hpp"

#include "algorithms/extremal/direction.hpp"
#include "algorithms/extremal/straight_way.hpp"
#include "kernel/predicates/direction_sign.hpp"

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

Vec3 inside_cell(Vec3 t, bool plane) {
  for (double& x : t) x = std::clamp(x, 1.0 / 64, 63.0 / 64);
  if (plane) t[2] = 0;
  return t;
}

/// From a place of a cell along n to g = 0, inside the cell.
Vec3 projected(const Fields& fields, const Node& cell, Vec3 t) {
  const Vec3& d = fields.grid().spacing;
  const bool plane = fields.grid().dimension() == 2;
  t = inside_cell(t, plane);
  for (int step = 0; step < 4; ++step) {
    const Local l = fields.at(cell, t);
    const Vec3 n = dominant_direction(l.tensor);
    const double g = kernel::dot(n, l.gradient), bend = kernel::dot(n, product(l.hessian, n));
    if (bend == 0) break;
    const Vec3 before = t;
    for (std::size_t k = 0; k < 3; ++k) t[k] -= std::clamp(g / bend * n[k] / d[k], -1.0, 1.0);
    t = inside_cell(t, plane);
    if (kernel::norm(t - before) < 1e-5) break;
  }
  return t;
}

}  // namespace

Vec3 vertex_place(const Fields& fields, const Node& cell, const Vec3& centre,
                  std::span<const Vec3> zeros) {
  const Vec3 usual = projected(fields, cell, centre);
  if (zeros.empty()) return usual;
  const bool plane = fields.grid().dimension() == 2;
  const CellWays ways(fields, cell);
  if (std::any_of(zeros.begin(), zeros.end(),
                  [&](const Vec3& zero) { return ways.one_branch(zero, usual); }))
    return usual;
  for (double part = 1; part >= 1.0 / 64; part /= 2)
    for (const Vec3& zero : zeros) {
      const Vec3 near = inside_cell(zero + part * (centre - zero), plane);
      for (const Vec3& t : {projected(fields, cell, near), near})
        if (ways.one_branch(zero, t)) return t;
    }
  // No cone holds n even so near: next to a zero, where there is a direction.
  for (const Vec3& zero : zeros)
    if (const Vec3 near = inside_cell(zero, plane); ways.one_branch(near, near)) return near;
  return usual;
}

namespace {

/// The level where it is that much or more, exactly, or less: trim.hpp asks for its sign alone.
double with_sign(double level, bool kept) {
  return kept ? std::max(level, 0.0) : std::min(level, -0x1p-1000);
}
/// Relative to the coefficients and to Hess s: below, rationals decide.
constexpr double kTie = 0x1p-32;

}  // namespace

double level_at(const Fields& fields, const Levels& levels, const Node& cell, const Vec3& t) {
  const Local l = fields.at(cell, t);
  double r = HUGE_VAL;
  if (levels.value) {
    r = l.value - *levels.value;
    double size = std::fabs(*levels.value);  // the coefficients', about
    for (std::size_t k = 0; k < 3; ++k) {
      const double d = fields.grid().spacing[k];
      size = std::max({size, d * std::fabs(l.gradient[k]), d * d * std::fabs(l.hessian[k])});
    }
    if (std::fabs(r) <= kTie * size)
      r = with_sign(r, fields.exact_at(cell, t).value >= kernel::Rational(*levels.value));
  }
  if (levels.strength > 0) {
    const Vec3 n = dominant_direction(l.tensor);
    double above = kernel::dot(n, product(l.hessian, n)) - levels.strength, size = levels.strength;
    for (const double x : l.hessian) size = std::max(size, std::fabs(x));
    double tensor_size = 0;
    for (const double x : l.tensor) tensor_size = std::max(tensor_size, std::fabs(x));
    // The rule asks for a direction that is certain; without one the checker refuses the place.
    if (std::fabs(above) <= kTie * size &&
        kernel::cone_margin(l.tensor, tensor_size, 0x1p-40 * tensor_size, n) > 0) {
      ExactLocal exact = fields.exact_at(cell, t);
      for (std::size_t k = 0; k < 3; ++k) exact.hessian[k] -= kernel::Rational(levels.strength);
      const auto sign =
          kernel::exact_form_sign(exact.tensor, exact.hessian, kernel::lift<kernel::Rational>(n));
      above = with_sign(above, sign != kernel::Sign::negative);
    }
    r = std::min(r, above);
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
