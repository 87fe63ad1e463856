// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Polygons and paths in a plane: whether they are simple and disjoint, and which hold which.
#include <functional>
#include <vector>

#include "certify/exact/tensor_field.hpp"
#include "kernel/arithmetic/rational.hpp"

namespace crest::certify::modes {

template <class Number>
using Planar = std::array<Number, 2>;
using Segment = std::array<u32, 2>;

/// Points as doubles, each coordinate wrong by at most `error`, and exactly when it is asked for.
class PlanarPoints {
 public:
  using Exact = std::vector<Planar<kernel::Rational>>;
  PlanarPoints(std::vector<Planar<double>> near, double error, std::function<Exact()> exact)
      : near_(std::move(near)), error_(error), make_exact_(std::move(exact)) {}

  const Planar<double>& near(u32 i) const { return near_[i]; }
  double error() const { return error_; }
  /// Sign of (b - a) x (c - a).
  int orientation(u32 a, u32 b, u32 c) const;
  /// Sign of (b - a) . (c - a), for points on one line.
  int side(u32 a, u32 b, u32 c) const;
  bool same(u32 a, u32 b) const;
  /// Whether point a is above point b.
  bool above(u32 a, u32 b) const;

 private:
  const Exact& exact() const;

  std::vector<Planar<double>> near_;
  double error_;
  std::function<Exact()> make_exact_;
  mutable Exact exact_;
};

/// Whether segments meet in common ends only, and there not along a line.
/// Cost: n log n and a step a pair whose boxes meet.
bool are_simple(const PlanarPoints& points, const std::vector<Segment>& segments);

/// Requires: a simple polygon, and a point that is not on it.
bool holds(const PlanarPoints& points, const std::vector<u32>& polygon, u32 point);

}  // namespace crest::certify::modes
