// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Figures of chapters 8 and 9: square panels in a row, surfaces that rays hit, coloured by errors.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>

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
