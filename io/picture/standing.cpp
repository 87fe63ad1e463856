// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/picture/standing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace crest::io {
namespace {

using kernel::Vec3;

constexpr double kFeet = 0.03;   // of the height
constexpr double kLeast = 0.2;   // of the area
constexpr double kEqual = 0.7;   // of the largest share
constexpr int kDirections = 32;  // in which the polygon around points is looked for

/// Of points of a plane: of the polygon of those that reach farthest.
class Outline {
 public:
  Outline() {
    constexpr double turn = 6.283185307179586 / kDirections;
    for (int i = 0; i < kDirections; ++i)
      directions_[at(i)] = {std::cos(turn * i), std::sin(turn * i)};
    reach_.fill(-std::numeric_limits<double>::infinity());
  }
  void add(double x, double y) {
    for (std::size_t i = 0; i < kDirections; ++i) {
      const double reach = directions_[i][0] * x + directions_[i][1] * y;
      if (!(reach > reach_[i])) continue;
      reach_[i] = reach;
      farthest_[i] = {x, y};
    }
  }
  double area() const {
    double twice = 0;
    for (int i = 0; i < kDirections; ++i) {
      const auto& [x, y] = farthest_[at(i)];
      const auto& [u, v] = farthest_[at((i + 1) % kDirections)];
      twice += x * v - y * u;
    }
    return 0.5 * twice;
  }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  std::array<std::array<double, 2>, kDirections> directions_{}, farthest_{};
  std::array<double, kDirections> reach_{};
};

/// The area around the feet as a share of that around the shape.
double share_of_feet(const std::vector<Vec3>& points, std::size_t axis) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Vec3& p : points) {
    low = std::min(low, p[axis]);
    high = std::max(high, p[axis]);
  }
  const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  const Vec3& origin = points[0];  // differences are exact enough where coordinates are large
  Outline feet, all;
  for (const Vec3& p : points) {
    const double x = p[u] - origin[u], y = p[v] - origin[v];
    all.add(x, y);
    if (p[axis] <= low + kFeet * (high - low)) feet.add(x, y);
  }
  return all.area() > 0 ? feet.area() / all.area() : 0;
}

}  // namespace

std::optional<Vec3> standing_direction(const SurfaceView& mesh) {
  if (mesh.points().empty()) return std::nullopt;
  std::array<double, 3> share{};
  for (std::size_t axis = 0; axis < 3; ++axis) share[axis] = share_of_feet(mesh.points(), axis);
  const double least = std::max(kLeast, kEqual * *std::max_element(share.begin(), share.end()));
  for (const std::size_t axis : {1, 2, 0}) {
    if (share[axis] < least) continue;
    Vec3 up{};
    up[axis] = 1;
    return up;
  }
  return std::nullopt;
}

}  // namespace crest::io
