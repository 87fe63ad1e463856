// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Numbers in binary formats.
#include <bit>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

#include "kernel/geometry/attribute.hpp"

namespace crest::io {

static_assert(std::endian::native == std::endian::little);

/// The number at a place of any alignment.
template <class T>
T load_number(const char* at, bool big_endian) {
  using Bits = std::conditional_t<
      sizeof(T) == 8, std::uint64_t,
      std::conditional_t<sizeof(T) == 4, std::uint32_t,
                         std::conditional_t<sizeof(T) == 2, std::uint16_t, std::uint8_t>>>;
  Bits bits;
  std::memcpy(&bits, at, sizeof bits);
  if (big_endian) {
    if constexpr (sizeof(T) == 8) bits = __builtin_bswap64(bits);
    if constexpr (sizeof(T) == 4) bits = __builtin_bswap32(bits);
    if constexpr (sizeof(T) == 2) bits = __builtin_bswap16(bits);
  }
  return std::bit_cast<T>(bits);
}

using kernel::is_real;
using kernel::NumberType;

constexpr std::size_t size_of(NumberType type) {
  constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

/// Calls `use` with a number of the type, for its own type.
template <class Use>
decltype(auto) with_type(NumberType type, Use&& use) {
  switch (type) {
    case NumberType::i8:
      return use(std::int8_t{});
    case NumberType::u8:
      return use(std::uint8_t{});
    case NumberType::i16:
      return use(std::int16_t{});
    case NumberType::u16:
      return use(std::uint16_t{});
    case NumberType::i32:
      return use(std::int32_t{});
    case NumberType::u32:
      return use(std::uint32_t{});
    case NumberType::i64:
      return use(std::int64_t{});
    case NumberType::u64:
      return use(std::uint64_t{});
    case NumberType::f32:
      return use(float{});
    case NumberType::f64:
      break;
  }
  return use(double{});
}

/// The number at a place, converted to T.
template <class T>
T load_as(NumberType type, const char* at, bool big_endian) {
  return with_type(type, [&](auto sample) {
    return static_cast<T>(load_number<decltype(sample)>(at, big_endian));
  });
}

}  // namespace crest::io
