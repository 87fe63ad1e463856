// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/splines/pinhole.hpp"

#include <cmath>
#include <numbers>

namespace crest::splines {

using kernel::operator*;
using kernel::operator+;
using kernel::operator-;

namespace {

Vec3 unit(const Vec3& v) {
  return (1 / std::hypot(v[0], v[1], v[2])) * v;
}

double half_extent(double angle) {
  return std::tan(angle * std::numbers::pi / 360);
}

}  // namespace

Pinhole::Axes Pinhole::axes() const {
  Axes a;
  a.forward = unit(target - eye);
  const bool along_z = a.forward[0] == 0 && a.forward[1] == 0;
  a.right = unit(kernel::cross(a.forward, along_z ? Vec3{0, 1, 0} : Vec3{0, 0, 1}));
  a.up = kernel::cross(a.right, a.forward);
  return a;
}

std::vector<Ray> Pinhole::rays() const {
  const Axes a = axes();
  const double step = 2 * half_extent(angle) / height;
  std::vector<Ray> rays;
  rays.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      rays.push_back({eye, a.forward + (step * (x + 0.5 - 0.5 * width)) * a.right +
                               (step * (0.5 * height - y - 0.5)) * a.up});
  return rays;
}

Pinhole automatic_view(const QuadraticSpline& spline, int size) {
  const Cube& n = spline.cubes();
  Vec3 low{}, high{}, middle;
  for (std::size_t k = 0; k < 3; ++k) high[k] = 2 * n[k];
  low = spline.frame().to_world(low);
  high = spline.frame().to_world(high);
  middle = 0.5 * (low + high);
  Pinhole view;
  view.width = view.height = size;
  view.target = middle;
  const double radius = 0.5 * kernel::distance(low, high);
  view.eye = middle + (1.02 * radius / std::sin(view.angle * std::numbers::pi / 360)) *
                          unit({0.55, -0.8, 0.4});
  return view;
}

}  // namespace crest::splines
