// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Strokes as they are written, painted: a second measure of tone, which knows nothing of how widths
// are made.
#include <algorithm>
#include <cmath>
#include <vector>

#include "algorithms/line_art/line_art.hpp"

namespace crest::experiments {

/// A picture in black and white of samples a quarter of a buffer's pixel apart.
class Painting {
 public:
  explicit Painting(const line_art::Buffers& b)
      : b_(b), width_(kFine * b.width), samples_(size_of(width_, kFine * b.height), 0) {}

  /// The inside of a closed line, by winding numbers.
  void fill(const std::vector<line_art::Vec2>& polygon) {
    if (polygon.empty()) return;
    const double step = b_.pixel / kFine;
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const auto& p : polygon) {
      low = std::min(low, p[1]);
      high = std::max(high, p[1]);
    }
    const int last = std::min(kFine * b_.height - 1, static_cast<int>(high / step));
    for (int j = std::max(0, static_cast<int>(low / step)); j <= last; ++j) {
      crossings_.clear();
      for (std::size_t i = 0; i < polygon.size(); ++i)
        add_crossing(polygon[i], polygon[(i + 1) % polygon.size()], (j + 0.5) * step);
      std::sort(crossings_.begin(), crossings_.end());
      int winding = 0;
      for (std::size_t k = 0; k + 1 < crossings_.size(); ++k) {
        winding += crossings_[k].second;
        if (winding != 0) fill_row(j, crossings_[k].first / step, crossings_[k + 1].first / step);
      }
    }
  }

  /// Of every pixel of the buffers, 0 to 1.
  std::vector<float> shares() const {
    std::vector<float> share(b_.size(), 0);
    for (std::size_t k = 0; k < samples_.size(); ++k) {
      const std::size_t row = k / static_cast<std::size_t>(width_),
                        column = k % static_cast<std::size_t>(width_);
      share[row / kFine * static_cast<std::size_t>(b_.width) + column / kFine] +=
          static_cast<float>(samples_[k]) / (kFine * kFine);
    }
    return share;
  }

 private:
  static constexpr int kFine = 4;

  static std::size_t size_of(int width, int height) {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  void add_crossing(const line_art::Vec2& a, const line_art::Vec2& b, double y) {
    if ((a[1] <= y) == (b[1] <= y)) return;
    crossings_.emplace_back(a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]), a[1] <= y ? 1 : -1);
  }
  /// Samples whose centres are between two places.
  void fill_row(int row, double from, double to) {
    const int first = std::max(0, static_cast<int>(std::ceil(from - 0.5)));
    const int end = std::min(width_, static_cast<int>(std::ceil(to - 0.5)));
    for (int i = first; i < end; ++i)
      samples_[size_of(width_, row) + static_cast<std::size_t>(i)] = 1;
  }

  const line_art::Buffers& b_;
  int width_;
  std::vector<std::uint8_t> samples_;
  std::vector<std::pair<double, int>> crossings_;  // place, sense
};

}  // namespace crest::experiments
