// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Decisions of a section of a stream (docs/cmc-format.md, sections 2 and 3).
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "certify/container/reject.hpp"

namespace crest::certify {

inline std::int64_t clamped(std::int64_t x, std::int64_t low, std::int64_t high) {
  return x < low ? low : x > high ? high : x;
}

/// A probability of 1 and how often it was used.
struct Counter {
  std::int32_t p = 1 << 21, n = 0;

  void learn(bool one) {
    const std::int64_t target = one ? (1 << 22) - 1 : 0;
    p += static_cast<std::int32_t>((target - p) * (131072 / (2 * n + 3)) >> 16);
    n += n < 1000;
  }
};

/// A set of weights.
struct Mixer {
  std::array<std::int64_t, 6> weight = {18350, 18350, 18350, 18350, 18350, 18350};
  std::uint32_t uses = 0;
};

using Line = std::array<Counter, 16>;

/// 2^16 lines, found by contexts.
class Lines {
 public:
  Lines() : lines_(std::size_t{1} << 16) {}
  Line& operator()(std::uint64_t context) { return lines_[context * 0x9e3779b97f4a7c15u >> 48]; }

 private:
  std::vector<Line> lines_;
};

template <class... Parts>
std::uint64_t pack(std::uint64_t context, Parts... parts) {
  ((context = (context << 6) + static_cast<std::uint64_t>(parts)), ...);
  return context;
}

class Decisions {
 public:
  explicit Decisions(std::span<const std::uint8_t> bytes) : bytes_(bytes) {
    for (int i = 0; i < 4; ++i) value_ = value_ << 8 | byte();
  }

  bool with(std::uint32_t q, int b) {
    const auto bound = static_cast<std::uint32_t>(std::uint64_t{range_} * q >> b);
    const bool one = value_ < bound;
    if (one) {
      range_ = bound;
    } else {
      value_ -= bound;
      range_ -= bound;
    }
    while (range_ < 1u << 24) {
      range_ <<= 8;
      value_ = value_ << 8 | byte();
    }
    return one;
  }
  std::uint64_t plain(int bits) {
    std::uint64_t x = 0;
    for (int i = 0; i < bits; ++i) x = x << 1 | static_cast<std::uint64_t>(with(1, 1));
    return x;
  }
  std::uint64_t below(std::uint64_t m) {
    int bits = 0;
    while (bits < 64 && (m - 1) >> bits != 0) ++bits;
    const std::uint64_t x = plain(bits);
    require(x < m, "stream: a number is out of range");
    return x;
  }
  bool alone(Counter& counter) {
    const std::int32_t q = counter.p >> 6;
    const bool one = with(static_cast<std::uint32_t>(q == 0 ? 1 : q), 16);
    counter.learn(one);
    return one;
  }
  /// Predicted by counter `which` of each line.
  bool mixed(std::span<Line* const> lines, std::size_t which, Mixer& mixer);
  std::uint64_t small(std::array<Counter, 30>& counters) {
    int length = 0;
    while (alone(at(counters, length, 30))) ++length;
    return (std::uint64_t{1} << length) + plain(length) - 1;
  }
  std::uint64_t large(std::array<Counter, 64>& counters) {
    int length = 0;
    while (length < 64 && alone(counters[static_cast<std::size_t>(length)])) ++length;
    return length == 0 ? 0 : std::uint64_t{1} << (length - 1) | plain(length - 1);
  }
  void finish() const { require(next_ >= bytes_.size(), "stream: bytes after the last decision"); }

 private:
  template <std::size_t n>
  static Counter& at(std::array<Counter, n>& counters, int i, int end) {
    require(i < end, "stream: a number is too large");
    return counters[static_cast<std::size_t>(i)];
  }
  std::uint32_t byte() {
    if (next_ < bytes_.size()) return bytes_[next_++];
    require(next_++ < bytes_.size() + 4, "stream: a section ends early");
    return 0;
  }

  std::span<const std::uint8_t> bytes_;
  std::size_t next_ = 0;
  std::uint32_t range_ = 0xffffffffu, value_ = 0;
};

}  // namespace crest::certify
