// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/predicates/critical_value_grid.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace crest::kernel {
namespace {

using Integer = std::int64_t;
// Below 2^9 2^(3 kBits) 2^(4 kBits + 12).
__extension__ using Wide = __int128;
static_assert(5 * ValueGrid::kBits + 14 <= 64 && 7 * ValueGrid::kBits + 21 < 127);

/// Far enough from the ends of the doubles' range that steps, ranges and scales are doubles.
constexpr int kLeastExponent = -1000, kLargestExponent = 900;

/// Of the last bit that is set. Requires: x is not zero.
int last_exponent(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const int exponent = static_cast<int>(bits >> 52 & 0x7ff);
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
  const std::uint64_t mantissa = exponent == 0 ? fraction : fraction | std::uint64_t{1} << 52;
  return std::max(exponent, 1) - 1075 + std::countr_zero(mantissa);
}

template <ValueKind kind>
Wide floor_of(const FaceValues& steps, int fraction_bits, Integer offset) {
  const ValueFraction<Integer, kind> q(steps);
  const bool turn = q.denominator < 0;
  const Integer d = turn ? -q.denominator : q.denominator, n = turn ? -q.numerator : q.numerator;
  const Wide scaled = Wide{(static_cast<Integer>(steps.corner[0]) + offset) * d + n}
                      << fraction_bits;
  return scaled / d;  // of positive numbers, so it is the floor
}

}  // namespace

std::optional<ValueGrid> ValueGrid::find(std::span<const double> values,
                                         std::span<const double> more) {
  double low = 0, high = 0, largest_range = std::ldexp(1.0, kLargestExponent + kBits);
  int exponent = kLargestExponent;
  bool first = true;
  for (const std::span<const double> part : {values, more}) {
    for (const double x : part) {
      low = first ? x : std::min(low, x);
      high = first ? x : std::max(high, x);
      first = false;
      if (x != 0 && last_exponent(x) < exponent) {
        exponent = last_exponent(x);
        if (exponent < kLeastExponent) return std::nullopt;
        largest_range = std::ldexp(1.0, exponent + kBits);
      }
      // The bound is a double, so rounding takes no larger range to it.
      if (high - low > largest_range) return std::nullopt;
    }
  }
  return ValueGrid(low, high - low, exponent);
}

ValueGrid::ValueGrid(double least, double range, int exponent)
    : least_(least),
      steps_a_unit_(std::ldexp(1.0, -exponent)),
      range_(static_cast<std::int64_t>(range * steps_a_unit_)),
      // The least b with D <= 2^b.
      fraction_bits_(4 * (range_ <= 1 ? 0
                                      : static_cast<int>(std::bit_width(
                                            static_cast<std::uint64_t>(range_ - 1)))) +
                     12) {}

std::uint64_t ValueGrid::key(const CriticalValue& value) const {
  const auto step = [this](double x) { return (x - least_) * steps_a_unit_; };
  if (value.kind == ValueKind::vertex) {
    const auto steps = static_cast<std::int64_t>(step(value.f.corner[0])) + range_;
    return static_cast<std::uint64_t>(steps) << fraction_bits_;
  }
  FaceValues steps{};
  for (std::size_t k = 0; k < 3; ++k) {
    steps.corner[k] = step(value.f.corner[k]);
    steps.side[k] = step(value.f.side[k]);
  }
  return static_cast<std::uint64_t>(value.kind == ValueKind::edge
                                        ? floor_of<ValueKind::edge>(steps, fraction_bits_, range_)
                                        : floor_of<ValueKind::face>(steps, fraction_bits_, range_));
}

}  // namespace crest::kernel
