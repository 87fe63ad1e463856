// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// PatchProver's surface and umbilic, for the translation units that instantiate it.
#include "certify/ridges_smooth/immersion.hpp"
#include "certify/ridges_smooth/implicit_impl.hpp"
#include "certify/ridges_smooth/patch.hpp"

namespace crest::certify::smooth {

template <class M>
PatchProver<M>::PatchProver(const Surface& surface, const SmoothPatchRecord& patch, double sign,
                            double reach)
    : surface_(surface),
      patch_(patch),
      sign_(sign),
      reach_(reach),
      p_((patch.axis + 1U) % 3),
      q_((patch.axis + 2U) % 3),
      m_(patch.axis) {
  radius_ = (patch.radius - patch.rho) * (1 + 0x1p-51);
  slack_ = (std::fabs(patch.centre[0]) + std::fabs(patch.centre[1]) + radius_) * 0x1p-51;
}

/// The points of the graph over the triangle (kind 0), which are unique between m0 and m1.
template <class M>
std::optional<std::array<M, 3>> PatchProver<M>::lift(const PlaneTriangle& t) {
  std::array<M, 3> base, direction;
  base[p_] = M::linear(t.corner[0][0], t.corner[1][0], t.corner[2][0], t.error);
  base[q_] = M::linear(t.corner[0][1], t.corner[1][1], t.corner[2][1], t.error);
  const M a = base[p_] - M(patch_.centre[0]), b = base[q_] - M(patch_.centre[1]);
  const auto g = [&](std::size_t k) { return M(patch_.graph[k]); };
  base[m_] = g(0) + a * (g(1) + a * g(3) + b * g(4)) + b * (g(2) + b * g(5));
  direction[m_] = M(sign_);
  const auto foot = find_foot(surface_, base, direction, reach_);
  if (!foot) return std::nullopt;
  const kernel::Range m = foot->x[m_].range();
  if (!(m.low > patch_.height[0] && m.high < patch_.height[1])) return std::nullopt;
  return foot->x;
}

template <class M>
auto PatchProver<M>::forms(const PlaneTriangle& t) -> std::optional<PlaneForms> {
  PlaneForms r;
  if (surface_.surface().implicit) {
    const auto x = lift(t);
    if (!x) return std::nullopt;
    const auto f = surface_.template implicit<5>(*x);
    if (!is_defined(f)) return std::nullopt;  // (A)
    const auto h = implicit_function<M, 5>(f, m_);
    const auto graph = graph_of<M>(h, sign_);
    r.forms = graph_forms<2, 5>(graph);
    fill_graph<3, 5>(graph, r.second);
    return r;
  }
  const M u = M::linear(t.corner[0][0], t.corner[1][0], t.corner[2][0], t.error);
  const M v = M::linear(t.corner[0][1], t.corner[1][1], t.corner[2][1], t.error);
  const auto x = surface_.template immersion<5>(u, v);
  if (!are_defined(x)) return std::nullopt;  // (A)
  r.forms = surface_forms<2, 5, M>(x);
  fill_surface<3, 5>(x, r.second);
  const auto& i = r.forms.i;
  if (!is_positive(i[0].value() * i[2].value() - i[1].value() * i[1].value())) return std::nullopt;
  return r;
}

template <class M>
bool PatchProver<M>::find_centre() {
  if (centre_) return true;
  const auto f = forms({{patch_.centre, patch_.centre, patch_.centre}, patch_.rho});
  if (!f) return false;
  const auto a = shape(f->forms);
  const auto fixed = [](const M& x) { return constants<M>(x.range()); };
  FanCentre<M> c;
  const std::array entries = {a.a, a.b, a.c};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& i = f->forms.i[k];
    c.da[k] = {fixed(entries[k].d(1, 0)), fixed(entries[k].d(0, 1))};
    c.dda[k] = {fixed(entries[k].d(2, 0)), fixed(entries[k].d(1, 1)), fixed(entries[k].d(0, 2))};
    c.i[k] = fixed(i.value());
    c.di[k] = {fixed(i.d(1, 0)), fixed(i.d(0, 1))};
  }
  const auto q = quintic(f->forms);
  for (std::size_t k = 0; k < 6; ++k) {
    c.q[k] = fixed(q[k].value());
    c.dq[k] = {fixed(q[k].d(1, 0)), fixed(q[k].d(0, 1))};
  }
  centre_ = c;
  return true;
}

template <class M>
std::optional<kernel::Range> PatchProver<M>::height() {
  const auto x = lift({{patch_.centre, patch_.centre, patch_.centre}, patch_.rho});
  if (!x) return std::nullopt;
  return (*x)[m_].range();
}

template <class M>
kernel::MaybeSign PatchProver<M>::index() {
  if (!find_centre()) return std::nullopt;
  const auto& d = centre_->da;
  return certain(d[0][0] * d[1][1] - d[0][1] * d[1][0]);
}

template <class M>
std::optional<std::array<kernel::Range, 4>> PatchProver<M>::derivative() {
  if (!find_centre()) return std::nullopt;
  const auto& d = centre_->da;
  return std::array{d[0][0].range(), d[0][1].range(), d[1][0].range(), d[1][1].range()};
}

/// |Y (a, b)(z)| + |Id - Y D| rho < rho in each coordinate.
template <class M>
bool PatchProver<M>::has_umbilic() {
  if (!find_centre()) return false;
  const auto f = forms({{patch_.centre, patch_.centre, patch_.centre}, 0});
  if (!f) return false;
  const auto a = shape(f->forms);
  const std::array<M, 2> value = {a.a.value(), a.b.value()};
  const auto& d = centre_->da;
  for (std::size_t i = 0; i < 2; ++i) {
    const double* y = &patch_.krawczyk[2 * i];
    const M shift = value[0] * y[0] + value[1] * y[1];
    double size = 0;
    for (std::size_t j = 0; j < 2; ++j) {
      const M off = M(i == j ? 1.0 : 0.0) - (d[0][j] * y[0] + d[1][j] * y[1]);
      size += magnitude(off.range()) * patch_.rho;
    }
    if (!((size + magnitude(shift.range())) * (1 + 0x1p-40) < patch_.rho)) return false;
  }
  return true;
}

}  // namespace crest::certify::smooth
