// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Item 4 of "Patches": A, I and E along the rays z* + r e(t) of one side of Q, as functions of
// (r, t) that extend to r = 0.
//
// With f any function of the plane, f(z* + r e) is in f(U0) + r grad f(sector) . e (mean value);
// and where f(z*) = 0, f = r P with P in D f(U0) e + (r / 2) D^2 f(sector)[e, e], P_t in D f(U0) e'
// + r D^2 f(sector)[e, e'], P_r in (1/2) D^2 f(sector)[e, e] (Taylor's formula under the integral
// sign). All inclusions are of the values at each (r, t); the constants on the right are models of
// fixed unknown functions within their radius.
#include "certify/smooth_forms.hpp"
#include "certify/smooth_piece.hpp"

namespace crest::certify::smooth {

/// On U0: D(A_11, A_12, A_21), I, the coefficients of E.
template <class M>
struct FanCentre {
  std::array<std::array<M, 2>, 3> da;
  std::array<M, 3> i;
  std::array<M, 6> q;
};
/// On all points z* + r e(t) of a sector: D^2 A (11, 12, 22), DI, D(coefficients of E).
template <class M>
struct FanSector {
  std::array<std::array<M, 3>, 3> dda;
  std::array<std::array<M, 2>, 3> di;
  std::array<std::array<M, 2>, 6> dq;
};

/// e(t) = base + t * slope, e' = slope: the sides (1, t), (-t, 1), (-1, -t), (t, -1).
struct Side {
  std::array<double, 2> base, slope;
};
constexpr Side side_of(int k) {
  constexpr std::array<Side, 4> kSides = {Side{{1, 0}, {0, 1}}, Side{{0, 1}, {-1, 0}},
                                          Side{{-1, 0}, {0, -1}}, Side{{0, -1}, {1, 0}}};
  return kSides[static_cast<std::size_t>(k)];
}

/// E_1 and E_2 with their derivatives by (r, t), and r G_1, r G_2.
template <class M>
struct RayForms {
  std::array<Local<M, 1>, 2> e;
  std::array<M, 2> growth;
  Pair<Local<M, 1>> v1;
  std::array<Local<M, 1>, 3> i;
};

namespace blow_up {

template <class M>
struct Ray {
  M r;
  std::array<M, 2> e;
  std::array<double, 2> slope;
};

template <class M>
M times(const std::array<M, 2>& gradient, const std::array<M, 2>& e) {
  return gradient[0] * e[0] + gradient[1] * e[1];
}
template <class M>
M times(const std::array<M, 2>& gradient, const std::array<double, 2>& e) {
  return gradient[0] * e[0] + gradient[1] * e[1];
}

/// f from its value at z* and its gradient on the sector.
template <class M>
Local<M, 1> expand(const M& value, const std::array<M, 2>& gradient, const Ray<M>& ray) {
  const M along = times(gradient, ray.e);
  return Local<M, 1>::of(value + ray.r * along, along, ray.r * times(gradient, ray.slope));
}
/// f / r for a function that vanishes at z*.
template <class M>
Local<M, 1> divide(const std::array<M, 2>& gradient, const std::array<M, 3>& hessian,
                   const Ray<M>& ray) {
  const std::array<M, 2> he = {hessian[0] * ray.e[0] + hessian[1] * ray.e[1],
                               hessian[1] * ray.e[0] + hessian[2] * ray.e[1]};
  const M half = (he[0] * ray.e[0] + he[1] * ray.e[1]) * 0.5;
  return Local<M, 1>::of(times(gradient, ray.e) + ray.r * half, half,
                         times(gradient, ray.slope) + ray.r * times(he, ray.slope));
}

/// sum of q_k v_1^(5 - k) v_2^k.
template <class F>
F evaluate(const std::array<F, 6>& q, const Pair<F>& v) {
  F sum = q[0], power = v[1];
  for (std::size_t k = 1; k < 6; ++k) {
    sum = sum * v[0] + q[k] * power;
    if (k < 5) power = power * v[1];
  }
  return sum;
}

}  // namespace blow_up

/// On all (r, t) of the models. Nothing unless I(w, P w) > 0.
template <class M>
std::optional<RayForms<M>> ray_forms(const FanCentre<M>& centre, const FanSector<M>& sector,
                                     int side, const std::array<double, 2>& w, const M& r,
                                     const M& t) {
  using F = Local<M, 1>;
  const Side s = side_of(side);
  blow_up::Ray<M> ray{r, {}, s.slope};
  for (std::size_t k = 0; k < 2; ++k) ray.e[k] = s.slope[k] == 0 ? M(s.base[k]) : t * s.slope[k];
  RayForms<M> f;
  for (std::size_t k = 0; k < 3; ++k) f.i[k] = blow_up::expand(centre.i[k], sector.di[k], ray);
  const Shape<F> p = {blow_up::divide(centre.da[0], sector.dda[0], ray),
                      blow_up::divide(centre.da[1], sector.dda[1], ray),
                      blow_up::divide(centre.da[2], sector.dda[2], ray)};
  if (!is_positive(inner(f.i, w, apply(p, w)).value())) return std::nullopt;
  std::array<F, 6> q;
  for (std::size_t k = 0; k < 6; ++k) q[k] = blow_up::expand(centre.q[k], sector.dq[k], ray);
  f.v1 = principal(p, w);
  const std::array<Pair<F>, 2> v = {f.v1, turned(f.i, f.v1)};
  for (std::size_t j = 0; j < 2; ++j) {
    f.e[j] = blow_up::evaluate(q, v[j]);
    // v = v^e e + v^t e', and det(e, e') = 1 on every side.
    const M x = v[j][0].value(), y = v[j][1].value();
    const M ve = x * s.slope[1] - y * s.slope[0], vt = ray.e[0] * y - ray.e[1] * x;
    f.growth[j] = r * ve * f.e[j].d(1, 0) + vt * f.e[j].d(0, 1);
  }
  return f;
}

}  // namespace crest::certify::smooth
