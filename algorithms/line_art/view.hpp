// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// From where a scene is seen, and the page: millimetres, x to the right, y down.
#include <span>
#include <vector>

#include "algorithms/line_art/page_grid.hpp"

namespace crest::line_art {

/// A point of the page in mm.
using kernel::Vec2;

/// x, y: unit vectors to the right and up, z into the picture. Page point of p, with q = p - eye:
/// ((x.q / z.q - origin[0]) scale, (origin[1] - y.q / z.q) scale); parallel: q = p, no division.
struct View {
  kernel::Eye eye;
  Vec3 up{};  ///< as asked for
  Vec3 x{}, y{}, z{};
  Vec2 origin{};
  double scale = 1;
  Vec2 page{};  ///< width, height

  /// Before the page's scale, with bounds on the rounding.
  PagePoint see(const Vec3& p) const;
  std::vector<PagePoint> see(std::span<const Vec3> points) const;
  Vec2 project(const Vec3& p) const;
  /// Of the length and direction dp at p, in mm.
  Vec2 derivative(const Vec3& p, const Vec3& dp) const;
  /// From the surface towards the eye, a unit vector.
  Vec3 towards_eye(const Vec3& p) const;
};

/// What is asked for: an eye and a target, or a direction.
struct ViewRequest {
  Vec3 towards{};                ///< parallel: the direction towards the eye, exactly
  std::optional<Vec3> eye = {};  ///< perspective, from this point exactly
  std::optional<Vec3> target = {};
  Vec3 up{0, 1, 0};
  double width = 160;  ///< mm
};

/// Frames the points on the page, with a margin; at most 1.4 widths high.
/// Throws: kernel::InputError for directions that are none, up along the view, and in perspective
/// for a vertex that is not strictly in front of the eye (decided exactly).
View make_view(const ViewRequest& request, const Scene& scene);

}  // namespace crest::line_art
