// SPDX-License-Identifier: GPL-3.0-or-later
#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <cmath>

#include "algorithms/ridges/creases.hpp"
#include "algorithms/ridges/local_frame.hpp"
#include "algorithms/ridges/monge_from_jet.hpp"
#include "algorithms/ridges/neighbourhood.hpp"
#include "algorithms/ridges/ridges.hpp"
#include "algorithms/ridges/smoothing.hpp"
#include "algorithms/ridges/standard_errors.hpp"
#include "kernel/geometry/coordinate_range.hpp"
#include "kernel/geometry/parallel.hpp"

namespace crest::ridges {
namespace {

using kernel::MongeForm;

struct Workspace {
  Workspace(const kernel::TriangleMesh& mesh, const std::vector<std::uint8_t>& creases)
      : collector(mesh, creases) {}
  NeighbourhoodCollector collector;
  std::array<Support, kLanes> around;
  NeighbourhoodLanes local;
};

// From the jet's coordinates to space, and from its unit of length to the input's. Adding zero
// turns -0 into +0: a zero has one representation (certify/ridges_mesh/SPEC.md).
MongeForm to_space(const MongeForm& m, const LocalFrame& f) {
  auto rotate = [&](const Vec3& v) {
    Vec3 r;
    for (std::size_t k = 0; k < 3; ++k) r[k] = v[0] * f.x[k] + v[1] * f.y[k] + v[2] * f.z[k] + 0.0;
    return r;
  };
  MongeForm g = m;
  g.d1 = rotate(m.d1);
  g.n = rotate(m.n);
  const double s = f.scale, s2 = s * s, s3 = s2 * s;
  for (double* k : {&g.k1, &g.k2}) *k = *k / s + 0.0;
  for (double* b : {&g.b0, &g.b1, &g.b2, &g.b3}) *b = *b / s2 + 0.0;
  for (double* c : {&g.c0, &g.c1, &g.c2, &g.c3, &g.c4}) *c = *c / s3 + 0.0;
  return g;
}

bool finite(const MongeForm& m) {
  double sum = 0;
  for (double x : {m.k1, m.k2, m.b0, m.b1, m.b2, m.b3, m.c0, m.c1, m.c2, m.c3, m.c4, m.d1[0],
                   m.d1[1], m.d1[2], m.n[0], m.n[1], m.n[2]})
    sum += 0 * x;
  return sum == 0;
}

/// The batch's curvature errors for residuals of 1, and their residuals.
void estimate_errors(const std::array<Jet, kLanes>& jets,
                     const std::array<LocalFrame, kLanes>& frames, const NeighbourhoodLanes& local,
                     JetFit& fit, std::size_t count, CurvatureError* errors, double* residuals) {
  JetFit::Gradient by_k1{}, by_k2{}, by_gap{};
  for (std::size_t l = 0; l < count; ++l) {
    const CurvatureGradients g = curvature_gradients(jets[l], principal_frame(jets[l]));
    for (std::size_t i = 0; i < 6; ++i) {
      by_k1.by[i][l] = g.k1[i];
      by_k2.by[i][l] = g.k2[i];
      by_gap.by[i][l] = g.k1[i] - g.k2[i];
    }
  }
  const auto k1 = fit.propagate(by_k1), k2 = fit.propagate(by_k2), gap = fit.propagate(by_gap);
  const std::array<Jet, kLanes> wide = fit.fit(local.second(), local.all);
  for (std::size_t l = 0; l < count; ++l) {
    const double scale = frames[l].scale;
    const double unit = 1 / (scale * scale);
    const PrincipalFrame f = principal_frame(wide[l]);
    const bool known = std::isfinite(f.k1) && std::isfinite(f.k2);
    errors[l] = {k1[l] * unit,
                 k2[l] * unit,
                 gap[l] * unit,
                 known ? f.k1 / scale : 0.0,
                 known ? f.k2 / scale : 0.0,
                 std::sqrt(2.0) * scale};
    residuals[l] = jets[l].residual * scale;
  }
}

/// What is fitted, by vertex.
struct Rows {
  MongeForm* forms;
  FitQuality* quality;
  CurvatureError* errors;  ///< null: not wanted
  double* residuals;
};

/// Fits vertices first, first + 1, ... (at most four).
void fit_vertices(const kernel::TriangleMesh& mesh, const std::vector<Vec3>& normals, Index first,
                  std::size_t count, const FitOptions& options, Workspace& work, const Rows& rows) {
  std::array<Vec3, kLanes> normal{};
  for (std::size_t l = 0; l < kLanes; ++l) {
    work.around[l].points.clear();
    work.around[l].inner = 0;
    if (l >= count) continue;
    const Index v = first + static_cast<Index>(l);
    work.collector.collect(v, options, work.around[l]);
    normal[l] = normals[v];
  }
  const auto frames = local_frames(mesh.points(), work.around, normal, work.local);
  JetFit fit(options.degree);
  auto jets = fit.fit(work.local.first(), work.local.inner);
  if (rows.errors) {
    estimate_errors(jets, frames, work.local, fit, count, rows.errors + first,
                    rows.residuals + first);
  }
  for (std::size_t l = 0; l < count; ++l) {
    const LocalFrame& frame = frames[l];
    Jet& jet = jets[l];
    MongeForm& form = rows.forms[first + l];
    form = to_space(monge_form_of(jet), frame);
    if (!finite(form)) {  // overflow on absurd scales: a flat form is the honest answer
      jet = Jet{};
      form = to_space(monge_form_of(jet), LocalFrame{frame.x, frame.y, frame.z, 1});
    }
    rows.quality[first + l] = {
        jet.condition,
        static_cast<std::uint16_t>(std::min<std::size_t>(work.local.inner[l], 65535)),
        static_cast<std::uint8_t>(jet.degree)};
  }
}

}  // namespace

FitResult fit_monge_forms(const kernel::TriangleMesh& mesh, const FitOptions& options) {
  kernel::require_carried(mesh.points());
  const std::vector<Vec3> normals = vertex_normals(mesh);
  FitResult result;
  result.scale = options.scale;
  if (!(options.scale > 0) && options.rings == 0) result.points = options.min_points;
  result.forms.resize(mesh.vertex_count());
  result.quality.resize(mesh.vertex_count());
  std::vector<double> residuals;
  if (options.errors) {
    result.errors.resize(mesh.vertex_count());
    result.creases = crease_vertices(mesh);
    residuals.resize(mesh.vertex_count());
  }
  const Rows rows{result.forms.data(), result.quality.data(),
                  options.errors ? result.errors.data() : nullptr, residuals.data()};
  tbb::enumerable_thread_specific<Workspace> workspaces(
      [&] { return Workspace(mesh, result.creases); });
  // Each vertex depends on nothing but the mesh: any thread count gives the same bytes.
  kernel::parallel_for(tbb::blocked_range<Index>(0, mesh.vertex_count(), 1024),
                       [&](const tbb::blocked_range<Index>& range) {
                         Workspace& work = workspaces.local();
                         for (Index v = range.begin(); v < range.end(); v += kLanes) {
                           const std::size_t count = std::min<std::size_t>(kLanes, range.end() - v);
                           fit_vertices(mesh, normals, v, count, options, work, rows);
                         }
                       });
  if (options.errors) scale_errors(mesh, residuals, result.quality, result.errors);
  smooth_extremalities(mesh, result.forms, options.smooth);
  return result;
}

}  // namespace crest::ridges
