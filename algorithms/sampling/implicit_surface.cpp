// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/sampling/implicit_surface.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace crest::sampling {
namespace {

struct Frame {
  Point d1, d2, n;
};

/// Any direct frame whose third axis is n.
Frame any_frame(const Point& n) {
  std::size_t least = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (std::abs(n[i]) < std::abs(n[least])) least = i;
  Point axis{};
  axis[least] = 1;
  Point d1 = axis - n[least] * n;
  d1 = (1 / norm(d1)) * d1;
  return {d1, cross(n, d1), n};
}

template <int Order>
Jet<2, Order> height(const ImplicitSurface& surface, const Point& p, const Frame& frame,
                     Real slope) {
  using Series = Jet<2, Order>;
  const Series x = Series::variable(0, 0), y = Series::variable(1, 0);
  Series z;
  for (int known = 1; known < Order; ++known) {
    std::array<Series, 3> at;
    for (std::size_t i = 0; i < 3; ++i)
      at[i] = p[i] + frame.d1[i] * x + frame.d2[i] * y + frame.n[i] * z;
    z = z - (1 / slope) * surface.evaluate(at);
  }
  return z;
}

/// Turns d1 onto the eigenvector of the larger eigenvalue of the Hessian ((a, b), (b, c)).
Frame principal_frame(const Frame& f, const Jet<2, 2>& z) {
  const Real a = 2 * z.coefficient(2, 0), b = z.coefficient(1, 1), c = 2 * z.coefficient(0, 2);
  const Real half = (a - c) / 2, radius = std::sqrt(half * half + b * b);
  if (radius == 0) return f;
  Real x = half >= 0 ? half + radius : b, y = half >= 0 ? b : radius - half;
  const Real norm = std::sqrt(x * x + y * y);
  x /= norm;
  y /= norm;
  return {x * f.d1 + y * f.d2, x * f.d2 - y * f.d1, f.n};
}

}  // namespace

ValueAndGradient gradient(const ImplicitSurface& surface, const Point& p) {
  using Linear = Jet<3, 1>;
  const Linear f = surface.evaluate(std::array<Linear, 3>{
      Linear::variable(0, p[0]), Linear::variable(1, p[1]), Linear::variable(2, p[2])});
  return {f[0], {f.coefficient(1, 0, 0), f.coefficient(0, 1, 0), f.coefficient(0, 0, 1)}};
}

kernel::MongeForm monge_form(const ImplicitSurface& surface, const Point& given) {
  // The given point is rounded to double: step onto the surface first.
  ValueAndGradient at = gradient(surface, given);
  const Point p = given - (at.value / dot(at.gradient, at.gradient)) * at.gradient;
  at = gradient(surface, p);
  const Real slope = norm(at.gradient);
  Frame frame = any_frame((1 / slope) * at.gradient);
  frame = principal_frame(frame, height<2>(surface, p, frame, slope));
  const Jet<2, 4> z = height<4>(surface, p, frame, slope);

  kernel::MongeForm m;
  m.d1 = to_vec3(frame.d1);
  m.n = to_vec3(frame.n);
  const auto derivative = [&](int i, int j) { return static_cast<double>(z.derivative(i, j)); };
  m.k1 = derivative(2, 0);
  m.k2 = derivative(0, 2);
  if (m.k1 < m.k2) std::swap(m.k1, m.k2);  // umbilics, by rounding
  m.b0 = derivative(3, 0);
  m.b1 = derivative(2, 1);
  m.b2 = derivative(1, 2);
  m.b3 = derivative(0, 3);
  m.c0 = derivative(4, 0);
  m.c1 = derivative(3, 1);
  m.c2 = derivative(2, 2);
  m.c3 = derivative(1, 3);
  m.c4 = derivative(0, 4);
  return m;
}

Point project_along_ray(const ImplicitSurface& surface, const Point& origin,
                        const Point& direction) {
  const auto at = [&](Real t) {
    std::array<Jet<1, 1>, 3> p;
    for (std::size_t i = 0; i < 3; ++i) p[i] = origin[i] + direction[i] * Jet<1, 1>::variable(0, t);
    return surface.evaluate(p);
  };
  if (!(surface.value(origin) < 0))
    throw std::invalid_argument("project_along_ray: the origin is not inside the surface");
  Real low = 0, high = 0, t = 1;
  for (int step = 0; step < 200; ++step) {
    const Jet<1, 1> f = at(t);
    if (f[0] == 0) return origin + t * direction;
    (f[0] < 0 ? low : high) = t;
    if (high == 0 && t > Real(1e6))
      throw std::invalid_argument("project_along_ray: the ray does not meet the surface");
    Real next = t - f[0] / f[1];
    if (std::abs(next - t) <= 4 * std::numeric_limits<Real>::epsilon() * t)
      return origin + next * direction;
    // Newton's step must stay in the bracket; without an upper bound it may double at most.
    if (high == 0)
      next = next > low ? std::min(next, 2 * t) : 2 * t;
    else if (!(next > low && next < high))
      next = (low + high) / 2;
    t = next;
  }
  return origin + t * direction;
}

}  // namespace crest::sampling
