// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/surface_geometry.hpp"

#include <tbb/blocked_range.h>

#include <cmath>

#include "algorithms/modes/mode_geometry.hpp"
#include "kernel/geometry/parallel.hpp"

namespace crest::modes {
namespace {

using kernel::Vec3;
using kernel::operator+;
using kernel::operator-;
using kernel::operator*;

PointGeometry geometry_at(const ModeField& field, kernel::Index tet, const Vec3& x) {
  std::array<Vec3, 4> p;
  std::array<Tensor, 4> t;
  for (std::size_t i = 0; i < 4; ++i) {
    const kernel::Index v = field.mesh.tets()[tet][i];
    p[i] = field.mesh.points()[v];
    t[i] = field.tensors[v];
  }
  const Vec3 a = p[1] - p[0], b = p[2] - p[0], c = p[3] - p[0], d = x - p[0];
  const double volume = kernel::determinant(a, b, c);
  if (!(std::fabs(volume) > 0)) return {};
  std::array<double, 4> w = {0, kernel::determinant(d, b, c) / volume,
                             kernel::determinant(a, d, c) / volume,
                             kernel::determinant(a, b, d) / volume};
  w[0] = 1 - w[1] - w[2] - w[3];
  const ModeGeometry g = mode_geometry(p, t, w);
  if (!std::isfinite(g.k1) || !std::isfinite(g.k2)) return {};
  return {g.normal, g.k1, g.k2, g.d1, g.d2};
}

}  // namespace

void add_geometry(const ModeField& field, ModeSurface& surface) {
  constexpr kernel::Index none = ~kernel::Index{0};
  std::vector<kernel::Index> tet(surface.points.size(), none);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (const kernel::Index v : surface.triangles[t])
      if (tet[v] == none) tet[v] = surface.tets[t];
  surface.geometry.resize(surface.points.size());
  kernel::parallel_for(tbb::blocked_range<std::size_t>(0, surface.points.size(), 512),
                       [&](const auto& range) {
                         for (std::size_t v = range.begin(); v < range.end(); ++v)
                           if (tet[v] != none)
                             surface.geometry[v] = geometry_at(field, tet[v], surface.points[v]);
                       });
}

}  // namespace crest::modes
