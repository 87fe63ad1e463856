// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Quantities of a surface with their derivatives by its two coordinates, up to order K = 0 to 3.
//
// Operations are identities of Taylor coefficients, so they enclose. Zeros are not stored.
#include <cstdint>
#include <utility>

#include "certify/ridges_smooth/numbers.hpp"
#include "kernel/arithmetic/jet_tables.hpp"
#include "kernel/arithmetic/lanes.hpp"

namespace crest::certify::smooth {

/// M: + - *, and * with doubles. Taylor coefficients in the order of kernel's Monomials<2, K>.
template <class M, int K>
class Local {
 public:
  using Number = M;
  static constexpr kernel::JetTables<2, K> kTables{};
  static constexpr std::size_t kCount = kTables.kCount;
  using Coefficients = kernel::SparseArray<M, kCount>;

  Local() = default;  ///< identically zero
  explicit Local(M value) { c_.put(0, std::move(value)); }
  explicit Local(Coefficients c) : c_(std::move(c)) {}

  /// The expansion of D^(a, b) f, from the Taylor coefficients of f up to `Order` >= a + b + K.
  template <int Order, class Coefficients>
  static Local derivative_of(const Coefficients& f, int a, int b) {
    constexpr kernel::JetTables<2, Order> kFrom{};
    Local r;
    for (std::size_t k = 0; k < kCount; ++k) {
      const int i = kTables.kMonomials.exponents[k][0], j = kTables.kMonomials.exponents[k][1];
      const std::size_t from = kFrom.position[kFrom.digits(a + i, b + j)];
      if ((f.mask() >> from & 1) == 0) continue;
      double factor = 1;
      for (int n = 1; n <= a; ++n) factor *= i + n;
      for (int n = 1; n <= b; ++n) factor *= j + n;
      r.c_.make(k, [&] { return factor == 1 ? f[from] : M(f[from] * factor); });
    }
    return r;
  }
  static Local of(M value, M d1, M d2) {
    Local r(std::move(value));
    r.c_.put(kTables.position[kTables.digits(1, 0)], std::move(d1));
    r.c_.put(kTables.position[kTables.digits(0, 1)], std::move(d2));
    return r;
  }

  const Coefficients& coefficients() const { return c_; }
  const M& value() const { return at(0); }
  M d(int a, int b) const {
    const M& x = at(kTables.position[kTables.digits(a, b)]);
    const double factor = (a > 2 || b > 2 ? 6 : 1) * (a == 2 ? 2 : 1) * (b == 2 ? 2 : 1);
    return factor == 1 ? x : M(x * factor);
  }
  template <int K2>
  Local<M, K2> truncated() const {
    return Local<M, K2>::template derivative_of<K>(c_, 0, 0);
  }
  Local<M, K - 1> slope(int i) const {
    return Local<M, K - 1>::template derivative_of<K>(c_, i == 0 ? 1 : 0, i == 0 ? 0 : 1);
  }

  friend Local operator+(const Local& a, const Local& b) { return a.plus(b, false); }
  friend Local operator-(const Local& a, const Local& b) { return a.plus(b, true); }
  Local operator-() const { return *this * -1.0; }
  friend Local operator*(const Local& a, double s) {
    using kernel::is_defined;
    Local r;
    if (s == 0 && (!a.c_.has(0) || is_defined(a.c_[0]))) return r;
    kernel::for_each_bit(a.c_.mask(), [&](std::size_t i) {
      r.c_.make(i, [&] { return s == 1 ? a.c_[i] : s == -1 ? M(-a.c_[i]) : M(a.c_[i] * s); });
    });
    return r;
  }
  friend Local operator*(double s, const Local& a) { return a * s; }
  /// By a number a lane.
  friend Local operator*(const Local& a, const kernel::Lanes& s) {
    Local r;
    kernel::for_each_bit(a.c_.mask(),
                         [&](std::size_t i) { r.c_.make(i, [&] { return M(a.c_[i] * s); }); });
    return r;
  }
  friend Local operator*(const Local& a, const Local& b) {
    Local r;
    kernel::for_each_bit(a.c_.mask(), [&](std::size_t i) { spread(r.c_, i, a.c_[i], b.c_, 0); });
    return r;
  }
  /// 1 / f: f_0 r_a = -(sum over b != 0 of f_b r_{a-b}).
  friend Local inverse(const Local& f) {
    const M first = reciprocal(f.value());
    Local r(first);
    Coefficients sums;
    for (std::size_t i = 0; i < kCount; ++i) {
      if (i > 0 && !sums.has(i)) continue;
      if (i > 0) r.c_.put(i, M(-(sums[i] * first)));
      spread(sums, i, r.c_[i], f.c_, 1);
    }
    return r;
  }
  /// 2 s_0 s_a = f_a - (sum over b != 0, a of s_b s_{a-b}).
  friend Local sqrt(const Local& f) {
    const M root = square_root(f.value());
    Local r(root);
    if constexpr (K > 0) {
      const M half = reciprocal(root) * 0.5;
      for (std::size_t i = 1; i < kCount; ++i) {
        M sum = f.at(i);
        for (std::size_t j = 1; j < i; ++j)
          for (std::size_t k = 1; k < i; ++k)
            if (kTables.degree[j] + kTables.degree[k] <= K && kTables.product[j][k] == i)
              sum = sum - r.at(j) * r.at(k);
        r.c_.put(i, M(sum * half));
      }
    }
    return r;
  }

 private:
  const M& at(std::size_t i) const {
    static const M kZero(0.0);
    return c_.has(i) ? c_[i] : kZero;
  }
  Local plus(const Local& b, bool negative) const {
    Local r;
    kernel::for_each_bit(c_.mask() | b.c_.mask(), [&](std::size_t i) {
      if (!b.c_.has(i))
        r.c_.put(i, c_[i]);
      else if (!c_.has(i))
        r.c_.make(i, [&] { return negative ? M(-b.c_[i]) : b.c_[i]; });
      else
        r.c_.make(i, [&] { return negative ? M(c_[i] - b.c_[i]) : M(c_[i] + b.c_[i]); });
    });
    return r;
  }
  /// sums_{i + j} += x f_j for the j that are not in `without` and keep the degree within K.
  static void spread(Coefficients& sums, std::size_t i, const M& x, const Coefficients& f,
                     std::uint64_t without) {
    const std::uint64_t which = f.mask() & kTables.up_to[K - std::size_t{kTables.degree[i]}];
    kernel::for_each_bit(which & ~without, [&](std::size_t j) {
      const std::size_t k = kTables.product[i][j];
      accumulate(sums, k, x, f[j]);
    });
  }

  Coefficients c_;
};

}  // namespace crest::certify::smooth
