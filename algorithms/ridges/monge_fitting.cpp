// SPDX-License-Identifier: GPL-3.0-or-later
#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <cmath>

#include "algorithms/ridges/creases.hpp"
#include "algorithms/ridges/local_frame.hpp"
#include "algorithms/ridges/monge_from_jet.hpp"
#include "algorithms/ridges/neighbourhood.hpp"
#include "algorithms/ridges/pieces.hpp"
#include "algorithms/ridges/smoothing.hpp"
#include "algorithms/ridges/standard_errors.hpp"
#include "kernel/geometry/coordinate_range.hpp"
#include "kernel/geometry/parallel.hpp"

namespace crest::ridges {
namespace {

using kernel::MongeForm;

struct Workspace {
  Workspace(const kernel::MeshPiece& piece, const std::vector<std::uint8_t>& creases)
      : collector(piece, creases) {}
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

/// What is fitted, by place among the owned vertices.
struct Rows {
  MongeForm* forms;
  FitQuality* quality;
  CurvatureError* errors;  ///< null: not wanted
  double* residuals;
  std::uint8_t* left;  ///< 1: the rim has cut the support short
};

/// Fits owned vertices first, first + 1, ... (at most four).
void fit_vertices(const kernel::TriangleMesh& mesh, const std::vector<Vec3>& normals,
                  const std::vector<Index>& owned, std::size_t first, std::size_t count,
                  const FitOptions& options, Workspace& work, const Rows& rows) {
  std::array<Vec3, kLanes> normal{};
  for (std::size_t l = 0; l < kLanes; ++l) {
    work.around[l].points.clear();
    work.around[l].inner = 0;
    if (l >= count) continue;
    const Index v = owned[first + l];
    rows.left[first + l] = !work.collector.collect(v, options, work.around[l]);
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

FitRecords fit_records(const kernel::MeshPiece& piece, const std::vector<std::uint8_t>& creases,
                       const FitOptions& options) {
  const kernel::TriangleMesh& mesh = piece.mesh();
  const std::vector<Vec3> normals = vertex_normals(mesh);
  const std::vector<Index> owned = piece.owned_vertices();
  FitRecords r;
  r.forms.resize(owned.size());
  r.quality.resize(owned.size());
  r.errors.resize(options.errors ? owned.size() : 0);
  r.residuals.resize(r.errors.size());
  std::vector<std::uint8_t> left(owned.size());
  const Rows rows{r.forms.data(), r.quality.data(), options.errors ? r.errors.data() : nullptr,
                  r.residuals.data(), left.data()};
  tbb::enumerable_thread_specific<Workspace> workspaces([&] { return Workspace(piece, creases); });
  // Each vertex depends on nothing but the mesh: any thread count gives the same bytes.
  kernel::parallel_for(tbb::blocked_range<std::size_t>(0, owned.size(), 1024),
                       [&](const auto& range) {
                         Workspace& work = workspaces.local();
                         for (std::size_t i = range.begin(); i < range.end(); i += kLanes)
                           fit_vertices(mesh, normals, owned, i, std::min(kLanes, range.end() - i),
                                        options, work, rows);
                       });
  for (Index i = 0; i < owned.size(); ++i)
    if (left[i] != 0) r.left.push_back(i);
  if (r.left.empty()) return r;
  const auto drop = [&](auto& items) {
    std::size_t i = 0;
    std::erase_if(items, [&](const auto&) { return left[i++] != 0; });
  };
  drop(r.forms);
  drop(r.quality);
  drop(r.errors);
  drop(r.residuals);
  return r;
}

FitResult fit_monge_forms(const kernel::TriangleMesh& mesh, const FitOptions& options,
                          const Workers* workers) {
  kernel::require_carried(mesh.points());
  FitResult result;
  result.scale = options.scale;
  if (!(options.scale > 0) && options.rings == 0) result.points = options.min_points;
  if (options.errors) result.creases = crease_vertices(mesh);
  FitRecords found = fit_all(mesh, result.creases, options, workers);
  result.forms = std::move(found.forms);
  result.quality = std::move(found.quality);
  result.errors = std::move(found.errors);
  if (options.errors) scale_errors(mesh, found.residuals, result.quality, result.errors);
  smooth_extremalities(mesh, result.forms, options.smooth);
  return result;
}

}  // namespace crest::ridges
