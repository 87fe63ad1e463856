// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Figures of chapters 8 and 9: square panels in a row, surfaces that rays hit, coloured by errors.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>

#include "algorithms/splines/cubic_evaluate.hpp"
#include "algorithms/splines/pinhole.hpp"
#include "algorithms/splines/value_and_gradient.hpp"
#include "io/picture/lettering.hpp"
#include "io/picture/picture_file.hpp"
#include "io/splines/ray_picture.hpp"

namespace crest::experiments {

using kernel::Vec3;
using splines::Hit;
using splines::Pinhole;

/// From blue (0) over green to red (1 and beyond), as factors of a grey shade.
inline Vec3 error_colour(double share) {
  const double s = 4 * std::clamp(share, 0.0, 1.0);
  const auto ramp = [](double x) { return 0.15 + 0.85 * std::clamp(x, 0.0, 1.0); };
  return {ramp(s - 2), ramp(std::min(s, 4 - s)), ramp(2 - s)};
}

/// Of hits, each by its error over the one that is red.
inline std::vector<Vec3> error_tints(std::span<const Hit> hits, double red,
                                     const std::function<double(const Hit&)>& error) {
  std::vector<Vec3> tints(hits.size());
  for (std::size_t i = 0; i < hits.size(); ++i)
    if (hits[i].hit) tints[i] = error_colour(error(hits[i]) / red);
  return tints;
}

/// A row of panels of one size, each with a line of words below.
class Panels {
 public:
  Panels(int count, int size) : size_(size), width_(count * size), canvas_(width_, size + kWords) {}

  void add(const Pinhole& camera, std::span<const Hit> hits, std::span<const Vec3> tints,
           const std::string& words) {
    io::draw_rays(canvas_, next_ * size_, 0, camera, hits, tints);
    note(words);
  }
  /// A pixel of the next panel; then note().
  void pixel(int x, int y, io::Rgb colour) {
    const double left = next_ * size_ + x;
    canvas_.fill_box(left, y, left + 1, y + 1, colour);
  }
  /// A dot in the next panel.
  void dot(double x, double y, double radius, io::Rgb colour) {
    if (x > 0 && y > 0 && x < size_ && y < size_)
      canvas_.fill_disk({next_ * size_ + x, y, 0}, radius, colour);
  }
  void note(const std::string& words) {
    io::draw_text(canvas_, next_ * size_ + 6, size_ + kWords - 6, 12, words);
    ++next_;
  }
  int size() const { return size_; }
  void write(const std::filesystem::path& path) const {
    io::write_canvas(path.string(), canvas_, width_, size_ + kWords);
  }

 private:
  static constexpr int kWords = 18;
  int size_, width_, next_ = 0;
  io::Canvas canvas_;
};

/// What the camera sees of {spline = level}.
inline std::vector<Hit> hits_of(const splines::QuadraticSpline& spline, double level,
                                const Pinhole& camera) {
  const auto rays = camera.rays();
  std::vector<Hit> hits(rays.size());
  splines::RayCaster(spline, level).cast(rays, hits);
  return hits;
}

/// The values of a cubic spline at so many nodes along each axis of its box, to be drawn.
inline splines::QuadraticSpline on_grid(const splines::CubicModel& model,
                                        const std::array<std::size_t, 3>& size) {
  const Vec3 &low = model.domain.low, &high = model.domain.high;
  kernel::SampledGrid grid;
  grid.size = size;
  grid.origin = low;
  for (std::size_t k = 0; k < 3; ++k)
    grid.spacing[k] = (high[k] - low[k]) / static_cast<double>(size[k] - 1);
  std::vector<Vec3> points;
  for (std::size_t z = 0; z < size[2]; ++z)
    for (std::size_t y = 0; y < size[1]; ++y)
      for (std::size_t x = 0; x < size[0]; ++x) {
        Vec3 p = {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
        for (std::size_t k = 0; k < 3; ++k)
          p[k] = std::min(low[k] + p[k] * grid.spacing[k], high[k]);
        points.push_back(p);
      }
  std::vector<double> values;
  for (const auto& at : splines::evaluate(model, points)) values.push_back(at.value);
  grid.samples = std::move(values);
  return splines::QuadraticSpline(std::move(grid));
}

/// Value and gradient in the world; the value is NaN outside.
using Field = std::function<splines::ValueAndGradient(const Vec3&)>;

/// Hits of any continuous field by steps along the rays from `near` to `far`, bisected: for
/// pictures of models that have no exact rays; what is thinner than a step may be missed.
inline std::vector<Hit> hits_by_steps(const Pinhole& camera, const Field& field, double level,
                                      double near, double far, double step) {
  using kernel::operator*;
  using kernel::operator+;
  const auto rays = camera.rays();
  std::vector<Hit> hits(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const auto at = [&](double t) { return rays[i].origin + t * rays[i].direction; };
    double before = NAN;
    for (double t = near; t <= far; t += step) {
      const double now = field(at(t)).value - level;
      if (before * now <= 0) {
        double low = t - step, high = t;
        for (int k = 0; k < 40; ++k) {
          const double middle = 0.5 * (low + high);
          ((field(at(middle)).value - level) * before > 0 ? low : high) = middle;
        }
        hits[i].hit = true;
        hits[i].t = high;
        hits[i].place = at(high);
        hits[i].gradient = field(at(high)).gradient;
        break;
      }
      before = now;
    }
  }
  return hits;
}

}  // namespace crest::experiments
