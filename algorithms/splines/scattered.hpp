// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Scattered samples, sorted into the cubes of a domain.
#include <cstdint>
#include <span>
#include <vector>

#include "algorithms/splines/cubic_model.hpp"

namespace crest::splines {

struct Sample {
  Vec3 x{};  ///< cube coordinates
  double value = 0;
  friend auto operator<=>(const Sample&, const Sample&) = default;
};

class Scattered {
 public:
  /// Of the points in the closed box. Guarantees: the same for any order of the points.
  Scattered(const Domain& domain, std::span<const Vec3> points, std::span<const double> values);

  std::size_t size() const { return samples_.size(); }
  /// Cubes that hold no sample.
  std::size_t empty_cubes() const;
  const Sample& operator[](std::size_t i) const { return samples_[i]; }

  /// A sample near a place.
  struct Near {
    double square;  ///< of the distance
    std::uint32_t sample;
    friend auto operator<=>(const Near&, const Near&) = default;
  };
  /// The samples within `radius`, which is multiplied by `growth` until there are `least` of them
  /// (or all there are); of more than `most` the nearest, in both cases by number among equally
  /// far ones. In the order of their numbers. Requires: least <= most.
  struct Request {
    double radius = 1.1, growth = 1.15;
    std::size_t least = 40, most = 100;
  };
  void gather(const Vec3& centre, const Request& request, std::vector<Near>& found) const;

 private:
  struct Range {
    std::array<std::size_t, 3> from, to;
  };
  Range cubes_within(const Vec3& centre, double radius) const;
  std::size_t count(const Range& range) const;

  Domain domain_;
  std::vector<Sample> samples_;
  std::vector<std::uint32_t> first_;  ///< of each cube, and one behind the last
  std::vector<std::uint32_t> below_;  ///< samples in all cubes below each vertex
};

}  // namespace crest::splines
