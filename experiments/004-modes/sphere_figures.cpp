// SPDX-License-Identifier: GPL-3.0-or-later
// Figures 4 to 7 of paper 004 on the sphere of medium eigenvectors: regions by the signs of the two
// points' modes (blue one of each, cyan two positive, magenta two negative, grey none), the complex
// domain through the bifurcation at mu*, its boundary for several modes, the quad grid.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "algorithms/modes/sphere.hpp"
#include "experiments/program.hpp"
#include "io/picture/picture_file.hpp"

namespace crest::experiments {
namespace {

using io::Canvas;
using io::Rgb;
using kernel::Vec3;
using kernel::operator+;
using kernel::operator*;
using modes::LinearTensors;
using modes::Tensor;

constexpr Rgb kGrey{200, 200, 200}, kBlue{120, 150, 235}, kCyan{120, 225, 225},
    kMagenta{235, 130, 220}, kInk{40, 40, 40}, kGreen{30, 140, 60}, kYellow{250, 200, 40};

/// Field 3 of the specification's table (mu* = 0.916): rows xx yy zz xy yz xz.
LinearTensors field() {
  const std::array<std::array<double, 5>, 4> f{
      {{-3, 3, 2, -4, -1}, {3, 1, 4, 3, -5}, {3, -6, 1, -2, 2}, {-3, -3, 5, 1, 2}}};
  std::array<Tensor, 4> corners;
  for (std::size_t i = 0; i < 4; ++i) {
    std::array<double, 5> t = f[0];
    for (std::size_t k = 0; k < 5 && i > 0; ++k) t[k] += f[i][k];
    corners[i] = {t[0], t[1], -t[0] - t[1], t[2], t[4], t[3]};
  }
  return LinearTensors(corners);
}

/// The sphere as seen along a direction of Tbar's frame.
class SpherePicture {
 public:
  SpherePicture(const LinearTensors& f, int width) : f_(f), width_(width), canvas_(width, width) {
    const Vec3 eye{0.45, 0.55, 0.70};
    eye_ = (1 / kernel::norm(eye)) * eye;
    const Vec3 right = kernel::cross(Vec3{0, 1, 0}, eye_);
    right_ = (1 / kernel::norm(right)) * right;
    up_ = kernel::cross(eye_, right_);
    canvas_.fill_box(0, 0, width, width, {255, 255, 255});
  }

  Vec3 world(const Vec3& in_frame) const {
    return in_frame[0] * f_.frame()[0] + in_frame[1] * f_.frame()[1] + in_frame[2] * f_.frame()[2];
  }
  std::array<std::size_t, 4> regions(double mu) {
    std::array<std::size_t, 4> seen{};
    const double r = 0.46 * width_, middle = width_ / 2.0;
    for (int j = 0; j < 2 * width_; ++j)
      for (int i = 0; i < 2 * width_; ++i) {
        const double px = (i + 0.5) / 2, py = (j + 0.5) / 2, x = (px - middle) / r,
                     y = (middle - py) / r;
        if (x * x + y * y > 1) continue;
        const double z = std::sqrt(1 - x * x - y * y);
        const Vec3 v = x * right_ + y * up_ + z * eye_;
        const std::size_t region = region_of(world(v), mu);
        ++seen[region];
        const Rgb colour = std::array{kGrey, kBlue, kCyan, kMagenta}[region];
        const double shade = 0.55 + 0.45 * z;
        const auto tone = [&](std::uint8_t c) { return static_cast<std::uint8_t>(c * shade); };
        canvas_.fill_box(px - 0.25, py - 0.25, px + 0.25, py + 0.25,
                         {tone(colour.red), tone(colour.green), tone(colour.blue)});
      }
    return seen;
  }
  void line(const Vec3& a, const Vec3& b, double width, Rgb colour) {
    if (kernel::dot(a, eye_) > 0 && kernel::dot(b, eye_) > 0)
      canvas_.draw_stroke(pixel(a), pixel(b), width, colour);
  }
  void disk(const Vec3& a, Rgb colour) {
    if (kernel::dot(a, eye_) > 0) canvas_.fill_disk(pixel(a), 0.014 * width_, colour);
  }
  void boundary(double mu) {
    for (int signs = 0; signs < 8; ++signs) {
      std::optional<Vec3> last;
      for (int i = -4000; i <= 4000; ++i) {
        auto p = modes::boundary_point(f_, i / 4000.0, mu);
        if (p)
          for (std::size_t k = 0; k < 3; ++k)
            if (signs >> k & 1) (*p)[k] = -(*p)[k];
        if (p && last) line(*last, *p, 0.006 * width_, kGreen);
        last = p;
      }
    }
  }
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
          line(at(j), at(j + 1), 0.002 * width_, kInk);
        }
    for (const double a : {-p.a, p.a})
      for (const double c : {-p.c, p.c}) disk({a, 0, c}, kYellow);
  }
  void write(const std::filesystem::path& path) const {
    io::write_canvas(path.string(), canvas_, width_, width_);
  }

 private:
  Vec3 pixel(const Vec3& a) const {
    const double r = 0.46 * width_, middle = width_ / 2.0;
    return {middle + r * kernel::dot(a, right_), middle - r * kernel::dot(a, up_), 0};
  }
  std::size_t region_of(const Vec3& v, double mu) const {
    const auto points = modes::mode_points(f_, v, mu);
    if (!points) return 0;
    const int sum = (*points)[0].sign + (*points)[1].sign;
    return sum == 0 ? 1 : sum > 0 ? 2 : 3;
  }

  const LinearTensors& f_;
  int width_;
  Canvas canvas_;
  Vec3 eye_, right_, up_;
};

/// Figure 6: the boundary seen along the axis inside it, for modes below, at and above mu*.
void figure_6(const LinearTensors& f, double node, int width, const std::filesystem::path& path) {
  Canvas canvas(width, width);
  canvas.fill_box(0, 0, width, width, {255, 255, 255});
  const auto pixel = [&](double x, double y) {
    return Vec3{width * (0.5 + 0.46 * x), width * (0.5 - 0.46 * y), 0};
  };
  canvas.draw_stroke(pixel(-1, 0), pixel(1, 0), 1, kGrey);
  canvas.draw_stroke(pixel(0, -1), pixel(0, 1), 1, kGrey);
  // Tbar's medium axis is where the boundary touches itself.
  for (const double mu : {0.3, 0.6, 0.8, node, 0.95, 0.99, 1.0})
    for (const double sx : {-1.0, 1.0})
      for (const double sy : {-1.0, 1.0}) {
        std::optional<Vec3> last;
        for (int i = -8000; i <= 8000; ++i) {
          const auto p = modes::boundary_point(f, i / 8000.0, mu);
          if (p && last)
            canvas.draw_stroke(pixel(sx * (*last)[0], sy * (*last)[1]),
                               pixel(sx * (*p)[0], sy * (*p)[1]), mu == node ? 2 : 1,
                               mu == node ? kMagenta : kInk);
          last = p;
        }
      }
  io::write_canvas(path.string(), canvas, width, width);
}

void run(const std::filesystem::path& folder, int width) {
  const LinearTensors f = field();
  const double node = std::sqrt(1 - f.characteristic_mode() * f.characteristic_mode());
  fmt::print(
      "mu* = {:.6f}\n\n| picture | mode | grey | blue | cyan | magenta "
      "|\n|---|---|---|---|---|---|\n",
      node);
  const auto sphere = [&](const char* name, double mu, bool grid) {
    SpherePicture picture(f, width);
    const auto seen = picture.regions(mu);
    double all = 0;
    for (const std::size_t n : seen) all += static_cast<double>(n);
    picture.boundary(mu);
    if (grid) picture.grid();
    picture.write(folder / name);
    fmt::print("| {} | {:.6f} |", name, mu);
    for (const std::size_t n : seen) fmt::print(" {:.1f} % |", 100 * static_cast<double>(n) / all);
    fmt::print("\n");
  };
  sphere("figure-4.png", 0.8, false);
  sphere("figure-5-a.png", 0.97, false);
  sphere("figure-5-b.png", node, false);
  sphere("figure-5-c.png", 0.7, false);
  sphere("figure-7-grid.png", 0.8, true);
  figure_6(f, node, width, folder / "figure-6.png");
}

}  // namespace
}  // namespace crest::experiments

int main(int argc, char** argv) {
  std::filesystem::path folder = ".";
  int width = 320;
  crest::experiments::Program program(
      "The sphere of medium eigenvectors, figures 4 to 7 of paper 004.");
  program.option("--pictures", folder, "folder of the pictures");
  program.option("--width", width, "pixels", {64, 2000});
  return program.run(argc, argv, [&] {
    crest::experiments::run(folder, width);
    return 0;
  });
}
