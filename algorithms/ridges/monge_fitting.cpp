// SPDX-License-Identifier: GPL-3.0-or-later
#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "algorithms/ridges/local_frame.hpp"
#include "algorithms/ridges/monge_from_jet.hpp"
#include "algorithms/ridges/neighbourhood.hpp"
#include "algorithms/ridges/ridges.hpp"
#include "algorithms/ridges/smoothing.hpp"
#include "kernel/geometry/coordinate_range.hpp"

namespace crest::ridges {
namespace {

using kernel::MongeForm;

struct Workspace {
  explicit Workspace(const kernel::TriangleMesh& mesh) : collector(mesh) {}
  NeighbourhoodCollector collector;
  std::array<std::vector<Index>, kLanes> around;
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

/// The Monge form and the quality of vertices[0], vertices[1], ... (at most four).
void fit_vertices(const kernel::TriangleMesh& mesh, const std::vector<Vec3>& normals,
                  std::span<const Index> vertices, const FitOptions& options, Workspace& work,
                  MongeForm* forms, FitQuality* quality) {
  std::array<Vec3, kLanes> normal{};
  for (std::size_t l = 0; l < kLanes; ++l) {
    work.around[l].clear();
    if (l >= vertices.size()) continue;
    work.collector.collect(vertices[l], options, work.around[l]);
    normal[l] = normals[vertices[l]];
  }
  const auto frames = local_frames(mesh.points(), work.around, normal, work.local);
  auto jets = fit_jets(work.local, options.degree);
  for (std::size_t l = 0; l < vertices.size(); ++l) {
    const LocalFrame& frame = frames[l];
    Jet& jet = jets[l];
    forms[l] = to_space(monge_form_of(jet), frame);
    if (!finite(forms[l])) {  // overflow on absurd scales: a flat form is the honest answer
      jet = Jet{};
      forms[l] = to_space(monge_form_of(jet), LocalFrame{frame.x, frame.y, frame.z, 1});
    }
    quality[l].condition = jet.condition;
    quality[l].degree = static_cast<std::uint8_t>(jet.degree);
    quality[l].points =
        static_cast<std::uint16_t>(std::min<std::size_t>(work.around[l].size(), 65535));
    quality[l].b_error = 6 * jet.cubic_error / (frame.scale * frame.scale);
  }
}

double mean_edge_length(const kernel::TriangleMesh& mesh) {
  double sum = 0;
  for (const kernel::Edge& e : mesh.edges())
    sum += kernel::distance(mesh.points()[e.v0], mesh.points()[e.v1]);
  return sum / mesh.edge_count();
}

// Largest extent of the bounding box.
double extent(const kernel::TriangleMesh& mesh) {
  double largest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    double low = mesh.points()[0][k], high = low;
    for (const Vec3& p : mesh.points()) {
      low = std::min(low, p[k]);
      high = std::max(high, p[k]);
    }
    largest = std::max(largest, high - low);
  }
  return largest;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Median of b0's and b3's estimated error over the median of |b|, on evenly spread vertices.
double noise_to_signal(const kernel::TriangleMesh& mesh, const std::vector<Vec3>& normals,
                       const FitOptions& options) {
  constexpr Index kSamples = 2000;
  Workspace work(mesh);
  const Index step = std::max<Index>(1, mesh.vertex_count() / kSamples);
  std::vector<double> error, signal;
  for (Index v = 0; v < mesh.vertex_count();) {
    Index sample[kLanes];
    std::size_t n = 0;
    for (; n < kLanes && v < mesh.vertex_count(); ++n, v += step) sample[n] = v;
    MongeForm form[kLanes];
    FitQuality quality[kLanes];
    fit_vertices(mesh, normals, {sample, n}, options, work, form, quality);
    for (std::size_t l = 0; l < n; ++l) {
      error.push_back(quality[l].degree >= 3 ? quality[l].b_error : HUGE_VAL);
      signal.push_back(std::max(std::fabs(form[l].b0), std::fabs(form[l].b3)));
    }
  }
  const double s = median(signal);
  return s > 0 ? median(error) / s : HUGE_VAL;
}

// The smallest support whose estimated error is a small part of its signal (1 %: the ellipsoid's
// noise table in experiments/002-ridges shows the ridges' topology settle there). Supports grow by
// a quarter from three mean edges to sixteen (some 900 points), at most a quarter of the extent; if
// none is good enough, the best of them.
double choose_scale(const kernel::TriangleMesh& mesh, const std::vector<Vec3>& normals,
                    FitOptions options) {
  constexpr double kEnough = 0.01, kGrowth = 1.25, kFirst = 3, kLast = 16;
  const double edge = mean_edge_length(mesh), limit = std::min(extent(mesh) / 4, kLast * edge);
  options.scale = kFirst * edge;
  double best_scale = options.scale, best = HUGE_VAL;
  for (;; options.scale *= kGrowth) {
    const double ratio = noise_to_signal(mesh, normals, options);
    if (ratio < best) {
      best = ratio;
      best_scale = options.scale;
    }
    if (ratio <= kEnough || options.scale * kGrowth > limit) return best_scale;
  }
}

}  // namespace

FitResult fit_monge_forms(const kernel::TriangleMesh& mesh, const FitOptions& given) {
  kernel::require_carried(mesh.points());
  FitOptions options = given;
  const std::vector<Vec3> normals = vertex_normals(mesh);
  if (options.auto_scale) options.scale = choose_scale(mesh, normals, options);
  FitResult result;
  result.scale = options.scale;
  result.forms.resize(mesh.vertex_count());
  result.quality.resize(mesh.vertex_count());
  tbb::enumerable_thread_specific<Workspace> workspaces([&] { return Workspace(mesh); });
  // Each vertex depends on nothing but the mesh: any thread count gives the same bytes.
  tbb::parallel_for(tbb::blocked_range<Index>(0, mesh.vertex_count(), 1024),
                    [&](const tbb::blocked_range<Index>& range) {
                      Workspace& work = workspaces.local();
                      for (Index v = range.begin(); v != range.end();) {
                        Index batch[kLanes];
                        std::size_t n = 0;
                        const Index first = v;
                        for (; n < kLanes && v != range.end(); ++n) batch[n] = v++;
                        fit_vertices(mesh, normals, {batch, n}, options, work, &result.forms[first],
                                     &result.quality[first]);
                      }
                    });
  smooth_extremalities(mesh, result.forms, options.smooth);
  return result;
}

}  // namespace crest::ridges
