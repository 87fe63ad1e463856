// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/splines/cubic_evaluate.hpp"

#include <tbb/blocked_range.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "algorithms/splines/cubic_net.hpp"
#include "kernel/geometry/parallel.hpp"

namespace crest::splines {
namespace {

CubicNet<double> net_of(const CubicModel& model, const std::array<std::size_t, 3>& cube,
                        std::size_t t) {
  const Domain& domain = model.domain;
  const auto at = [&](const std::array<std::size_t, 3>& corner) {
    return domain.vertex(cube[0] + corner[0], cube[1] + corner[1], cube[2] + corner[2]);
  };
  return cubic_net<double>(
      t, [&](const auto& c) -> const ValueAndSlope& { return model.vertices[at(c)]; },
      [&](const auto& c) -> const EdgeSlopes& { return model.slopes[at(c)]; },
      model.centres[domain.cube(cube[0], cube[1], cube[2])]);
}

}  // namespace

ValueAndGradient evaluate(const CubicModel& model, const Vec3& point) {
  const Domain& domain = model.domain;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if (!domain.contains(point)) return {nan, {nan, nan, nan}};
  const Vec3 x = domain.cube_coordinates(point);
  std::array<std::size_t, 3> cube;
  std::array<double, 3> p;  // in the lattice
  for (std::size_t d = 0; d < 3; ++d) {
    cube[d] = std::min(static_cast<std::size_t>(x[d]), std::size_t{domain.cubes[d]} - 1);
    p[d] = 2 * (x[d] - static_cast<double>(cube[d])) - 1;
  }
  const std::size_t t = locate(p[0], p[1], p[2]);
  const CubicNet<double> net = net_of(model, cube, t);
  const auto r = kernel::value_and_gradient_at(net, barycentric(t, p));
  const auto g = gradient(t, r.gradient);
  const Vec3 density = domain.density();
  return {r.value, {2 * g[0] * density[0], 2 * g[1] * density[1], 2 * g[2] * density[2]}};
}

std::vector<ValueAndGradient> evaluate(const CubicModel& model, std::span<const Vec3> points) {
  std::vector<ValueAndGradient> all(points.size());
  kernel::parallel_for(tbb::blocked_range<std::size_t>(0, points.size(), 1024),
                       [&](const auto& range) {
                         for (std::size_t i = range.begin(); i != range.end(); ++i)
                           all[i] = evaluate(model, points[i]);
                       });
  return all;
}

std::pair<double, double> coefficient_range(const CubicModel& model) {
  using Range = std::pair<double, double>;
  const auto join = [](const Range& a, const Range& b) {
    return Range{std::min(a.first, b.first), std::max(a.second, b.second)};
  };
  const auto [nx, ny, nz] = model.domain.cubes;
  return kernel::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, nz), Range{HUGE_VAL, -HUGE_VAL},
      [&, nx = nx, ny = ny](const auto& slabs, Range range) {
        for (std::size_t k = slabs.begin(); k != slabs.end(); ++k)
          for (std::size_t j = 0; j < ny; ++j)
            for (std::size_t i = 0; i < nx; ++i)
              for (std::size_t t = 0; t < kTetrahedra; ++t)
                for (const double a : net_of(model, {i, j, k}, t).c) range = join(range, {a, a});
        return range;
      },
      join);
}

}  // namespace crest::splines
