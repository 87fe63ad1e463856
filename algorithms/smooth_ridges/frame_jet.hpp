// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// F's derivatives in a face's frame from those by x, y and z, where most are identically zero: the
// product of two jets that are dense in the frame's coordinates takes 84 products of models.
#include <utility>

#include "algorithms/smooth_ridges/frame.hpp"
#include "kernel/arithmetic/jet.hpp"
#include "kernel/arithmetic/taylor_combinations.hpp"

namespace crest::smooth_ridges {

/// The jet of a -> F(x + a_0 p + a_1 q + a_2 m) at 0 from that of F at x, (p, q, m) = `vectors`.
///
/// Its coefficients of degree d are combinations of F's of degree d: F's monomial b becomes the
/// product of the linear forms x_i = p_i a_0 + q_i a_1 + m_i a_2. The weights are sums of products
/// of d entries, integers below 2^9 in magnitude: exact in doubles for d <= 5.
/// Weight: double, or Lanes for models side by side.
template <class Model, int Order, class Weight>
kernel::Jet<Model, 3, Order> in_frame(const kernel::Jet<Model, 3, Order>& f,
                                      const std::array<kernel::Vector3<Weight>, 3>& vectors) {
  using Result = kernel::Jet<Model, 3, Order>;
  constexpr std::size_t kMost = (Order + 1) * (Order + 2) / 2;  // monomials of degree Order
  constexpr auto& kTables = Result::kTables;
  Result r;
  if ((f.mask() & 1) != 0) r.set(0, f[0]);
  // Of one degree and of that below, counted from the first monomial: [of F][in the frame].
  std::array<std::array<Weight, kMost>, kMost> weights{}, lower{};
  weights[0][0] = 1;
  for (std::size_t d = 1, before = 0, first = 1; d <= Order && f.mask() >> first != 0; ++d) {
    const std::size_t count = (d + 1) * (d + 2) / 2;
    std::swap(weights, lower);
    typename kernel::CombinationsOf<Model, kMost>::Type terms;
    std::array<std::size_t, kMost> sources{};
    for (std::size_t b = 0; b < count; ++b) {
      auto e = kTables.kMonomials.exponents[first + b];
      const std::size_t i = e[0] > 0 ? 0 : e[1] > 0 ? 1 : 2;
      --e[i];
      const auto& rest = lower[kTables.position[kTables.digits(e[0], e[1], e[2])] - before];
      weights[b].fill(0);
      for (std::size_t a = 0; before + a < first; ++a)
        for (std::size_t k = 0; k < 3; ++k) {  // of degree one the last coordinate comes first
          Weight& weight = weights[b][kTables.product[before + a][3 - k] - first];
          weight = weight + rest[a] * vectors[k][i];
        }
      if ((f.mask() >> (first + b) & 1) == 0) continue;
      sources[terms.size()] = b;
      terms.add(f[first + b]);
    }
    for (std::size_t a = 0; a < count && terms.size() > 0; ++a) {
      std::array<Weight, kMost> chosen{};
      for (std::size_t t = 0; t < terms.size(); ++t) chosen[t] = weights[sources[t]][a];
      r.set(first + a, terms.of(chosen, 0));
    }
    before = first;
    first += count;
  }
  return r;
}

}  // namespace crest::smooth_ridges
