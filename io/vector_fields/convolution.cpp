// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/vector_fields/convolution.hpp"

#include <algorithm>
#include <cmath>

namespace crest::io {
namespace {

using kernel::Vec2;

constexpr int kReach = 14;  ///< steps of a pixel to either side

/// Unit velocities in pixels; zero outside and where there is no flow.
class Raster {
 public:
  Raster(const vector_fields::PlanarField& field, const Camera& camera)
      : width_(camera.width), height_(camera.height) {
    flow_.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), {0, 0});
    inside_.resize(flow_.size(), 0);
    for (const auto& t : field.triangles) {
      Vec2 p[3], v[3];
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec2& x = field.points[t[k]];
        const kernel::Vec3 pixel = camera.project({x[0], x[1], 0});
        p[k] = {pixel[0], pixel[1]};
        v[k] = {field.vectors[t[k]][0], -field.vectors[t[k]][1]};
      }
      fill(p, v);
    }
  }
  int width() const { return width_; }
  int height() const { return height_; }
  bool inside(int x, int y) const {
    return x >= 0 && y >= 0 && x < width_ && y < height_ && inside_[at(x, y)] != 0;
  }
  const Vec2& flow(int x, int y) const { return flow_[at(x, y)]; }

 private:
  std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }
  void fill(const Vec2 (&p)[3], const Vec2 (&v)[3]) {
    const auto bounds = [&](std::size_t k, int end) {
      const auto [low, high] = std::minmax({p[0][k], p[1][k], p[2][k]});
      // Close-ups leave triangles far outside.
      return std::pair{static_cast<int>(std::clamp(std::floor(low), 0.0, 1.0 * end)),
                       static_cast<int>(std::clamp(std::ceil(high), -1.0, end - 1.0))};
    };
    const auto [x0, x1] = bounds(0, width_);
    const auto [y0, y1] = bounds(1, height_);
    const double area =
        (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[1][1] - p[0][1]) * (p[2][0] - p[0][0]);
    for (int y = y0; y <= y1; ++y)
      for (int x = x0; x <= x1; ++x) {
        const double u = x + 0.5 - p[0][0], w = y + 0.5 - p[0][1];
        const double a = (u * (p[2][1] - p[0][1]) - w * (p[2][0] - p[0][0])) / area;
        const double b = (w * (p[1][0] - p[0][0]) - u * (p[1][1] - p[0][1])) / area;
        if (!(a >= 0 && b >= 0 && a + b <= 1)) continue;
        Vec2 f;
        for (std::size_t k = 0; k < 2; ++k)
          f[k] = v[0][k] + a * (v[1][k] - v[0][k]) + b * (v[2][k] - v[0][k]);
        const double size = std::hypot(f[0], f[1]);
        flow_[at(x, y)] = size > 0 ? Vec2{f[0] / size, f[1] / size} : Vec2{0, 0};
        inside_[at(x, y)] = size > 0 ? 1 : 0;
      }
  }

  int width_, height_;
  std::vector<Vec2> flow_;
  std::vector<std::uint8_t> inside_;
};

/// White noise by the pixel's place.
double noise(int x, int y) {
  std::uint64_t h = (static_cast<std::uint64_t>(static_cast<std::uint32_t>(y)) << 32) |
                    static_cast<std::uint32_t>(x);
  h = (h ^ (h >> 31)) * 0x9e3779b97f4a7c15u;
  h = (h ^ (h >> 29)) * 0xbf58476d1ce4e5b9u;
  return static_cast<double>((h ^ (h >> 32)) >> 11) * 0x1p-53;
}

/// The mean noise along the stream line through a pixel, by its distance from a half.
double mean_along(const Raster& raster, int x, int y) {
  double sum = noise(x, y);
  int count = 1;
  for (const double sense : {1.0, -1.0}) {
    double u = x + 0.5, w = y + 0.5;
    for (int step = 0; step < kReach; ++step) {
      const Vec2& f = raster.flow(static_cast<int>(u), static_cast<int>(w));
      u += sense * f[0];
      w += sense * f[1];
      const int i = static_cast<int>(std::floor(u)), k = static_cast<int>(std::floor(w));
      if (!raster.inside(i, k)) break;
      sum += noise(i, k);
      ++count;
    }
  }
  return (sum / count - 0.5) * std::sqrt(static_cast<double>(count));
}

}  // namespace

std::vector<std::uint8_t> convolve(const vector_fields::PlanarField& field, const Camera& camera) {
  const Raster raster(field, camera);
  std::vector<std::uint8_t> dark;
  dark.reserve(static_cast<std::size_t>(raster.width()) *
               static_cast<std::size_t>(raster.height()));
  for (int y = 0; y < raster.height(); ++y)
    for (int x = 0; x < raster.width(); ++x) {
      double share = 0;
      if (raster.inside(x, y))
        share = std::clamp(0.34 + 0.42 * mean_along(raster, x, y), 0.06, 0.7);
      dark.push_back(static_cast<std::uint8_t>(std::lround(255 * share)));
    }
  return dark;
}

}  // namespace crest::io
