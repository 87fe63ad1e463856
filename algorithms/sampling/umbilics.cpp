// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/sampling/umbilics.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace crest::sampling {
namespace {

using kernel::distance;
using kernel::MongeForm;

/// The sign of the deviator's linear part: how it winds around the umbilic.
int winding(const MongeForm& m) {
  const double turn = (m.b0 - m.b2) * m.b2 - (m.b1 - m.b3) * m.b1;
  return turn > 0 ? 1 : turn < 0 ? -1 : 0;
}

/// Newton's method from a vertex; steps no longer than reach, given up after leaving 20 reaches.
std::optional<ExactUmbilic> refine(const Surface& surface, const Vec3& start, double reach) {
  Vec3 p = start;
  for (int step = 0; step < 60; ++step) {
    const MongeForm m = surface.monge_form(p);
    const double gap = m.k1 - m.k2, scale = std::abs(m.k1) + std::abs(m.k2);
    if (gap <= 1e-13 * scale) return ExactUmbilic{p, winding(m)};
    // ((b0 - b2) x + (b1 - b3) y) / 2 = -gap / 2, b1 x + b2 y = 0
    const double det = (m.b0 - m.b2) * m.b2 - (m.b1 - m.b3) * m.b1;
    if (det == 0) return std::nullopt;
    double x = -gap * m.b2 / det, y = gap * m.b1 / det;
    const double size = std::hypot(x, y), limit = std::min(1.0, reach / size);
    if (size <= 1e-15 * distance(p, {})) return ExactUmbilic{p, winding(m)};
    x *= limit;
    y *= limit;
    p = to_vec3(surface.project(to_point(p) + Real(x) * to_point(m.d1) +
                                Real(y) * to_point(minimal_direction(m))));
    if (distance(p, start) > 20 * reach) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

std::vector<ExactUmbilic> find_umbilics(const Surface& surface, const SurfaceSample& sample) {
  std::vector<char> least(sample.points.size(), 1);
  const auto gap = [&](kernel::Index v) { return sample.forms[v].k1 - sample.forms[v].k2; };
  for (const kernel::Triangle& f : sample.faces)
    for (std::size_t k = 0; k < 3; ++k) {
      const kernel::Index a = f[k], b = f[(k + 1) % 3];
      if (gap(a) < gap(b)) least[b] = 0;
      if (gap(b) < gap(a)) least[a] = 0;
    }
  const double edge = mean_edge_length(sample.points, sample.faces);
  std::vector<ExactUmbilic> found;
  for (std::size_t v = 0; v < least.size(); ++v) {
    if (!least[v]) continue;
    const auto umbilic = refine(surface, sample.points[v], edge);
    if (!umbilic) continue;
    const bool known = std::any_of(found.begin(), found.end(), [&](const ExactUmbilic& u) {
      return distance(u.point, umbilic->point) < 1e-6 * edge;
    });
    if (!known) found.push_back(*umbilic);
  }
  return found;
}

}  // namespace crest::sampling
