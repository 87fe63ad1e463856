// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The sphere of medium eigenvectors of a linear field, to be painted; the field of the pictures.
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "algorithms/modes/sphere.hpp"
#include "io/picture/picture_file.hpp"

namespace crest::experiments {

/// Field 3 of the specification's table (mu* = 0.916) at the origin, the changes of it along x, y,
/// z: rows xx yy zz xy yz xz.
inline std::array<modes::Tensor, 4> field_3() {
  constexpr std::array<std::array<double, 5>, 4> f{
      {{-3, 3, 2, -4, -1}, {3, 1, 4, 3, -5}, {3, -6, 1, -2, 2}, {-3, -3, 5, 1, 2}}};
  std::array<modes::Tensor, 4> rows;
  for (std::size_t i = 0; i < 4; ++i)
    rows[i] = {f[i][0], f[i][1], -f[i][0] - f[i][1], f[i][2], f[i][4], f[i][3]};
  return rows;
}
/// Its tensors at four points.
inline std::array<modes::Tensor, 4> field_3_at(const std::array<kernel::Vec3, 4>& corners) {
  const auto rows = field_3();
  std::array<modes::Tensor, 4> tensors;
  tensors.fill(rows[0]);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t e = 0; e < 6; ++e) tensors[i][e] += corners[i][k] * rows[k + 1][e];
  return tensors;
}

/// The sphere of medium eigenvectors as seen from a direction of Tbar's frame.
class SpherePicture {
 public:
  SpherePicture(const modes::LinearTensors& f, int width, const kernel::Vec3& eye)
      : f_(f), width_(width), canvas_(width, width) {
    using kernel::operator*;
    eye_ = (1 / kernel::norm(eye)) * eye;
    const kernel::Vec3 right = kernel::cross(kernel::Vec3{0, 1, 0}, eye_);
    right_ = (1 / kernel::norm(right)) * right;
    up_ = kernel::cross(eye_, right_);
    canvas_.fill_box(0, 0, width, width, {255, 255, 255});
  }

  kernel::Vec3 world(const kernel::Vec3& in_frame) const {
    using kernel::operator+, kernel::operator*;
    return in_frame[0] * f_.frame()[0] + in_frame[1] * f_.frame()[1] + in_frame[2] * f_.frame()[2];
  }
  /// colour_of(v): of a point of the sphere in space, before it is shaded.
  template <class Colour>
  void paint(Colour&& colour_of) {
    using kernel::operator+, kernel::operator*;
    const double r = 0.46 * width_, middle = width_ / 2.0;
    for (int j = 0; j < 2 * width_; ++j)
      for (int i = 0; i < 2 * width_; ++i) {
        const double px = (i + 0.5) / 2, py = (j + 0.5) / 2, x = (px - middle) / r,
                     y = (middle - py) / r;
        if (x * x + y * y > 1) continue;
        const double z = std::sqrt(1 - x * x - y * y);
        const io::Rgb colour = colour_of(world(x * right_ + y * up_ + z * eye_));
        const double shade = 0.55 + 0.45 * z;
        const auto tone = [&](std::uint8_t c) { return static_cast<std::uint8_t>(c * shade); };
        canvas_.fill_box(px - 0.25, py - 0.25, px + 0.25, py + 0.25,
                         {tone(colour.red), tone(colour.green), tone(colour.blue)});
      }
  }
  void line(const kernel::Vec3& a, const kernel::Vec3& b, double width, io::Rgb colour) {
    if (kernel::dot(a, eye_) > 0 && kernel::dot(b, eye_) > 0)
      canvas_.draw_stroke(pixel(a), pixel(b), width * width_, colour);
  }
  void disk(const kernel::Vec3& a, double radius, io::Rgb colour) {
    if (kernel::dot(a, eye_) > 0) canvas_.fill_disk(pixel(a), radius * width_, colour);
  }
  /// The quad grid of equation 14 corrected, with its irregular points.
  void grid() {
    const modes::IrregularPoints p = modes::irregular_points(f_);
    constexpr int n = 24, fine = 8;
    for (int family = 0; family < 2; ++family)
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n * fine; ++j) {
          const auto at = [&](int step) {
            const double fixed = i / double(n), running = step / double(n * fine);
            const double t = family == 0 ? fixed : running, e = family == 0 ? running : fixed;
            return modes::quad_grid(p, 2 * std::numbers::pi * t, std::numbers::pi * e);
          };
          line(at(j), at(j + 1), 0.002, {40, 40, 40});
        }
    for (const double a : {-p.a, p.a})
      for (const double c : {-p.c, p.c}) disk({a, 0, c}, 0.014, {250, 200, 40});
  }
  void write(const std::filesystem::path& path) const {
    io::write_canvas(path.string(), canvas_, width_, width_);
  }

 private:
  kernel::Vec3 pixel(const kernel::Vec3& a) const {
    const double r = 0.46 * width_, middle = width_ / 2.0;
    return {middle + r * kernel::dot(a, right_), middle - r * kernel::dot(a, up_), 0};
  }

  const modes::LinearTensors& f_;
  int width_;
  io::Canvas canvas_;
  kernel::Vec3 eye_, right_, up_;
};

}  // namespace crest::experiments
