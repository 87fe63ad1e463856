// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Little-endian reading from bytes that nobody has checked. Counts have 64 bits, whatever a size_t
// has: none is cut before it is compared.
#include <bit>
#include <cstring>
#include <span>

#include "certify/container/container.hpp"

namespace crest::certify {

class ByteReader {
 public:
  explicit ByteReader(std::span<const std::uint8_t> bytes) : left_(bytes) {}

  std::size_t left() const { return left_.size(); }

  std::span<const std::uint8_t> take(std::uint64_t count) {
    if (count > left_.size()) throw Malformed("section ends early");
    const auto piece = left_.first(static_cast<std::size_t>(count));
    left_ = left_.subspan(piece.size());
    return piece;
  }

  /// An integer of the type's width, in two's complement if signed.
  template <class Integer>
  Integer integer() {
    const auto piece = take(sizeof(Integer));
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < sizeof(Integer); ++i) value |= std::uint64_t{piece[i]} << (8 * i);
    return static_cast<Integer>(value);
  }

  /// Fills a list of integers or doubles.
  template <class List>
  void words(List& out, std::uint64_t count) {
    using Word = typename List::value_type;
    if (count > left_.size() / sizeof(Word)) throw Malformed("section ends early");
    out.resize(static_cast<std::size_t>(count));
    const auto piece = take(count * sizeof(Word));
    if constexpr (std::endian::native == std::endian::little) {
      if (count > 0) std::memcpy(out.data(), piece.data(), piece.size());
    } else {
      ByteReader reader(piece);
      using Bits = std::conditional_t<sizeof(Word) == 8, std::uint64_t, std::uint32_t>;
      for (Word& word : out) word = std::bit_cast<Word>(reader.integer<Bits>());
    }
  }

  /// Fills trivially copyable rows of little-endian words.
  template <class List>
  void rows(List& out, std::uint64_t count) {
    using Row = typename List::value_type;
    using Word = typename Row::value_type;
    if (count > left_.size() / sizeof(Row)) throw Malformed("section ends early");
    out.resize(static_cast<std::size_t>(count));
    const auto piece = take(count * sizeof(Row));
    if constexpr (std::endian::native == std::endian::little) {
      if (count > 0) std::memcpy(out.data(), piece.data(), piece.size());
    } else {
      ByteReader reader(piece);
      using Bits = std::conditional_t<sizeof(Word) == 8, std::uint64_t, std::uint32_t>;
      for (Row& row : out)
        for (Word& word : row) word = std::bit_cast<Word>(reader.integer<Bits>());
    }
  }

 private:
  std::span<const std::uint8_t> left_;
};

}  // namespace crest::certify
