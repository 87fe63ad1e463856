// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/line_art/view_choice.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/picture/camera.hpp"

namespace crest::io {
namespace {

using kernel::Vec3;
using kernel::operator+, kernel::operator-, kernel::operator*;

/// The direction towards the eye and what is up, of --view or as the shape asks for.
struct Direction {
  Vec3 towards, up;
};
Direction direction_of(const ViewChoice& o, const line_art::Scene& scene) {
  if (!o.angles) {
    const Camera camera =
        make_camera(SurfaceView(scene.points, scene.faces), {std::nullopt, o.up}, 1000);
    return {-1.0 * camera.forward, o.up.value_or(camera.up)};
  }
  const double a = (*o.angles)[0] * std::numbers::pi / 180;
  const double e = (*o.angles)[1] * std::numbers::pi / 180;
  const bool along_y = std::abs(std::cos(e)) < 1e-3;
  return {{std::cos(e) * std::sin(a), std::sin(e), std::cos(e) * std::cos(a)},
          o.up.value_or(along_y ? Vec3{0, 0, 1} : Vec3{0, 1, 0})};
}

/// A sphere around the scene.
std::pair<Vec3, double> ball_around(const line_art::Scene& scene) {
  Vec3 low = scene.points[0], high = low;
  for (const Vec3& p : scene.points)
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  const Vec3 centre = 0.5 * low + 0.5 * high;
  double radius = 0;
  for (const Vec3& p : scene.points) radius = std::max(radius, kernel::distance(p, centre));
  return {centre, radius};
}

}  // namespace

line_art::ViewRequest view_request(const ViewChoice& o, const line_art::Scene& scene) {
  line_art::ViewRequest request;
  request.width = o.width;
  if (o.camera) {
    const auto& c = *o.camera;
    const Vec3 eye = {c[0], c[1], c[2]}, target = {c[3], c[4], c[5]};
    request.towards = eye - target;
    const Vec3 t = normalised(request.towards, {0, 0, 1});
    request.up = o.up.value_or(std::abs(t[1]) > 0.999 ? Vec3{0, 0, 1} : Vec3{0, 1, 0});
    if (o.perspective) {
      request.eye = eye;
      request.target = target;
    }
    return request;
  }
  const Direction direction = direction_of(o, scene);
  request.towards = direction.towards;
  request.up = direction.up;
  if (o.perspective) {
    const auto [centre, radius] = ball_around(scene);
    const double distance = 1.01 * radius / std::sin(*o.perspective * std::numbers::pi / 360);
    request.eye = centre + distance * normalised(direction.towards, {0, 0, 1});
    request.target = centre;
  }
  return request;
}

}  // namespace crest::io
