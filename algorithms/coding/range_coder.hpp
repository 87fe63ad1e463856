// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Binary arithmetic coding: a range of 32 bits with carry. The same call codes and decodes, so that
// one routine does both (docs/cmc-format.md, "Decisions").
#include <cstdint>
#include <span>
#include <vector>

namespace crest::coding {

using Bytes = std::vector<std::uint8_t>;

/// A probability in units of 2^-bits, bits at most 32, neither 0 nor 1.
struct Probability {
  std::uint64_t units;
  int bits;
};

class RangeEncoder {
 public:
  static constexpr bool kEncodes = true;

  /// Codes `bit`, which is 1 with probability `one`; returns it.
  bool code(bool bit, Probability one) {
    const auto bound = static_cast<std::uint32_t>((range_ * one.units) >> one.bits);
    if (bit) {
      range_ = bound;
    } else {
      low_ += bound;
      range_ -= bound;
    }
    while (range_ < kLeastRange) {
      range_ <<= 8;
      shift();
    }
    return bit;
  }
  /// The bytes of all decisions; of the numbers in the range that with most trailing zero bytes,
  /// of which up to four are left out.
  Bytes finish();

 private:
  friend class RangeDecoder;
  static constexpr std::uint64_t kLeastRange = std::uint64_t{1} << 24;
  void shift();

  std::uint64_t low_ = 0, range_ = 0xffffffffu;
  std::uint8_t held_ = 0;            ///< the last byte, to which a carry may come
  std::uint64_t held_count_ = 0;     ///< it and the bytes 255 after it; 0: at the beginning
  Bytes bytes_;
};

class RangeDecoder {
 public:
  static constexpr bool kEncodes = false;
  explicit RangeDecoder(std::span<const std::uint8_t> bytes);

  /// The next decision; the first argument is not looked at.
  /// Throws: StreamError when more than the zeros that were left out are missing.
  bool code(bool, Probability one) {
    const auto bound = static_cast<std::uint32_t>((range_ * one.units) >> one.bits);
    const bool bit = value_ < bound;
    if (bit) {
      range_ = bound;
    } else {
      value_ -= bound;
      range_ -= bound;
    }
    while (range_ < RangeEncoder::kLeastRange) {
      range_ <<= 8;
      value_ = value_ << 8 | next();
    }
    return bit;
  }
  /// Throws StreamError unless all bytes were needed.
  void finish() const;
  /// Bits of the bytes read so far, for messages.
  std::uint64_t position() const { return 8 * static_cast<std::uint64_t>(at_); }

 private:
  std::uint32_t next() {
    if (at_ < bytes_.size()) return bytes_[at_++];
    return missing();
  }
  std::uint32_t missing();

  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0, past_ = 0;
  std::uint64_t range_ = 0xffffffffu;
  std::uint32_t value_ = 0;
};

/// `count` bits without a model, the highest first; count at most 32.
template <class Range>
std::uint32_t code_bits(Range& range, std::uint32_t value, int count) {
  std::uint32_t result = 0;
  for (int i = count - 1; i >= 0; --i)
    result = result << 1 | (range.code((value >> i & 1u) != 0, {1, 1}) ? 1u : 0u);
  return result;
}

}  // namespace crest::coding
