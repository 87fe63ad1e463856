// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Forms in plain doubles (or Lanes) with one bound for all coefficients: the triage stage of hull
// signs. Two more numbers a form instead of one a coefficient.
//
// Invariant, w the basis's weights: |s_i - exact_i| <= w_i error, and |s_i|, |exact_i| <= w_i
// magnitude. u = 2^-53. In the rules below the exact bound is multiplied by kSlack = 1 + 16 u,
// which absorbs the at most seven roundings of the rule itself, and kTiny (products of doubles that
// underflow err by 2^-1075 each) is added.
//   coefficients  b_i exact: s_i = w_i b_i is rounded once.        m = max |b|, e = u m
//   sum           s + t is rounded once and does not underflow.    m = ma + mb, e = ea + eb + u m
//   number k      k s is rounded once.                             m = |k| ma, e = |k| ea + u m
//   product       coefficient k is a sum of at most p products, p = the table's longest row; each
//   term
//                 is rounded p times at most, so by at most (p + 1) u of itself (p < 1000). The
//                 weights of its pairs add to w_k (Vandermonde), so
//                 m = ma mb, e = ea mb + ma eb + (p + 1) u m, and p underflows.
// The computed |s_i| is at most w_i (m + e), which kSlack m must cover: it does where (p + 1) <=
// 15, else m is multiplied by 1 + (p + 1) u. Above 2^900 the error is infinite: not decided.
//
// The test runs the same formulas on an error-tracking number and compares.
#include <type_traits>

#include "kernel/arithmetic/approximate.hpp"
#include "kernel/arithmetic/lanes.hpp"
#include "kernel/polynomial/bernstein_form.hpp"

namespace crest::kernel {

/// The number type that names bounded forms, so that a formula is written once:
/// `template <class T> SimplexForm<T, 3, 6> value() const`.
template <class P>
struct Bounded {
  P x;
  Bounded(double v) : x(v) {}  // NOLINT: numbers convert
  Bounded(const Lanes& v)      // NOLINT
      requires std::is_same_v<P, Lanes> : x(v) {}
};

template <class P, class B>
struct Form<Bounded<P>, B> {
  using Basis = B;
  static constexpr double kSlack = 1 + 16 * kUnitRoundoff;
  static constexpr double kTiny = 0x1p-1022;
  static constexpr double kLargest = 0x1p900;
  std::array<P, B::count> s;
  P magnitude, error;

  Form() = default;
  Form(const std::array<P, B::count>& c, P m, P e) : s(c), magnitude(m), error(e) { settle(); }

  /// From exact Bernstein coefficients.
  explicit Form(const Net<P, B>& b) {
    magnitude = kTiny;
    P poison = 0.0;  // NaN if a coefficient is infinite or NaN: then the error is infinite
    for (std::size_t i = 0; i < B::count; ++i) {
      s[i] = P(B::weights[i]) * b.c[i];
      magnitude = larger(magnitude, kernel::magnitude(b.c[i]));
      poison = poison + P(0.0) * b.c[i];
    }
    magnitude = magnitude + poison;
    error = P(kUnitRoundoff) * magnitude;
    settle();
  }

  friend Form operator+(const Form& a, const Form& b) {
    Form r;
    for (std::size_t i = 0; i < B::count; ++i) r.s[i] = a.s[i] + b.s[i];
    r.add_bounds(a, b);
    return r;
  }
  friend Form operator-(const Form& a, const Form& b) {
    Form r;
    for (std::size_t i = 0; i < B::count; ++i) r.s[i] = a.s[i] - b.s[i];
    r.add_bounds(a, b);
    return r;
  }
  friend Form operator*(const Bounded<P>& k, const Form& a) {
    Form r;
    for (std::size_t i = 0; i < B::count; ++i) r.s[i] = k.x * a.s[i];
    const P size = kernel::magnitude(k.x);
    r.magnitude = size * a.magnitude;
    r.error = size * a.error + P(kUnitRoundoff) * r.magnitude;
    r.settle();
    return r;
  }

 private:
  void add_bounds(const Form& a, const Form& b) {
    magnitude = a.magnitude + b.magnitude;
    error = a.error + b.error + P(kUnitRoundoff) * magnitude;
    settle();
  }
  void settle() {
    magnitude = P(kSlack) * magnitude + P(kTiny);
    error = or_infinite(P(kSlack) * error + P(kTiny), magnitude, kLargest);
  }
};

template <class P, class A, class B>
auto operator*(const Form<Bounded<P>, A>& a, const Form<Bounded<P>, B>& b) {
  using Basis = typename ProductBasis<A, B>::type;
  constexpr double kRoundings =
      static_cast<double>(kProductTable<A, B>.longest + 1) * kUnitRoundoff;
  const auto values = Form<P, A>{a.s} * Form<P, B>{b.s};
  const P m = a.magnitude * b.magnitude;
  const P e = a.error * b.magnitude + a.magnitude * b.error + P(kRoundings) * m;
  return Form<Bounded<P>, Basis>(
      values.s, P(1 + kRoundings) * m,
      e + P(static_cast<double>(kProductTable<A, B>.longest) * 0x1p-1074));
}

/// A formula's inputs as forms over its number type. Requires, for exact types: finite
/// coefficients.
template <class T, class P, class B>
Form<T, B> lifted(const Net<P, B>& b) {
  if constexpr (std::is_same_v<T, Bounded<P>>) {
    return Form<T, B>(b);
  } else {
    Net<T, B> r;
    for (std::size_t i = 0; i < B::count; ++i) r.c[i] = T(b.c[i]);
    return form(r);
  }
}

}  // namespace crest::kernel
