// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Stream lines on the page: along ribs or backbones, up to contours, other lines and singularities.
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
  /// The distance to the nearest point of another line, or of this one that is `apart` numbers away;
  /// at most the reach.
  double distance(const Vec2& p, Index line = kNone, Index number = 0, Index apart = 0) const;

 private:
  struct Entry {
    Vec2 p;
    Index line, number;
  };
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
  static constexpr double kStep = 0.2;  ///< mm

  Tracer(const Buffers& buffers, const Barriers& barriers, std::vector<Vec2> singular,
         double spacing);

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
  std::vector<Vec2> singular_;
  double spacing_;
};

}  // namespace crest::line_art
