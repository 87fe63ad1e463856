// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// implicit_function() of smooth_foot.hpp.
#include "certify/smooth_foot.hpp"
#include "certify/smooth_local.hpp"

namespace crest::certify::smooth {

template <class M, int n>
class ImplicitFunction {
 public:
  static constexpr kernel::JetTables<2, n> kPlane{};
  static constexpr kernel::JetTables<3, n> kSpace{};
  static constexpr std::size_t kCount = kPlane.kCount;
  using Coefficients = kernel::SparseArray<M, kCount>;

  ImplicitFunction(const kernel::Jet<M, 3, n>& f, std::size_t axis) : f_(f), axis_(axis) {
    const M factor = -reciprocal(f_[place(0, 0, 1)]);
    for (std::size_t k = 1; k < kCount; ++k) {
      const int i = kPlane.kMonomials.exponents[k][0], j = kPlane.kMonomials.exponents[k][1];
      for (int c = 2; c <= i + j; ++c) add_power(c, k);
      std::optional<M> sum;
      for (int a = 0; a <= i; ++a)
        for (int b = 0; b <= j; ++b)
          for (int c = 0; c <= i + j - a - b; ++c) add_term(sum, {a, b, c}, {i - a, j - b});
      if (sum) powers_[1].put(k, M(*sum * factor));
    }
  }

  Coefficients& result() { return powers_[1]; }

 private:
  struct Exponents3 {
    int a, b, c;
  };
  struct Exponents2 {
    int i, j;
  };

  std::size_t place(int a, int b, int c) const {
    std::array<int, 3> e{};
    e[(axis_ + 1) % 3] = a;
    e[(axis_ + 2) % 3] = b;
    e[axis_] = c;
    return kSpace.position[kSpace.digits(e[0], e[1], e[2])];
  }
  static std::size_t place(Exponents2 e) { return kPlane.position[kPlane.digits(e.i, e.j)]; }
  static void add(std::optional<M>& sum, const M& x) { sum = sum ? M(*sum + x) : x; }

  /// f_abc (h^c)_ij, without the unknown f_001 h_ij itself.
  void add_term(std::optional<M>& sum, Exponents3 e, Exponents2 rest) const {
    const std::size_t from = place(e.a, e.b, e.c);
    if ((f_.mask() >> from & 1) == 0) return;
    if (e.c == 0) {
      if (rest.i == 0 && rest.j == 0) add(sum, f_[from]);
      return;
    }
    if (e.a == 0 && e.b == 0 && e.c == 1) return;
    const auto& power = powers_[static_cast<std::size_t>(e.c)];
    const std::size_t to = place(rest);
    if (power.has(to)) add(sum, M(f_[from] * power[to]));
  }

  /// The coefficient k of h^c = h h^(c - 1): factors of lower degree.
  void add_power(int c, std::size_t k) {
    const auto& less = powers_[static_cast<std::size_t>(c - 1)];
    const int i = kPlane.kMonomials.exponents[k][0], j = kPlane.kMonomials.exponents[k][1];
    std::optional<M> sum;
    for (int a = 0; a <= i; ++a)
      for (int b = 0; b <= j; ++b) {
        if (a + b == 0 || a + b == i + j) continue;
        const std::size_t x = place({a, b}), y = place({i - a, j - b});
        if (powers_[1].has(x) && less.has(y)) add(sum, M(powers_[1][x] * less[y]));
      }
    if (sum) powers_[static_cast<std::size_t>(c)].put(k, *sum);
  }

  const kernel::Jet<M, 3, n>& f_;
  std::size_t axis_;
  std::array<Coefficients, n + 1> powers_;
};

template <class M, int n>
kernel::SparseArray<M, kernel::monomial_count(2, n)> implicit_function(
    const kernel::Jet<M, 3, n>& f, std::size_t axis) {
  return std::move(ImplicitFunction<M, n>(f, axis).result());
}

}  // namespace crest::certify::smooth
