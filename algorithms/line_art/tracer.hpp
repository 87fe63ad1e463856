// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Stream lines on the page: along ribs or backbones, up to contours, other lines and singularities.
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "algorithms/line_art/buffers.hpp"

namespace crest::line_art {

enum class Family : std::uint8_t { rib, backbone };

/// Points of lines, found by their place: how near is the next line. Lines on the other side of a
/// contour are not near.
class LinePoints {
 public:
  LinePoints(const Vec2& page, double reach, const Barriers& barriers);
  void add(const Vec2& p, Index line, Index number);
  /// The distance to the nearest point for which counts(line, number) is true; at most `most`,
  /// which is at most the reach.
  template <class Counts>
  double distance(const Vec2& p, double most, Counts&& counts) const {
    const auto [c, r] = cell(p);
    double best = most * most;
    for (int j = std::max(0, r - 1); j <= std::min(rows_ - 1, r + 1); ++j)
      for (int i = std::max(0, c - 1); i <= std::min(columns_ - 1, c + 1); ++i)
        for (const Entry& e :
             cells_[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) +
                    static_cast<std::size_t>(i)]) {
          const double x = e.p[0] - p[0], y = e.p[1] - p[1], d = x * x + y * y;
          if (d < best && counts(e.line, e.number) && !barriers_.crosses(p, e.p)) best = d;
        }
    return std::sqrt(best);
  }
  double distance(const Vec2& p, double most) const {
    return distance(p, most, [](Index, Index) { return true; });
  }

 private:
  struct Entry {
    Vec2 p;
    Index line, number;
  };
  std::pair<int, int> cell(const Vec2& p) const {
    return {std::clamp(static_cast<int>(p[0] / reach_), 0, columns_ - 1),
            std::clamp(static_cast<int>(p[1] / reach_), 0, rows_ - 1)};
  }

  const Barriers& barriers_;
  double reach_;
  int columns_, rows_;
  std::vector<std::vector<Entry>> cells_;
};

/// One half of a stream line.
struct Trace {
  enum class End : std::uint8_t { open, contour, line, singularity, turned };
  std::vector<Vec2> points;  ///< the start first
  End end = End::open;
};

class Tracer {
 public:
  static constexpr double kStep = 0.2;        ///< mm
  static constexpr double kClearance = 0.03;  ///< mm between a hatch and a contour's middle

  /// `crosses`: directions are those of a cross field, a line goes on in the nearest of the four.
  Tracer(const Buffers& buffers, const Barriers& barriers, std::vector<Vec2> singular,
         double spacing, bool crosses);

  /// One that goes past singularities.
  Tracer heedless() const { return {buffers_, barriers_, {}, spacing_, crosses_}; }

  const Buffers& buffers() const { return buffers_; }
  const Barriers& barriers() const { return barriers_; }
  double spacing() const { return spacing_; }

  /// The direction at p nearest to `ahead` (any sense if that is zero).
  std::optional<Vec2> direction(const Vec2& p, Family family, const Vec2& ahead) const;
  bool near_singularity(const Vec2& p) const;

  /// `stop` is asked for every new point with its number; true: it is not part of the line.
  using Stop = std::function<bool(const Vec2&, Index)>;
  Trace trace(const Vec2& start, const Vec2& ahead, Family family, double most_turn,
              const Stop& stop) const;

 private:
  const Buffers& buffers_;
  const Barriers& barriers_;
  Vec2 pick(std::size_t pixel, Family family, const Vec2& ahead) const;

  std::vector<Vec2> singular_;  ///< from left to right
  double spacing_;
  bool crosses_;
};

}  // namespace crest::line_art
