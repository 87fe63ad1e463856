// SPDX-License-Identifier: GPL-3.0-or-later
// Figures 4 to 7 of paper 004 on the sphere of medium eigenvectors: regions by the signs of the two
// points' modes (blue one of each, cyan two positive, magenta two negative, grey none), the complex
// domain through the bifurcation at mu*, its boundary for several modes, the quad grid.
#include <fmt/format.h>

#include <optional>

#include "experiments/004-modes/sphere_picture.hpp"
#include "experiments/program.hpp"

namespace crest::experiments {
namespace {

using io::Canvas;
using io::Rgb;
using kernel::Vec3;
using modes::LinearTensors;

constexpr Rgb kGrey{200, 200, 200}, kBlue{120, 150, 235}, kCyan{120, 225, 225},
    kMagenta{235, 130, 220}, kInk{40, 40, 40}, kGreen{30, 140, 60};

const Vec3 kEye{0.45, 0.55, 0.70};

std::size_t region_of(const LinearTensors& f, const Vec3& v, double mu) {
  const auto points = modes::mode_points(f, v, mu);
  if (!points) return 0;
  const int sum = (*points)[0].sign + (*points)[1].sign;
  return sum == 0 ? 1 : sum > 0 ? 2 : 3;
}

/// Paints the regions. Returns how many samples of each are seen.
std::array<std::size_t, 4> regions(SpherePicture& picture, const LinearTensors& f, double mu) {
  std::array<std::size_t, 4> seen{};
  picture.paint([&](const Vec3& v) {
    const std::size_t region = region_of(f, v, mu);
    ++seen[region];
    return std::array{kGrey, kBlue, kCyan, kMagenta}[region];
  });
  return seen;
}

void draw_boundary(SpherePicture& picture, const LinearTensors& f, double mu) {
  for (unsigned signs = 0; signs < 8; ++signs) {
    std::optional<Vec3> last;
    for (int i = -4000; i <= 4000; ++i) {
      auto p = modes::boundary_point(f, i / 4000.0, mu);
      if (p)
        for (std::size_t k = 0; k < 3; ++k)
          if (signs >> k & 1U) (*p)[k] = -(*p)[k];
      if (p && last) picture.line(*last, *p, 0.006, kGreen);
      last = p;
    }
  }
}

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
  const LinearTensors f(field_3_at({Vec3{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
  const double node = std::sqrt(1 - f.characteristic_mode() * f.characteristic_mode());
  fmt::print(
      "mu* = {:.6f}\n\n| picture | mode | grey | blue | cyan | magenta "
      "|\n|---|---|---|---|---|---|\n",
      node);
  const auto sphere = [&](const char* name, double mu, bool grid) {
    SpherePicture picture(f, width, kEye);
    const auto seen = regions(picture, f, mu);
    double all = 0;
    for (const std::size_t n : seen) all += static_cast<double>(n);
    draw_boundary(picture, f, mu);
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
