// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The forms of a surface that is a graph (SPEC.md, "Forms"): of kind 0 all are, of
// kind 1 height fields.
//
// Let two coordinates of X(U, V) be affine, with Jacobian matrix J, and h the third. Only h has
// second derivatives, and N's component along it is det J (in cyclic order), so
//   I = J^T J + (h_i h_j),  L = det J (h_ij),  T = det J (h_ijk),  X_v . X_vv = h_v h_vv.
// N by |det J| instead, a constant, keeps all signs: A, S, E and G get positive constant factors.
#include <optional>

#include "certify/ridges_smooth/forms.hpp"
#include "certify/ridges_smooth/piece.hpp"

namespace crest::certify::smooth {

/// N = sign (-h_1, -h_2, 1) times a positive constant.
template <class M, class Coefficients>
struct Graph {
  const Coefficients& h;                               ///< Taylor coefficients
  double sign;                                         ///< +1 or -1
  std::array<M, 3> metric = {M(1.0), M(0.0), M(1.0)};  ///< of the plane as 11, 12, 22
};

template <class M, class Coefficients>
Graph<M, Coefficients> graph_of(const Coefficients& h, double sign) {
  return {h, sign};
}
/// The graph that X is, if two of its coordinates are affine. Jet: an expansion with mask().
template <class M, class Jet>
std::optional<Graph<M, Jet>> height_field(const std::array<Jet, 3>& x) {
  const auto is_affine = [](const Jet& f) { return f.mask() >> 3 == 0; };
  for (std::size_t m = 0; m < 3; ++m) {
    const Jet &p = x[(m + 1) % 3], &q = x[(m + 2) % 3];
    if (!is_affine(p) || !is_affine(q)) continue;
    const M p1 = p.coefficient(1, 0), p2 = p.coefficient(0, 1);
    const M q1 = q.coefficient(1, 0), q2 = q.coefficient(0, 1);
    const auto sign = certain(p1 * q2 - p2 * q1);
    if (!nonzero(sign)) continue;
    return Graph<M, Jet>{x[m],
                         static_cast<double>(static_cast<int>(*sign)),
                         {p1 * p1 + q1 * q1, p1 * p2 + q1 * q2, p2 * p2 + q2 * q2}};
  }
  return std::nullopt;
}

/// The first and second order, from coefficients up to `Order` >= 2 + K.
template <int K, int Order, class M, class Coefficients>
void fill_graph(const Graph<M, Coefficients>& g, FirstSecond<M, K>& f) {
  using F = Local<M, K>;
  const F h1 = F::template derivative_of<Order>(g.h, 1, 0);
  const F h2 = F::template derivative_of<Order>(g.h, 0, 1);
  f.i = {h1 * h1 + F(g.metric[0]), h1 * h2 + F(g.metric[1]), h2 * h2 + F(g.metric[2])};
  for (int k = 0; k < 3; ++k)
    f.l[static_cast<std::size_t>(k)] = F::template derivative_of<Order>(g.h, 2 - k, k) * g.sign;
}
template <int K, int Order, class M, class Coefficients>
Forms<M, K> graph_forms(const Graph<M, Coefficients>& g) {
  using F = Local<M, K>;
  Forms<M, K> f;
  fill_graph<K, Order>(g, f);
  for (int k = 0; k < 4; ++k)
    f.t[static_cast<std::size_t>(k)] = F::template derivative_of<Order>(g.h, 3 - k, k) * g.sign;
  f.graph = true;
  f.sign = g.sign;
  f.h = {F::template derivative_of<Order>(g.h, 1, 0), F::template derivative_of<Order>(g.h, 0, 1)};
  return f;
}

}  // namespace crest::certify::smooth
