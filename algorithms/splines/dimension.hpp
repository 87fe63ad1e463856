// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Dimensions of spline spaces, by the rank of their C1 conditions (theorem 7.1).
#include <cstdint>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "algorithms/splines/smoothness_conditions.hpp"

namespace crest::splines {

/// The rank of equations with integer factors modulo the prime 2^31 - 1, hence at most that over
/// the rationals. Each row's pivot is its largest unknown: next to nothing fills in.
class Rank {
 public:
  using Row = std::map<std::size_t, std::uint64_t, std::greater<>>;

  void add(const std::vector<std::pair<std::size_t, int>>& equation) {
    Row row;
    for (const auto& [unknown, factor] : equation) {
      std::uint64_t& x = row[unknown];
      x = (x + (factor < 0 ? kPrime - static_cast<std::uint64_t>(-factor)
                           : static_cast<std::uint64_t>(factor))) %
          kPrime;
    }
    while (true) {
      while (!row.empty() && row.begin()->second == 0) row.erase(row.begin());
      if (row.empty()) return;
      const auto pivot = rows_.find(row.begin()->first);
      if (pivot == rows_.end()) break;
      const std::uint64_t factor = kPrime - row.begin()->second;
      for (const auto& [unknown, x] : pivot->second) {
        std::uint64_t& y = row[unknown];
        y = (y + factor * x) % kPrime;
      }
    }
    const std::uint64_t inverse = power(row.begin()->second, kPrime - 2);
    for (auto& [unknown, x] : row) x = x * inverse % kPrime;
    const std::size_t pivot = row.begin()->first;
    rows_.emplace(pivot, std::move(row));
  }
  std::size_t rank() const { return rows_.size(); }

 private:
  static constexpr std::uint64_t kPrime = (std::uint64_t{1} << 31) - 1;
  static std::uint64_t power(std::uint64_t x, std::uint64_t n) {
    std::uint64_t r = 1;
    for (; n > 0; n /= 2, x = x * x % kPrime)
      if (n % 2 == 1) r = r * x % kPrime;
    return r;
  }
  std::map<std::size_t, Row> rows_;
};

/// The unknown of a coefficient of degree q.
inline std::size_t unknown_of(const std::array<int, 3>& n, int q, const Lattice& at) {
  const auto side = [&](std::size_t d) { return static_cast<std::size_t>(2 * q * n[d] + 1); };
  return static_cast<std::size_t>(at[0]) +
         side(0) * (static_cast<std::size_t>(at[1]) + side(1) * static_cast<std::size_t>(at[2]));
}

/// How many coefficients S^0 of degree q has, and the rank of the conditions for S^1.
struct Dimensions {
  std::size_t continuous, smooth;
};
template <int q>
Dimensions dimensions(const std::array<int, 3>& n) {
  std::vector<bool> seen(unknown_of(n, q, {2 * q * n[0], 2 * q * n[1], 2 * q * n[2]}) + 1);
  std::size_t continuous = 0;
  for (int k = 0; k < n[2]; ++k)
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i)
        for (const auto& points : kDomainPoints<q>)
          for (const Lattice& p : points) {
            const Lattice centres = times(q, {2 * i + 1, 2 * j + 1, 2 * k + 1});
            auto mark = seen[unknown_of(n, q, centres + p)];
            continuous += mark ? 0 : 1;
            mark = true;
          }
  Rank rank;
  for_each_condition(n, q, [&](const Condition& c) {
    std::vector<std::pair<std::size_t, int>> equation;
    for (const auto& term : c.terms) equation.emplace_back(unknown_of(n, q, term.at), term.factor);
    rank.add(equation);
  });
  return {continuous, continuous - rank.rank()};
}

}  // namespace crest::splines
