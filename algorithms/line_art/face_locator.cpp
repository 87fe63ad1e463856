// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/line_art/face_locator.hpp"

#include <array>
#include <cmath>

namespace crest::line_art {
namespace {

double mean_edge(const Scene& scene, const std::vector<PagePoint>& seen) {
  double sum = 0;
  for (const kernel::Triangle& f : scene.faces)
    sum += std::hypot(seen[f[0]].x - seen[f[1]].x, seen[f[0]].y - seen[f[1]].y);
  return sum / static_cast<double>(scene.faces.size());
}

}  // namespace

FaceLocator::FaceLocator(const Scene& scene, const View& view)
    : scene_(scene),
      seen_(view.see(scene.points)),
      view_(view),
      frame_(seen_, mean_edge(scene, seen_), scene.faces.size()),
      faces_(frame_, static_cast<Index>(scene.faces.size()), [this](Index f) {
        const kernel::Triangle& t = scene_.faces[f];
        return std::array<const PagePoint*, 3>{&seen_[t[0]], &seen_[t[1]], &seen_[t[2]]};
      }) {}

std::optional<Index> FaceLocator::at(const Vec2& page) const {
  constexpr double kInside = 1e-9;  // barycentric
  const PagePoint p{page[0] / view_.scale + view_.origin[0],
                    view_.origin[1] - page[1] / view_.scale, 0, 0};
  std::vector<Index> found;
  const PagePoint* const corner[] = {&p};
  faces_.gather(frame_, corner, found);
  std::optional<Index> best;
  double nearest = -HUGE_VAL;
  bool clear = false;
  for (const Index f : found) {
    const PagePoint &a = seen_[scene_.faces[f][0]], &b = seen_[scene_.faces[f][1]],
                    &c = seen_[scene_.faces[f][2]];
    const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    const double v = ((p.x - a.x) * (c.y - a.y) - (p.y - a.y) * (c.x - a.x)) / area;
    const double w = ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) / area;
    const double least = std::min({1 - v - w, v, w});
    if (!(least > -kInside)) continue;
    // In perspective depth is not linear on the page, its inverse is.
    const auto depth = [&](const PagePoint& q) { return view_.eye.finite ? -1 / q.near : q.near; };
    const double near = (1 - v - w) * depth(a) + v * depth(b) + w * depth(c);
    if (near <= nearest) continue;
    nearest = near;
    best = f;
    clear = least > kInside;
  }
  return clear ? best : std::nullopt;
}

Vec3 FaceLocator::lift(const Vec2& page, Index face) const {
  using kernel::operator+, kernel::operator-, kernel::operator*;
  const kernel::Triangle& t = scene_.faces[face];
  const Vec3& p = scene_.points[t[0]];
  const Vec3 n = kernel::cross(scene_.points[t[1]] - p, scene_.points[t[2]] - p);
  const double u = page[0] / view_.scale + view_.origin[0];
  const double v = view_.origin[1] - page[1] / view_.scale;
  const Vec3 across = u * view_.x + v * view_.y;
  const Vec3 from = view_.eye.finite ? view_.eye.at : across;
  const Vec3 along = view_.eye.finite ? across + view_.z : view_.z;
  return from + (kernel::dot(n, p - from) / kernel::dot(n, along)) * along;
}

}  // namespace crest::line_art
