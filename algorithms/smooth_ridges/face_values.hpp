// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What a face's test evaluates over models, of one face or of several side by side.
#include "algorithms/smooth_ridges/chart.hpp"
#include "algorithms/smooth_ridges/directions.hpp"
#include "algorithms/smooth_ridges/forms.hpp"
#include "algorithms/smooth_ridges/frame.hpp"
#include "kernel/arithmetic/taylor_lanes.hpp"

namespace crest::smooth_ridges {

using FaceModel = kernel::TaylorModel<4>;
using Corners = std::array<Vertex, 3>;

/// E1 and E2 on the face with K derivatives, and the principal vectors.
template <int K, class Model = FaceModel>
struct Extremalities {
  using Field = kernel::Jet<Model, 2, K>;
  std::array<Field, 2> e;
  std::array<Pair<Field>, 2> v;
};

/// The direction number of the eigenvector of (a b; c -a) for the eigenvalue sigma > 0.
inline std::uint8_t along_first(double a, double b, double c, double sigma) {
  return a > 0 ? nearest_direction(a + sigma, c) : nearest_direction(b, sigma - a);
}

inline Vec3 mean_normal(const Corners& c) {
  const Vec3 sum = normal(c[0]) + normal(c[1]) + normal(c[2]);
  const double size = norm(sum);
  return {sum[0] / size, sum[1] / size, sum[2] / size};
}

}  // namespace crest::smooth_ridges
