// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Critical values as machine integers, where the nodal values are few steps of a power of two
// (quantised or integer data): the stage `integer` of critical_value_order for all nodes at once.
//
// Let the nodal values be 0 .. D <= 2^b in steps. Then (critical_value.hpp, ValueFraction)
//   slopes |g|, |h| <= 5 D and bends |p|, |q|, |r| <= 2 D,
//   denominators <= 8 (4 + 4) D^2 = 2^6 D^2 <= 2^(2 b + 6), so that
//   different values are at least 2^-(4 b + 12) apart: floor(value 2^(4 b + 12)) separates them;
//   numerators <= 4 5 5 2 D^3, with corner[0] times the denominator below 2^9 D^3;
//   values lie in [-3/8 D, 11/8 D], as only the corners' shape functions are negative, each at
//   least -1/8. So value + D is in (0, 2^(b + 2)), and the key has 5 b + 14 <= 64 bits.
//
// Laws. (1) key(x) < key(y) iff value(x) < value(y); equal values have equal keys. (2) The same
// for values that are shifted by a constant or scaled by a power of two, as far as both are exact.
#include <optional>
#include <span>

#include "kernel/predicates/critical_value.hpp"

namespace crest::kernel {

class ValueGrid {
 public:
  static constexpr int kBits = 10;

  /// Nothing unless all values are whole multiples of one power of two (from 2^-1000 on), their
  /// range at most 2^kBits of it. Cost: that of the first few values for data that are not
  /// quantised.
  static std::optional<ValueGrid> find(std::span<const double> values,
                                       std::span<const double> more = {});

  /// Requires: nodal values of the grid, a critical point inside its edge or face.
  std::uint64_t key(const CriticalValue& value) const;

 private:
  ValueGrid(double least, double range, int exponent);
  double least_, steps_a_unit_;
  std::int64_t range_;  ///< D
  int fraction_bits_;   ///< 4 b + 12
};

}  // namespace crest::kernel
