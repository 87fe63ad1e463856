// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The forms of a surface over a square of its coordinates, by Taylor models on triangles that cover
// it: naive intervals overestimate third derivatives of a polynomial patch by factors of a hundred.
#include <optional>

#include "algorithms/smooth_ridges/blow_up.hpp"
#include "algorithms/smooth_ridges/chart.hpp"
#include "algorithms/smooth_ridges/surface_point.hpp"

namespace crest::smooth_ridges {

/// What the blow-up needs over all of Q.
struct Over {
  Forms<IntervalJet1> forms;
  Shape<IntervalJet2> shape;
};

/// Not for two threads at a time.
class SquareEnclosure {
 public:
  explicit SquareEnclosure(const Surface& surface);

  /// Over centre.z + [-radius, radius]^2; nothing if the graph over it is not proven.
  /// Requires: rounding to nearest.
  std::optional<Over> operator()(const SurfacePoint& centre, double radius);

 private:
  using Model = kernel::TaylorModel<3>;
  using Corners = std::array<SurfacePoint, 3>;

  std::optional<Over> over_triangle(const Corners& corners);

  Charts<Model> charts_;
  std::optional<ImplicitMap<double, 1>> value_;
  std::optional<ImplicitMap<Model, 4>> implicit_;
  std::optional<ParametricMap<Model, 4>> map_;
};

}  // namespace crest::smooth_ridges
