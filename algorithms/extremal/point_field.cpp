// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/extremal/point_field.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "algorithms/extremal/direction.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::extremal {
namespace {

/// Where the rim of a half plane of even points lies, in h (item 9).
constexpr double kRim = 0.47034;

/// Bounds the Hessian of theta over 8/R^2, y being the least (distance/R)^2.
double kappa(double y) {
  if (y >= 1) return 0;
  const double s = 1 - y;
  return y >= 3.0 / 7 ? s * s * (7 * y - 1) : std::max(s * s * s, 32.0 / 49);
}

/// Bounds the third derivatives of theta, as a trilinear form, over 48/R^3: along a unit vector
/// with q = x.u/R they are q (1 - y) (3 (1 - y) - 4 q^2), q^2 <= y; the largest from y on.
double kappa3(double y) {
  if (y >= 1) return 0;
  const double s = 1 - y, root = std::sqrt(y);
  const double inner = y < 0.1156 ? 0.659 : y < 0.2 ? s * root * (3 - 7 * y) : s * s * std::sqrt(s);
  const double outer = y < 0.7416 ? 0.488 : s * root * (7 * y - 3);
  return std::max(inner, outer);
}

void add_outer(Tensor& t, double f, const Vec3& a) {
  t[0] += f * a[0] * a[0];
  t[1] += f * a[1] * a[1];
  t[2] += f * a[2] * a[2];
  t[3] += f * a[0] * a[1];
  t[4] += f * a[1] * a[2];
  t[5] += f * a[0] * a[2];
}

Vec3 corner_of(const Vec3& half, int i) {
  return {(i & 1) != 0 ? half[0] : -half[0], (i & 2) != 0 ? half[1] : -half[1],
          (i & 4) != 0 ? half[2] : -half[2]};
}

double largest(const Tensor& t) {
  double r = 0;
  for (const double x : t) r = std::max(r, std::fabs(x));
  return r;
}

double dot_form(const Vec3& u, const Tensor& t, const Vec3& v) {
  return kernel::dot(u, product(t, v));
}

/// T and grad s with derivatives at a box's centre, and sums of bounds.
struct Expansion {
  Tensor t{};
  std::array<Tensor, 3> dt{};
  Vec3 gradient{};
  Tensor hessian{};
  double curved = 0;  ///< sum of kappa
  double third = 0;   ///< of kappa3
};

}  // namespace

PointField::PointField(std::vector<Vec3> points, std::vector<Vec3> normals, double h)
    : h_(h), radius_(2 * h), low_(points[0]) {
  Vec3 high = low_;
  for (const Vec3& p : points)
    for (std::size_t k = 0; k < 3; ++k) {
      low_[k] = std::min(low_[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  if (!(kernel::norm(high - low_) < 1e6 * h))
    throw kernel::InputError(
        "radius: less than a millionth of the points' extent; give a larger one");
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    const Key ka = key(points[a]), kb = key(points[b]);
    return std::tuple(ka, points[a][2], a) < std::tuple(kb, points[b][2], b);
  });
  for (const Index i : order) {
    const auto at = static_cast<Index>(points_.size());
    auto& range = columns_.try_emplace(key(points[i]), at, at).first->second;
    range.second = at + 1;
    points_.push_back(points[i]);
    normals_.push_back(normals[i]);
  }
}

PointField::Key PointField::key(const Vec3& x) const {
  const Vec3 d = x - low_;
  return {static_cast<int>(std::floor(d[0] / radius_)),
          static_cast<int>(std::floor(d[1] / radius_))};
}

/// All points within R of the box, in a fixed order.
template <class Visit>
void PointField::visit(const Vec3& centre, const Vec3& half, const Visit& f) const {
  const Vec3 reach = half + Vec3{radius_, radius_, radius_};
  const Key low = key(centre - reach), high = key(centre + reach);
  const double square = radius_ * radius_;
  for (int y = low[1]; y <= high[1]; ++y)
    for (int x = low[0]; x <= high[0]; ++x) {
      const auto found = columns_.find({x, y});
      if (found == columns_.end()) continue;
      const auto end = points_.begin() + found->second.second;
      auto p = std::lower_bound(points_.begin() + found->second.first, end, centre[2] - reach[2],
                                [](const Vec3& a, double z) { return a[2] < z; });
      for (; p != end && (*p)[2] <= centre[2] + reach[2]; ++p) {
        const Vec3 d = centre - *p;
        double least = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          const double beyond = std::max(0.0, std::fabs(d[k]) - half[k]);
          least += beyond * beyond;
        }
        if (least < square) f(static_cast<Index>(p - points_.begin()), d, least);
      }
    }
}

PointField::Sums PointField::at(const Vec3& x) const {
  Sums r{};
  const double inverse = 1 / (radius_ * radius_);
  double nearest = radius_ * radius_, total = 0;
  Vec3 centroid{};
  visit(x, {0, 0, 0}, [&](Index i, const Vec3& d, double square) {
    const double y = square * inverse, s = 1 - y, s2 = s * s, theta = s2 * s2;
    ++r.count;
    nearest = std::min(nearest, square);
    total += theta;
    centroid = centroid - theta * d;
    add_outer(r.local.tensor, theta, normals_[i]);
    const double first = 8 * inverse * s2 * s;
    r.local.gradient = r.local.gradient + first * d;
    for (std::size_t k = 0; k < 3; ++k) r.local.hessian[k] += first;
    add_outer(r.local.hessian, -48 * inverse * inverse * s2, d);
  });
  r.local.value = total;
  r.local.s = -total;
  r.centroid = total > 0 ? x + (1 / total) * centroid : x;
  r.nearest = std::sqrt(nearest);
  return r;
}

double PointField::inside(const Sums& sums, const Vec3& x, const Vec3& n) const {
  const Vec3 d = sums.centroid - x;
  return kRim * h_ - kernel::norm(d - kernel::dot(d, n) * n);
}

PointField::Box PointField::box_in_parts(const Vec3& centre, const Vec3& half) const {
  Box r = box(centre, half);
  if (!r.near || r.nonzero || half[0] <= h_ / 8) return r;
  r.nonzero = true;
  for (int part = 0; part < 8 && r.nonzero; ++part) {
    const Box b = box_in_parts(centre + 0.5 * corner_of(half, part), 0.5 * half);
    r.nonzero = !b.near || b.nonzero;
  }
  return r;
}

PointField::Box PointField::box(const Vec3& centre, const Vec3& half) const {
  Box r;
  Expansion e;
  const double inverse = 1 / (radius_ * radius_), near = 0.81 * h_ * h_;
  visit(centre, half, [&](Index i, const Vec3& d, double least) {
    r.near = r.near || least <= near;
    if (least == 0) ++r.inside;
    e.curved += kappa(least * inverse);
    e.third += kappa3(least * inverse);
    const double y = kernel::dot(d, d) * inverse;
    if (y >= 1) return;
    const double s = 1 - y, s2 = s * s, first = 8 * inverse * s2 * s;
    add_outer(e.t, s2 * s2, normals_[i]);
    e.gradient = e.gradient + first * d;
    for (std::size_t k = 0; k < 3; ++k) {
      add_outer(e.dt[k], -first * d[k], normals_[i]);
      e.hessian[k] += first;
    }
    add_outer(e.hessian, -48 * inverse * inverse * s2, d);
  });
  if (!r.near) return r;
  const double square = kernel::dot(half, half), lipschitz = 8 * inverse * e.curved;
  // |M_p| <= 1 and |b_p| <= 1/2.
  const double rest = 0.5 * square * lipschitz;
  r.w = dominant_direction(e.t);
  const auto [u, v] = kernel::frame_across(r.w);
  double gap = HUGE_VAL, across = 0;
  for (int corner = 0; corner < 8; ++corner) {
    Tensor t = e.t;
    const Vec3 step = corner_of(half, corner);
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < 6; ++i) t[i] += step[k] * e.dt[k][i];
    const double a = dot_form(u, t, u), b = dot_form(u, t, v), c = dot_form(v, t, v);
    gap = std::min(
        gap, dot_form(r.w, t, r.w) - 0.5 * (a + c) - std::sqrt(0.25 * (a - c) * (a - c) + b * b));
    const double x = dot_form(u, t, r.w), y = dot_form(v, t, r.w);
    across = std::max(across, x * x + y * y);
  }
  gap = gap * (1 - 1e-9) - rest - 1e-10 * largest(e.t);
  r.passed = gap > 0;
  if (!r.passed) return r;
  r.theta = 0.5 * std::atan(2 * (std::sqrt(across) + 0.5 * rest) / gap);
  // grad s is its value at the centre, or its linear part there, and a rest.
  const double cosine = std::cos(r.theta), sine = std::sin(r.theta) * (1 + 1e-9);
  const auto clear = [&](int corners, double turn) {
    double low = HUGE_VAL, high = -HUGE_VAL, aside = 0;
    for (int corner = 0; corner < corners; ++corner) {
      Vec3 g = e.gradient;
      if (corners > 1) g = g + product(e.hessian, corner_of(half, corner));
      low = std::min(low, kernel::dot(r.w, g));
      high = std::max(high, kernel::dot(r.w, g));
      const double x = kernel::dot(u, g), y = kernel::dot(v, g);
      aside = std::max(aside, x * x + y * y);
    }
    return (std::max(low, -high) - turn) * cosine > (std::sqrt(aside) + turn) * sine;
  };
  const double third = 48 * e.third / (radius_ * radius_ * radius_);
  r.nonzero = clear(1, std::sqrt(square) * lipschitz * (1 + 1e-9)) ||
              clear(8, 0.5 * square * third * (1 + 1e-9));
  return r;
}

}  // namespace crest::extremal
