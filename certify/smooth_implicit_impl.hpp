// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// implicit_function() of smooth_foot.hpp.
#include <vector>

#include "certify/smooth_foot.hpp"
#include "certify/smooth_local.hpp"

namespace crest::certify::smooth {

/// Which products make the coefficient k of h, for one axis.
template <int n>
struct ImplicitPlan {
  static constexpr kernel::JetTables<2, n> kPlane{};
  static constexpr kernel::JetTables<3, n> kSpace{};
  static constexpr std::size_t kCount = kPlane.kCount;

  struct Term {
    std::uint8_t from, power, to;  ///< f_abc times (h^c)_to
  };
  struct Factors {
    std::uint8_t x, y;  ///< h_x (h^(c - 1))_y
  };
  std::size_t unknown = 0;  ///< the place of f_001
  std::array<std::vector<Term>, kCount> terms;
  std::array<std::vector<Factors>, kCount> factors;
  std::array<std::uint64_t, n + 1> of_power{};  ///< bits: f_abc with this c

  explicit ImplicitPlan(std::size_t axis) {
    const auto place = [&](int a, int b, int c) {
      std::array<int, 3> e{};
      e[(axis + 1) % 3] = a;
      e[(axis + 2) % 3] = b;
      e[axis] = c;
      return kSpace.position[kSpace.digits(e[0], e[1], e[2])];
    };
    unknown = place(0, 0, 1);
    for (std::size_t k = 0; k < kCount; ++k) {
      const int i = kPlane.kMonomials.exponents[k][0], j = kPlane.kMonomials.exponents[k][1];
      for (int a = 0; a <= i; ++a)
        for (int b = 0; b <= j; ++b) {
          const std::uint8_t to = kPlane.position[kPlane.digits(i - a, j - b)];
          const int left = i + j - a - b;
          if (a + b > 0 && left > 0)
            factors[k].push_back({kPlane.position[kPlane.digits(a, b)], to});
          // (h^c)_to is zero below degree c; h^0 is the constant one.
          for (int c = left == 0 ? 0 : 1; c <= left; ++c)
            if (a + b + c > 0 && !(a + b == 0 && c == 1))
              terms[k].push_back({place(a, b, c), static_cast<std::uint8_t>(c), to});
        }
    }
    for (int a = 0; a <= n; ++a)
      for (int b = 0; a + b <= n; ++b)
        for (int c = 0; a + b + c <= n; ++c)
          of_power[static_cast<std::size_t>(c)] |= std::uint64_t{1} << place(a, b, c);
  }

  static const ImplicitPlan& along(std::size_t axis) {
    static const std::array<ImplicitPlan, 3> kPlans = {ImplicitPlan(0), ImplicitPlan(1),
                                                       ImplicitPlan(2)};
    return kPlans[axis];
  }
};

template <class M, int n>
kernel::SparseArray<M, kernel::monomial_count(2, n)> implicit_function(
    const kernel::Jet<M, 3, n>& f, std::size_t axis) {
  using Plan = ImplicitPlan<n>;
  using Coefficients = kernel::SparseArray<M, Plan::kCount>;
  const Plan& plan = Plan::along(axis);
  const auto add = [](std::optional<M>& sum, const M& x) {
    if (sum)
      sum = *sum + x;
    else
      sum = x;
  };
  // A power is needed if a term holds it, or the next power is.
  int highest = n;
  while (highest > 1 && (f.mask() & plan.of_power[static_cast<std::size_t>(highest)]) == 0)
    --highest;
  std::array<Coefficients, n + 1> powers;
  Coefficients& h = powers[1];
  const M factor = -reciprocal(f[plan.unknown]);
  for (std::size_t k = 1; k < Plan::kCount; ++k) {
    for (std::size_t c = 2; c <= static_cast<std::size_t>(highest); ++c) {
      std::optional<M> sum;
      for (const auto& [x, y] : plan.factors[k])
        if (h.has(x) && powers[c - 1].has(y)) add(sum, M(h[x] * powers[c - 1][y]));
      if (sum) powers[c].put(k, *sum);
    }
    std::optional<M> sum;
    for (const auto& [from, c, to] : plan.terms[k]) {
      if ((f.mask() >> from & 1) == 0) continue;
      if (c == 0)
        add(sum, f[from]);
      else if (powers[c].has(to))
        add(sum, M(f[from] * powers[c][to]));
    }
    if (sum) h.put(k, M(*sum * factor));
  }
  return std::move(h);
}

}  // namespace crest::certify::smooth
