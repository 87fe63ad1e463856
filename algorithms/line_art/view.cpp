// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/line_art/view.hpp"

#include <string>

#include "kernel/geometry/input_error.hpp"

namespace crest::line_art {
namespace {

using kernel::cross, kernel::dot, kernel::norm;
using kernel::operator+, kernel::operator-, kernel::operator*;

constexpr double kMargin = 0.03;  // of the width
constexpr double kTallest = 1.4;  // widths

/// A direction_of vector, whatever the length. Throws InputError for no direction.
Vec3 direction_of(const Vec3& a, const char* problem) {
  const double largest = std::max({std::abs(a[0]), std::abs(a[1]), std::abs(a[2])});
  if (!(largest > 0) || !std::isfinite(largest)) throw kernel::InputError(problem);
  const Vec3 b = {a[0] / largest, a[1] / largest, a[2] / largest};
  return (1 / norm(b)) * b;
}

void require_in_front(const View& view, const Scene& scene) {
  for (Index v = 0; v < scene.points.size(); ++v)
    if (kernel::in_front_of_eye(view.eye.at, view.z, scene.points[v]) != kernel::Sign::positive)
      throw kernel::InputError("vertex " + std::to_string(scene.input_vertex[v]) +
                               ": is not in front of the eye; move the camera back");
}

void frame(View& view, const Scene& scene, double width) {
  PageBox box;
  for (const Vec3& p : scene.points) {
    const PagePoint seen = view.see(p);
    box.add({seen.x, seen.y, seen.near, 0});
  }
  const double w = box.x1 - box.x0, h = box.y1 - box.y0;
  if (!std::isfinite(w) || !std::isfinite(h) || !(std::max(w, h) > 0))
    throw kernel::InputError("camera: the picture has no finite size; look from another place");
  const double inner = (1 - 2 * kMargin) * width;
  view.scale = std::min(inner / w, (kTallest - 2 * kMargin) * width / h);
  view.page = {width, h * view.scale + 2 * kMargin * width};
  view.origin = {0.5 * (box.x0 + box.x1) - 0.5 * view.page[0] / view.scale,
                 0.5 * (box.y0 + box.y1) + 0.5 * view.page[1] / view.scale};
}

}  // namespace

std::vector<PagePoint> View::see(std::span<const Vec3> points) const {
  std::vector<PagePoint> seen;
  seen.reserve(points.size());
  for (const Vec3& p : points) seen.push_back(see(p));
  return seen;
}

PagePoint View::see(const Vec3& p) const {
  constexpr double kErrors = 64 * kernel::kUnitRoundoff;  // of a dozen roundings, with room
  if (!eye.finite) {
    const double size = std::abs(p[0]) + std::abs(p[1]) + std::abs(p[2]);
    return {dot(x, p), dot(y, p), -dot(z, p), kErrors * size};
  }
  const Vec3 q = p - eye.at;
  const double size = std::abs(q[0]) + std::abs(q[1]) + std::abs(q[2]), depth = dot(z, q);
  const double u = dot(x, q) / depth, v = dot(y, q) / depth;
  const double error = kErrors * size;
  if (!(depth > 4 * error)) return {u, v, -depth, HUGE_VAL};
  return {u, v, -depth, std::max(error, error * (1 + std::abs(u) + std::abs(v)) / depth)};
}

Vec2 View::project(const Vec3& p) const {
  const PagePoint seen = see(p);
  return {(seen.x - origin[0]) * scale, (origin[1] - seen.y) * scale};
}

Vec2 View::derivative(const Vec3& p, const Vec3& dp) const {
  if (!eye.finite) return {scale * dot(x, dp), -scale * dot(y, dp)};
  const Vec3 q = p - eye.at;
  const double depth = dot(z, q), along = dot(z, dp) / depth;
  return {scale * (dot(x, dp) - dot(x, q) * along) / depth,
          -scale * (dot(y, dp) - dot(y, q) * along) / depth};
}

Vec3 View::towards_eye(const Vec3& p) const {
  if (!eye.finite) return -1.0 * z;
  const Vec3 q = eye.at - p;
  return (1 / norm(q)) * q;
}

View make_view(const ViewRequest& request, const Scene& scene) {
  View view;
  view.up = request.up;
  const Vec3 towards =
      request.eye ? *request.eye - request.target.value_or(Vec3{}) : request.towards;
  view.z =
      -1.0 *
      direction_of(towards, "camera: eye and target are the same or not finite; give two points");
  const Vec3 up = direction_of(request.up, "camera: up is no direction; give three numbers");
  const Vec3 right = cross(view.z, up);
  if (!(dot(right, right) > 1e-12))
    throw kernel::InputError("camera: up is along the view; give --up another direction");
  view.x = direction_of(right, "camera: up is along the view; give --up another direction");
  view.y = cross(view.x, view.z);
  view.eye = request.eye ? kernel::Eye{*request.eye, true} : kernel::Eye{towards, false};
  if (view.eye.finite) require_in_front(view, scene);
  frame(view, scene, request.width);
  return view;
}

}  // namespace crest::line_art
