// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/ridges/monge_from_jet.hpp"

#include <cmath>

namespace crest::ridges {
namespace {

// Binary forms sum f[j] a^(d-j) b^j.
template <std::size_t N>
using Form = std::array<double, N>;

template <std::size_t M, std::size_t N>
Form<M + N - 1> product(const Form<M>& f, const Form<N>& g) {
  Form<M + N - 1> h{};
  for (std::size_t i = 0; i < M; ++i)
    for (std::size_t j = 0; j < N; ++j) h[i + j] += f[i] * g[j];
  return h;
}

template <std::size_t N>
void add(Form<N>& f, const Form<N>& g, double factor = 1) {
  for (std::size_t i = 0; i < N; ++i) f[i] += factor * g[i];
}

}  // namespace

PrincipalFrame principal_frame(const Jet& jet) {
  const double fx = jet.c[1], fy = jet.c[2];
  const Form<3> q = {jet.c[3], jet.c[4], jet.c[5]};
  PrincipalFrame f;
  f.w = std::sqrt(1 + fx * fx + fy * fy);
  f.n = {-fx / f.w, -fy / f.w, 1 / f.w};
  const double l = std::sqrt(1 + fx * fx);
  const kernel::Vec3 t1 = {1 / l, 0, fx / l};
  const kernel::Vec3 t2 = kernel::cross(f.n, t1);
  auto second = [&](const kernel::Vec3& s, const kernel::Vec3& t) {
    return (2 * q[0] * s[0] * t[0] + q[1] * (s[0] * t[1] + s[1] * t[0]) + 2 * q[2] * s[1] * t[1]) /
           f.w;
  };
  const double h11 = second(t1, t1), h12 = second(t1, t2), h22 = second(t2, t2);
  const double mean = (h11 + h22) / 2, p = (h11 - h22) / 2;
  const double r = std::sqrt(p * p + h12 * h12);
  f.k1 = mean + r;
  f.k2 = mean - r;
  double cosine = 1, sine = 0;  // of half the angle of (p, h12)
  if (r > 0) {
    if (p >= 0) {
      cosine = std::sqrt((r + p) / (2 * r));
      sine = h12 / (2 * r * cosine);
    } else {
      sine = std::sqrt((r - p) / (2 * r));
      cosine = h12 / (2 * r * sine);
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    f.d1[i] = cosine * t1[i] + sine * t2[i];
    f.d2[i] = cosine * t2[i] - sine * t1[i];
  }
  return f;
}

kernel::MongeForm monge_form_of(const Jet& jet) {
  const auto& c = jet.c;
  const Form<3> q = {c[3], c[4], c[5]};
  const PrincipalFrame f = principal_frame(jet);
  const Form<2> u = {f.d1[0], f.d2[0]}, v = {f.d1[1], f.d2[1]};  // plane part as forms in (a, b)
  const Form<3> uu = product(u, u), uv = product(u, v), vv = product(v, v);
  const double m = f.n[0], l = f.n[1];  // plane part of n

  const Form<3> g2 = {f.k1 / 2, 0, f.k2 / 2};
  Form<2> lin{};  // 2 Q(w0, n)
  add(lin, u, 2 * q[0] * m + q[1] * l);
  add(lin, v, q[1] * m + 2 * q[2] * l);

  Form<4> g3{};
  add(g3, product(uu, u), c[6]);
  add(g3, product(uu, v), c[7]);
  add(g3, product(u, vv), c[8]);
  add(g3, product(vv, v), c[9]);
  add(g3, product(lin, g2));
  for (double& x : g3) x /= f.w;

  Form<3> slope{};  // grad C(w0) . n
  add(slope, uu, 3 * c[6] * m + c[7] * l);
  add(slope, uv, 2 * c[7] * m + 2 * c[8] * l);
  add(slope, vv, c[8] * m + 3 * c[9] * l);
  const double q_nn = q[0] * m * m + q[1] * m * l + q[2] * l * l;
  Form<5> g4{};
  add(g4, product(uu, uu), c[10]);
  add(g4, product(uu, uv), c[11]);
  add(g4, product(uu, vv), c[12]);
  add(g4, product(uv, vv), c[13]);
  add(g4, product(vv, vv), c[14]);
  add(g4, product(lin, g3));
  add(g4, product(g2, g2), q_nn);
  add(g4, product(slope, g2));
  for (double& x : g4) x /= f.w;

  kernel::MongeForm form;
  form.d1 = f.d1;
  form.n = f.n;
  form.k1 = f.k1;
  form.k2 = f.k2;
  form.b0 = 6 * g3[0];
  form.b1 = 2 * g3[1];
  form.b2 = 2 * g3[2];
  form.b3 = 6 * g3[3];
  form.c0 = 24 * g4[0];
  form.c1 = 6 * g4[1];
  form.c2 = 4 * g4[2];
  form.c3 = 6 * g4[3];
  form.c4 = 24 * g4[4];
  return form;
}

}  // namespace crest::ridges
