// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/splines/ray_picture.hpp"

#include <cmath>

#include "io/picture/picture_file.hpp"

namespace crest::io {
namespace {

std::uint8_t tinted(std::uint8_t channel, double factor) {
  return static_cast<std::uint8_t>(channel * factor + 0.5);
}

}  // namespace

void draw_rays(Canvas& canvas, int left, int top, const splines::Pinhole& camera,
               std::span<const splines::Hit> hits, std::span<const kernel::Vec3> tints) {
  const auto axes = camera.axes();
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (!hits[i].hit) continue;
    const kernel::Vec3& g = hits[i].gradient;
    // On a plateau there is no normal: as if it faced the eye.
    const double length = std::hypot(g[0], g[1], g[2]);
    kernel::Vec3 n = {0, 0, 1};
    if (length > 0)
      n = {dot(g, axes.right) / length, dot(g, axes.up) / length, -dot(g, axes.forward) / length};
    const double x = left + static_cast<double>(i % static_cast<std::size_t>(camera.width));
    const double y = top + static_cast<double>(i / static_cast<std::size_t>(camera.width));
    Rgb colour = shaded(n);
    if (!tints.empty())
      colour = {tinted(colour.red, tints[i][0]), tinted(colour.green, tints[i][1]),
                tinted(colour.blue, tints[i][2])};
    canvas.fill_box(x, y, x + 1, y + 1, colour);
  }
}

void write_ray_picture(const std::string& path, const splines::Pinhole& camera,
                       std::span<const splines::Hit> hits) {
  Canvas canvas(camera.width, camera.height);
  draw_rays(canvas, 0, 0, camera, hits);
  write_canvas(path, canvas, camera.width, camera.height);
}

}  // namespace crest::io
