// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Errors of cubic splines as section 9.5 measures them.
#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>

#include "algorithms/splines/cubic_evaluate.hpp"
#include "algorithms/splines/cubic_model.hpp"
#include "algorithms/splines/partition.hpp"
#include "experiments/001-splines/test_functions.hpp"
#include "kernel/polynomial/simplex_net.hpp"

namespace crest::experiments {

/// Of the whole box and of the cubes that are not at its border.
struct CubicErrors {
  double mean = 0, data = 0, max = 0;  ///< at the samples twice, at 20 points a tetrahedron
  double interior_mean = 0, interior_data = 0, interior_max = 0;

  CubicErrors& add(const CubicErrors& e, double weight) {
    mean += weight * e.mean;
    data += weight * e.data;
    max += weight * e.max;
    interior_mean += weight * e.interior_mean;
    interior_data += weight * e.interior_data;
    interior_max += weight * e.interior_max;
    return *this;
  }
};

inline bool in_interior(const splines::Domain& domain, const Vec3& p) {
  const Vec3 x = domain.cube_coordinates(p);
  bool interior = true;
  for (std::size_t d = 0; d < 3; ++d)
    interior = interior && x[d] >= 1 && x[d] <= domain.cubes[d] - 1.0;
  return interior;
}

/// At the points with barycentric coordinates (i + 1/4) / 4 of each tetrahedron, the sum of i 3.
inline void errors_in_tetrahedra(const splines::CubicModel& model, Function f, CubicErrors& e) {
  using Basis = kernel::SimplexBasis<3, 3>;
  using Pair = std::array<double, 2>;
  const splines::Domain& domain = model.domain;
  const auto [nx, ny, nz] = domain.cubes;
  const Vec3 density = domain.density();
  const Pair largest = tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, domain.cube_count(), 64), Pair{},
      [&, nx = nx, ny = ny](const auto& range, Pair worst) {
        for (std::size_t c = range.begin(); c != range.end(); ++c) {
          const std::array<std::size_t, 3> at{c % nx, c / nx % ny, c / nx / ny};
          for (const splines::Tetrahedron& t : splines::kTetrahedron)
            for (const auto& index : Basis::indices) {
              Vec3 p;
              for (std::size_t d = 0; d < 3; ++d) {
                double lattice = 0;
                for (std::size_t k = 0; k < 4; ++k)
                  lattice += (index[k] + 0.25) / 4 * t.corners[k][d];
                p[d] =
                    domain.low[d] + (static_cast<double>(at[d]) + (1 + lattice) / 2) / density[d];
              }
              const double error = std::fabs(splines::evaluate(model, p).value - f(p));
              worst[0] = std::max(worst[0], error);
              if (in_interior(domain, p)) worst[1] = std::max(worst[1], error);
            }
        }
        return worst;
      },
      [](const Pair& a, const Pair& b) {
        return Pair{std::max(a[0], b[0]), std::max(a[1], b[1])};
      });
  e.max = largest[0];
  e.interior_max = largest[1];
}

inline CubicErrors cubic_errors(const splines::CubicModel& model, const Samples& s, Function f) {
  CubicErrors e;
  const auto at = splines::evaluate(model, s.points);
  double interior = 0;
  for (std::size_t i = 0; i < s.points.size(); ++i) {
    const double error = std::fabs(at[i].value - s.values[i]);
    e.mean += error / static_cast<double>(s.points.size());
    e.data = std::max(e.data, error);
    if (!in_interior(model.domain, s.points[i])) continue;
    e.interior_mean += error;
    e.interior_data = std::max(e.interior_data, error);
    ++interior;
  }
  e.interior_mean /= std::max(interior, 1.0);
  errors_in_tetrahedra(model, f, e);
  return e;
}

}  // namespace crest::experiments
