// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/splines/cubic_extension.hpp"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>

#include "algorithms/splines/local_fit.hpp"
#include "algorithms/splines/normal_form.hpp"
#include "kernel/geometry/parallel.hpp"

namespace crest::splines {

CubicModel make_model(const Domain& domain) {
  CubicModel model;
  model.domain = domain;
  model.vertices.resize(domain.vertex_count());
  model.slopes.resize(domain.vertex_count());
  model.centres.resize(domain.cube_count());
  return model;
}

std::vector<LocalCubic> fit_at(const std::vector<Vec3>& places, const Scattered& samples,
                               const Scattered::Request& request, const std::array<bool, 3>& flat) {
  std::vector<LocalCubic> fits(places.size());
  tbb::enumerable_thread_specific<LocalFit> workers(
      [&] { return LocalFit(samples, request, flat); });
  kernel::parallel_for(tbb::blocked_range<std::size_t>(0, places.size(), 16),
                       [&](const auto& range) {
                         LocalFit& fit = workers.local();
                         for (std::size_t i = range.begin(); i != range.end(); ++i)
                           fits[i] = fit(places[i]);
                       });
  return fits;
}

std::array<double, 8> fourfold_targets(const CubicModel& model, const Place& cube) {
  CubeNumbers<double> q;
  for (std::size_t c = 0; c < 8; ++c) {
    const ValueAndSlope& v = model.vertices[model.domain.vertex(corner_of(cube, c))];
    q.f[c] = v[0];
    q.h[c] = {v[1] / 2, v[2] / 2, v[3] / 2};
  }
  for (std::size_t e = 0; e < 12; ++e) {
    const EdgeSlopes& t = model.slopes[model.domain.vertex(corner_of(cube, lower_corner(e)))];
    q.t[e] = {t[e / 4 * 2], t[e / 4 * 2 + 1]};
  }
  return fourfold_targets(q);
}

void fit_centres(CubicModel& model, bool black) {
  for_each_place(model.domain.cubes, [&](const Place& cube) {
    if (!black && is_black(cube)) return;
    const auto numbers = centre_of_targets(fourfold_targets(model, cube));
    model.centres[model.domain.cube(cube)] = {numbers[0] / 32, numbers[1] / 16, numbers[2] / 16,
                                              numbers[3] / 16};
  });
}

}  // namespace crest::splines
