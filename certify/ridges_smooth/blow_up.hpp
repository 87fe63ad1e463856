// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Item 4 of "Patches": A, I and E along the rays z* + r e(t) of one side of Q, as functions of
// (r, t) that extend to r = 0.
//
// With f any function of the plane, and [.] the enclosure on the sector of rays,
//   f(z* + r e) in f + r D f e + (r^2 / 2) [D^2 f](e, e),
//   d/dr f in D f e + r [D^2 f](e, e),  d/dt f in r D f e' + r^2 [D^2 f](e, e'),
// derivatives without brackets at z*, enclosed on U0. Where f(z*) = 0, f = r P with
//   P in D f e + (r / 2) D^2 f(e, e) + (r^2 / 6) [D^3 f](e, e, e),
//   P_r in (1/2) D^2 f(e, e) + (r / 3) [D^3 f](e, e, e),
//   P_t in D f e' + r D^2 f(e, e') + (r^2 / 2) [D^3 f](e, e, e').
// (Taylor's formula with the remainder as an integral; P_r = (r f_r - f) / r^2 has the weight
// (1 - s) - (1 - s)^2 / 2 = (1 - s^2) / 2.) One order more than the specification shows. All hold
// at each (r, t); constants on the right are models of unknown functions within their radius.
#include "certify/ridges_smooth/forms.hpp"
#include "certify/ridges_smooth/piece.hpp"

namespace crest::certify::smooth {

/// On U0. A_11, A_12, A_21; I; the coefficients of E. Second derivatives as 11, 12, 22.
template <class M>
struct FanCentre {
  std::array<std::array<M, 2>, 3> da, di;
  std::array<std::array<M, 3>, 3> dda;
  std::array<M, 3> i;
  std::array<M, 6> q;
  std::array<std::array<M, 2>, 6> dq;
};
/// On all points z* + r e(t) of a sector. Third derivatives as 111, 112, 122, 222.
template <class M>
struct FanSector {
  std::array<std::array<M, 4>, 3> ddda;
  std::array<std::array<M, 3>, 3> ddi;
  std::array<std::array<M, 3>, 6> ddq;
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

template <class M, class N>
M times(const std::array<M, 2>& gradient, const std::array<N, 2>& e) {
  return gradient[0] * e[0] + gradient[1] * e[1];
}

/// A symmetric form with e filled in once.
template <class M>
std::array<M, 2> times(const std::array<M, 3>& second, const std::array<M, 2>& e) {
  return {second[0] * e[0] + second[1] * e[1], second[1] * e[0] + second[2] * e[1]};
}
template <class M>
std::array<M, 3> times(const std::array<M, 4>& third, const std::array<M, 2>& e) {
  return {third[0] * e[0] + third[1] * e[1], third[1] * e[0] + third[2] * e[1],
          third[2] * e[0] + third[3] * e[1]};
}

/// f from its value and gradient at z* and its second derivatives on the sector.
template <class M>
Local<M, 1> expand(const M& value, const std::array<M, 2>& gradient, const std::array<M, 3>& second,
                   const Ray<M>& ray) {
  const std::array<M, 2> se = times(second, ray.e);
  const M along = times(gradient, ray.e), see = ray.r * times(se, ray.e);
  return Local<M, 1>::of(value + ray.r * (along + see * 0.5), along + see,
                         ray.r * (times(gradient, ray.slope) + ray.r * times(se, ray.slope)));
}
/// f / r for a function that vanishes at z*.
template <class M>
Local<M, 1> divide(const std::array<M, 2>& gradient, const std::array<M, 3>& second,
                   const std::array<M, 4>& third, const Ray<M>& ray) {
  const std::array<M, 2> se = times(second, ray.e), tee = times(times(third, ray.e), ray.e);
  const M half = times(se, ray.e) * 0.5, teee = ray.r * times(tee, ray.e);
  return Local<M, 1>::of(times(gradient, ray.e) + ray.r * (half + teee / 6.0), half + teee / 3.0,
                         times(gradient, ray.slope) +
                             ray.r * (times(se, ray.slope) + ray.r * times(tee, ray.slope) * 0.5));
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
  for (std::size_t k = 0; k < 3; ++k)
    f.i[k] = blow_up::expand(centre.i[k], centre.di[k], sector.ddi[k], ray);
  std::array<F, 3> p;
  for (std::size_t k = 0; k < 3; ++k)
    p[k] = blow_up::divide(centre.da[k], centre.dda[k], sector.ddda[k], ray);
  const Shape<F> shape = {p[0], p[1], p[2]};
  if (!is_positive(s_of(f.i, shape, w))) return std::nullopt;
  std::array<F, 6> q;
  for (std::size_t k = 0; k < 6; ++k)
    q[k] = blow_up::expand(centre.q[k], centre.dq[k], sector.ddq[k], ray);
  f.v1 = principal(shape, w);
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
