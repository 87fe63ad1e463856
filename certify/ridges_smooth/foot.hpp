// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Kind 0: the point of S on each fibre, p + s m with F(p + s m) = 0 (SPEC.md, "Chart
// conditions"), and S as a graph m = h(p, q) by implicit differentiation.
#include "certify/ridges_smooth/piece.hpp"
#include "certify/ridges_smooth/vector.hpp"

namespace crest::certify::smooth {

/// s encloses the zero that is unique for |s| <= h (F), x = p + s m.
template <class M>
struct Foot {
  std::array<M, 3> x;
  M s;
};

template <class Jet>
auto gradient(const Jet& f) {
  return std::array{f.coefficient(1, 0, 0), f.coefficient(0, 1, 0), f.coefficient(0, 0, 1)};
}

/// Nothing if (F), or (A) on the fibres, is undecided. Proof. Let D enclose dF/ds = grad F . m for
/// |s| <= h, D > 0, and let t be a polynomial and N = t
/// - F(p + t m) / D, both within (-h, h). F ascends along the fibre, and by the mean value theorem
/// F(p + s m) = F(p + t m) + d (s - t) with a d in D for |s| <= h: negative at s = -h and positive
/// at h, as -h < t - F(p + t m) / d < h. So there is one zero, and it is in N.
template <class M>
std::optional<Foot<M>> find_foot(SurfaceEvaluator<M>& surface, const std::array<M, 3>& p,
                                 const std::array<M, 3>& m, double h) {
  const auto nearby = surface.template implicit<1>(along(p, M::around(0, h), m));
  if (!is_defined(nearby)) return std::nullopt;  // (A)
  const M slope = dot(gradient(nearby), m);
  if (!is_positive(slope)) return std::nullopt;
  const M factor = inverse(slope), at_p = surface.value(p);
  const M t = polynomial(-(at_p * factor));
  const M s = t - surface.value(along(p, t, m)) * factor;
  if (!(std::fmax(magnitude(t.range()), magnitude(s.range())) < h)) return std::nullopt;
  return Foot<M>{along(p, s, m), s};
}

/// The Taylor coefficients of h up to order n, without the constant, from those of F at points of
/// the graph; axis m, (p, q, m) cyclic.
/// Theorem. F(p + a, q + b, m + h(a, b)) vanishes identically, so h_10 = -f_100 / f_001 and h_01 =
/// -f_010 / f_001. Let k be h without these, which begins at degree two, and G(a, b, c) = F(p + a,
/// q + b, m + h_10 a + h_01 b + c). G(a, b, k(a, b)) vanishes too: at each degree from two on g_001
/// k_ij = f_001 k_ij is minus the coefficient of a^i b^j in the other terms. k^c begins at degree 2
/// c: these are g_abc with a + b + 2 c <= n only, and hold lower degrees of k.
template <class M, int n>
kernel::SparseArray<M, kernel::monomial_count(2, n)> implicit_function(
    const kernel::Jet<M, 3, n>& f, std::size_t axis);

}  // namespace crest::certify::smooth
