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

void add_outer(Tensor& t, double f, const Vec3& a) {
  t[0] += f * a[0] * a[0];
  t[1] += f * a[1] * a[1];
  t[2] += f * a[2] * a[2];
  t[3] += f * a[0] * a[1];
  t[4] += f * a[1] * a[2];
  t[5] += f * a[0] * a[2];
}

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

std::vector<Index> PointField::within(const Vec3& centre, const Vec3& half) const {
  std::vector<Index> r;
  visit(centre, half, [&](Index i, const Vec3&, double) { r.push_back(i); });
  return r;
}

}  // namespace crest::extremal
