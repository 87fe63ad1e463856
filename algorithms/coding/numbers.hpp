// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Whole numbers as decisions (docs/cmc-format.md, "Numbers").
#include <array>
#include <bit>
#include <cstdint>

#include "algorithms/coding/mixer.hpp"
#include "algorithms/coding/stream_error.hpp"

namespace crest::coding {

/// Small numbers, mostly: the bit length of x + 1 in unary by counters, then its lower bits plain.
class SmallNumber {
 public:
  template <class Range>
  std::uint32_t code(Range& range, std::uint32_t x) {
    const std::uint64_t next = std::uint64_t{x} + 1;
    const int wanted = static_cast<int>(std::bit_width(next)) - 1;
    int length = 0;
    while (code_alone(range, more_[static_cast<std::size_t>(length)], length < wanted))
      if (++length == 30) throw StreamError("has a number above 2^30");
    const auto low = code_bits(range, static_cast<std::uint32_t>(next), length);
    return static_cast<std::uint32_t>((std::uint64_t{1} << length | low) - 1);
  }

 private:
  std::array<Counter, 30> more_;
};

/// Numbers of 64 bits: the bit length in unary by counters, then the bits after the first plain.
class LargeNumber {
 public:
  template <class Range>
  std::uint64_t code(Range& range, std::uint64_t x) {
    const int wanted = static_cast<int>(std::bit_width(x));
    int length = 0;
    while (length < 64 &&
           code_alone(range, more_[static_cast<std::size_t>(length)], length < wanted))
      ++length;
    return length == 0 ? 0 : code_lower(range, x, length - 1) | std::uint64_t{1} << (length - 1);
  }
  /// The `count` lowest bits of x.
  template <class Range>
  static std::uint64_t code_lower(Range& range, std::uint64_t x, int count) {
    std::uint64_t result = 0;
    for (int left = count; left > 0;) {
      const int part = left < 32 ? left : 32;
      left -= part;
      const auto bits = static_cast<std::uint32_t>(x >> left);
      result = result << part | code_bits(range, bits, part);
    }
    return result;
  }

 private:
  std::array<Counter, 64> more_;
};

/// A number below `count` in as many bits as count - 1 has.
template <class Range>
std::uint32_t code_below(Range& range, std::uint32_t x, std::uint32_t count) {
  x = code_bits(range, x, std::bit_width(count - 1));
  if (x >= count) throw StreamError("has a number above its bound");
  return x;
}

}  // namespace crest::coding
