// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The forms of a level on a segment, a triangle or a tetrahedron with a tensor at each corner,
// T = sum b_i T_i, in Bernstein form over Bounded<double> (with a proven error) and Integer.
//
// With W_k = T_k - T_0, k = 1 .. D, the corners' directions, and w = (w_1 .. w_D):
//   n = <T, T>, c = 2 tr(T^3)                    (their nets need no change of basis)
//   n_k = <T, W_k>, c_k = 2 <T^2, W_k>           (differences of the nets of n and c)
//   D_k = c_k n - c n_k = 2 (<T^2, W_k> n - tr(T^3) <T, W_k>)
// A witness is (w, lambda) with p > 0, where, q and f as in level.hpp,
//   p = 2 q^2 (D_w |T|^2 + lambda f)             (mu = 0: 6 (<T^2, W> + lambda det)).
#include <array>

#include "algorithms/modes/level.hpp"
#include "algorithms/modes/tensors.hpp"
#include "kernel/polynomial/bounded_form.hpp"

namespace crest::modes {

using Real = kernel::Bounded<double>;
using kernel::Integer;

template <class N, int D>
struct TensorForms {
  kernel::SimplexForm<N, D, 2> n;
  kernel::SimplexForm<N, D, 3> c;
  std::array<kernel::SimplexForm<N, D, 1>, D> nk;
  std::array<kernel::SimplexForm<N, D, 2>, D> ck;
};

/// The four nets over a plain number type.
template <class T, int D>
struct TensorNets {
  kernel::SimplexNet<T, D, 2> n;
  kernel::SimplexNet<T, D, 3> c;

  explicit TensorNets(const std::array<Entries<T>, D + 1>& t) {
    using B2 = kernel::SimplexBasis<D, 2>;
    using B3 = kernel::SimplexBasis<D, 3>;
    for (std::size_t i = 0; i <= D; ++i)
      for (std::size_t j = i; j <= D; ++j) {
        typename B2::Index a{};
        ++a[i];
        ++a[j];
        n.c[B2::position(a)] = product(t[i], t[j]);
        const Entries<T> square = anticommutator(t[i], t[j]);
        for (std::size_t k = j; k <= D; ++k) {
          typename B3::Index b{};
          ++b[i];
          ++b[j];
          ++b[k];
          c.c[B3::position(b)] = product(square, t[k]);
        }
      }
  }
  /// Of degree one less: the net's difference along W_k.
  template <class B, int Degree>
  static kernel::SimplexNet<T, D, Degree - 1> along(const kernel::SimplexNet<T, D, Degree>& net,
                                                    std::size_t k) {
    kernel::SimplexNet<T, D, Degree - 1> r;
    for (std::size_t i = 0; i < r.c.size(); ++i) {
      auto to = B::indices[i], from = B::indices[i];
      ++to[k];
      ++from[0];
      r.c[i] = net.c[kernel::SimplexBasis<D, Degree>::position(to)] -
               net.c[kernel::SimplexBasis<D, Degree>::position(from)];
    }
    return r;
  }
};

/// Errors: let the entries be at most M in size and off by at most e; M counts e in.
/// n: 9 products of two entries (the off-diagonal ones twice): |n| <= 9 M^2, off by 18 M e, and at
///   most 5 roundings each of a part of 9 M^2: 45 u M^2.
/// c: <A B + B A, C>: 54 products of three entries: |c| <= 54 M^3, off by 162 M^2 e, and at most
///   12 roundings of parts of 54 M^3: 648 u M^3.
/// Differences of two: twice that and one rounding more; weights: one rounding more. The constants
/// below are these, increased for the bounds' own roundings. Requires: entries below 2^100.
/// P: double or Lanes. `largest`: M, `error`: e. Without `growth` n and c alone.
template <class P, int D, bool growth = true>
TensorForms<kernel::Bounded<P>, D> bounded_forms(const std::array<Entries<P>, D + 1>& t,
                                                 const P& largest, const P& error) {
  constexpr double u = kernel::kUnitRoundoff;
  const P& m = largest;
  const P n_error = P(19) * m * error + P(60 * u) * m * m,
          c_error = P(170) * m * m * error + P(800 * u) * m * m * m;
  const TensorNets<P, D> nets(t);
  const auto bounded = [](const auto& net, const P& e) {
    using Basis = typename std::decay_t<decltype(net)>::Basis;
    P size = kernel::magnitude(net.c[0]);
    std::array<P, Basis::count> s;
    for (std::size_t i = 0; i < Basis::count; ++i) {
      s[i] = P(Basis::weights[i]) * net.c[i];
      size = kernel::larger(size, kernel::magnitude(net.c[i]));
    }
    return kernel::Form<kernel::Bounded<P>, Basis>(s, size + e, e);
  };
  TensorForms<kernel::Bounded<P>, D> r;
  r.n = bounded(nets.n, n_error);
  r.c = bounded(nets.c, c_error);
  if constexpr (!growth) return r;
  for (std::size_t k = 1; k <= D; ++k) {
    r.nk[k - 1] =
        bounded(TensorNets<P, D>::template along<kernel::SimplexBasis<D, 1>, 2>(nets.n, k),
                P(2.1) * n_error + P(20 * u) * m * m);
    r.ck[k - 1] =
        bounded(TensorNets<P, D>::template along<kernel::SimplexBasis<D, 2>, 3>(nets.c, k),
                P(2.1) * c_error + P(120 * u) * m * m * m);
  }
  return r;
}

template <int D>
TensorForms<Real, D> real_forms(const std::array<Deviator, D + 1>& t) {
  std::array<Symmetric, D + 1> entries;
  double m = 0, e = 0;
  for (std::size_t i = 0; i <= D; ++i) {
    entries[i] = t[i].t;
    m = std::max(m, t[i].largest());
    e = std::max(e, t[i].error);
  }
  return bounded_forms<double, D>(entries, m + e, e);
}

template <int D>
TensorForms<Integer, D> integer_forms(const std::array<Entries<Integer>, D + 1>& t) {
  const TensorNets<Integer, D> nets(t);
  TensorForms<Integer, D> r;
  r.n = kernel::form(nets.n);
  r.c = kernel::form(nets.c);
  for (std::size_t k = 1; k <= D; ++k) {
    r.nk[k - 1] = kernel::form(
        TensorNets<Integer, D>::template along<kernel::SimplexBasis<D, 1>, 2>(nets.n, k));
    r.ck[k - 1] = kernel::form(
        TensorNets<Integer, D>::template along<kernel::SimplexBasis<D, 2>, 3>(nets.c, k));
  }
  return r;
}

template <class N>
N number(std::int64_t x) {
  if constexpr (std::is_same_v<N, Integer>)
    return N(x);
  else
    return N(static_cast<double>(x));
}

/// 2 F: 3 q^2 c^2 - 2 p^2 n^3.
template <class N, int D>
kernel::SimplexForm<N, D, 6> level_form(const TensorForms<N, D>& t, const Level& level) {
  return number<N>(3 * level.q * level.q) * (t.c * t.c) -
         number<N>(2 * level.p * level.p) * (t.n * (t.n * t.n));
}
/// q^2 D_k n.
template <class N, int D>
kernel::SimplexForm<N, D, 6> growth_form(const TensorForms<N, D>& t, const Level& level,
                                         std::size_t k) {
  return number<N>(level.q * level.q) * ((t.ck[k] * t.n - t.c * t.nk[k]) * t.n);
}
/// 3 c_k, in degree 3.
template <class N, int D>
kernel::SimplexForm<N, D, 3> neutral_growth_form(const TensorForms<N, D>& t, std::size_t k) {
  kernel::SimplexForm<N, D, 1> one;
  decltype(one.s) ones;
  ones.fill(1);
  if constexpr (std::is_same_v<N, Integer>)
    one.s = ones;
  else
    one = {ones, 1.0, 0.0};
  return number<N>(3) * (t.ck[k] * one);
}

}  // namespace crest::modes
