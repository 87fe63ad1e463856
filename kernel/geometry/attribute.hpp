// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Numbers that a file has at the vertices, faces or corners of a mesh: normals, colours, anything.
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace crest::kernel {

/// The types of numbers in files.
enum class NumberType : std::uint8_t { i8, u8, i16, u16, i32, u32, i64, u64, f32, f64 };

constexpr bool is_real(NumberType type) {
  return type >= NumberType::f32;
}

/// What an attribute is of. Corners of a face stand together, faces in their order.
enum class Site : std::uint8_t { vertices, faces, corners };

struct Attribute {
  std::string name;
  Site site = Site::vertices;
  NumberType type = NumberType::f64;  ///< of every number, which fits it
  std::uint32_t components = 1;       ///< at each place
  /// Component c of place p stands at c * places + p: integers extended to 64 bits, reals as
  /// patterns of binary64.
  std::vector<std::uint64_t> words = {};
  std::vector<bool> missing = {};  ///< places without numbers, whose words are 0; empty: none

  std::size_t places() const { return words.size() / components; }
  bool has(std::size_t place) const { return missing.empty() || !missing[place]; }
  bool operator==(const Attribute&) const = default;
};

}  // namespace crest::kernel
