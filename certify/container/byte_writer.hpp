// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Little-endian writing.
#include <bit>
#include <span>
#include <stdexcept>

#include "certify/certificate.hpp"

namespace crest::certify {

class ByteWriter {
 public:
  explicit ByteWriter(Bytes start = {}) : bytes_(std::move(start)) {}
  template <class Integer>
  void integer(Integer value) {
    auto bits = static_cast<std::uint64_t>(value);
    for (std::size_t i = 0; i < sizeof(Integer); ++i, bits >>= 8)
      bytes_.push_back(static_cast<std::uint8_t>(bits));
  }
  /// A zero is written as +0.
  void number(double x) { integer(bits_of(x)); }
  void numbers(std::span<const double> list) {
    std::uint8_t* to = grow(list.size() * sizeof(double));
    for (const double x : list) to = store(to, bits_of(x));
  }
  void numbers(std::span<const std::uint32_t> list) {
    std::uint8_t* to = grow(list.size() * sizeof(std::uint32_t));
    for (const auto word : list) to = store(to, word);
  }
  void rows(const std::vector<std::array<std::uint32_t, 3>>& rows) {
    std::uint8_t* to = grow(rows.size() * 3 * sizeof(std::uint32_t));
    for (const auto& row : rows)
      for (const auto word : row) to = store(to, word);
  }
  template <std::size_t n>
  void rows(const std::vector<std::array<double, n>>& rows) {
    std::uint8_t* to = grow(rows.size() * n * sizeof(double));
    for (const auto& row : rows)
      for (const double x : row) to = store(to, bits_of(x));
  }
  void count(std::size_t n) {
    if (n > 0xffffffffU) throw std::invalid_argument("certificate: a list is too long");
    integer(static_cast<std::uint32_t>(n));
  }
  void bytes(std::span<const std::uint8_t> piece) {
    std::uint8_t* to = grow(piece.size());  // insert() makes GCC 12 warn of bounds
    for (const auto byte : piece) to = store(to, byte);
  }
  void reserve(std::size_t n) { bytes_.reserve(n); }
  std::size_t size() const { return bytes_.size(); }
  Bytes& result() { return bytes_; }

 private:
  static std::uint64_t bits_of(double x) {
    return x == 0 ? std::uint64_t{0} : std::bit_cast<std::uint64_t>(x);
  }
  std::uint8_t* grow(std::size_t n) {
    bytes_.resize(bytes_.size() + n);
    return bytes_.data() + bytes_.size() - n;
  }
  template <class Word>
  static std::uint8_t* store(std::uint8_t* to, Word word) {
    for (std::size_t i = 0; i < sizeof(Word); ++i)
      to[i] = static_cast<std::uint8_t>(word >> (8 * i));
    return to + sizeof(Word);
  }
  Bytes bytes_;
};

}  // namespace crest::certify
