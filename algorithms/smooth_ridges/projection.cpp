// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/smooth_ridges/projection.hpp"

#include <memory>

namespace crest::smooth_ridges {

Projection::Sample Projection::sample(const Vec3& p) {
  const auto f = f_(p);
  return {f[0], {f.coefficient(1, 0, 0), f.coefficient(0, 1, 0), f.coefficient(0, 0, 1)}};
}

template <class Direction>
std::optional<Vec3> Projection::newton(Vec3 p, double reach, Direction&& direction) {
  constexpr int kSteps = 30;
  double gone = 0, last = HUGE_VAL;
  for (int i = 0; i < kSteps; ++i) {
    const Sample s = sample(p);
    if (s.value == 0) return p;
    const Vec3 d = direction(s);
    const double t = -s.value / dot(s.gradient, d), move = std::fabs(t) * norm(d);
    gone += move;
    if (!(gone <= reach)) return std::nullopt;
    p = p + t * d;
    // Nothing but rounding is left.
    if (move <= 0x1p-52 * norm(p) || (i > 3 && move >= last)) return p;
    last = move;
  }
  return std::nullopt;
}

std::optional<Vec3> Projection::onto(Vec3 p, double reach) {
  return newton(p, reach, [](const Sample& s) { return s.gradient; });
}

std::optional<Vec3> Projection::along(Vec3 p, const Vec3& m, double reach) {
  return newton(p, reach, [&](const Sample&) { return m; });
}

Vertex Projection::vertex(const Vec3& x) {
  const Vec3 g = sample(x).gradient;
  const double size = norm(g);
  Vertex v{};
  for (std::size_t k = 0; k < 3; ++k) {
    v[k] = x[k] + 0.0;
    v[3 + k] = g[k] / size + 0.0;
  }
  return v;
}

EdgeRules edge_rules(const Surface& surface) {
  if (!surface.is_implicit()) {
    const auto map = std::make_shared<ParametricMap<double, 1>>(surface);
    const auto measure = [map](const Vertex& a, const Vertex& b) {
      const auto x = (*map)({(a[0] + b[0]) / 2, (a[1] + b[1]) / 2});
      double sum = 0;
      for (const auto& c : x) {
        const double d = c.coefficient(1, 0) * (b[0] - a[0]) + c.coefficient(0, 1) * (b[1] - a[1]);
        sum += d * d;
      }
      return sum;
    };
    return {measure, {}, {surface.periodic(0), surface.periodic(1)}};
  }
  const auto project = std::make_shared<Projection>(surface);
  const auto measure = [](const Vertex& a, const Vertex& b) {
    const Vec3 d = position(a) - position(b);
    return dot(d, d);
  };
  const auto place = [project, measure](const Vertex& a, const Vertex& b) {
    Vec3 middle{}, mean{};
    for (std::size_t k = 0; k < 3; ++k) {
      middle[k] = (a[k] + b[k]) / 2;
      mean[k] = (a[3 + k] + b[3 + k]) / 2;
    }
    const double reach = std::sqrt(measure(a, b));
    auto x = project->along(middle, mean, reach);
    if (!x) x = project->onto(middle, reach);
    // Off the surface no chart will hold, and the caller refines on.
    return project->vertex(x ? *x : middle);
  };
  return {measure, place, {}};
}

}  // namespace crest::smooth_ridges
