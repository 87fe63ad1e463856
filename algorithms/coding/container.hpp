// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The stream as sections (docs/cmc-format.md, "Container").
#include <array>
#include <cstdint>
#include <span>

#include "algorithms/coding/coding.hpp"
#include "algorithms/coding/connectivity.hpp"

namespace crest::coding {

enum class Section : std::uint8_t { connectivity, positions, attributes, order };
inline constexpr std::array<const char*, 4> kSectionNames = {"connectivity", "positions",
                                                             "attributes", "order"};

struct Container {
  Method method = Method::valence;
  bool cleared = false;  ///< of vertices of valence 3, which the method does not code
  Places places = Places::none;
  bool has_attributes = false, keeps_order = false;
  Counts counts;
  std::array<std::span<const std::uint8_t>, kSectionNames.size()> sections;  ///< empty: not there
  std::array<std::uint8_t, 8> digest{};

  bool has(Section section) const;
};

Bytes compose(const Container& container);
/// Checks lengths and checksums. Throws: kernel::InputError.
Container parse(std::span<const std::uint8_t> stream);

/// The first bytes of SHA-256.
std::array<std::uint8_t, 8> digest_head(std::span<const std::uint8_t> bytes);
/// The head of the digest of a mesh in the order in which it is decoded.
std::array<std::uint8_t, 8> mesh_digest(Index vertices, std::span<const Triangle> faces,
                                        std::span<const Point> points);

}  // namespace crest::coding
