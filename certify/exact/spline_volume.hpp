// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The data section that claims about quadratic splines of a volume begin with (spline_rays/SPEC.md,
// "Volume"): a grid of samples, where it lies, and a level.
#include <array>
#include <cstdint>
#include <vector>

#include "certify/container/byte_reader.hpp"
#include "certify/container/byte_writer.hpp"

namespace crest::certify {

/// Of samples: i8 u8 i16 u16 i32 u32 i64 u64 f32 f64 are 0 to 9. Width in bytes.
inline constexpr std::array<std::uint8_t, 10> kVolumeSampleSize = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};

struct SplineVolume {
  std::uint8_t type = 8;  ///< of samples: kVolumeSampleSize
  bool extended = false;  ///< a layer of samples is added by linear extrapolation
  std::array<std::uint32_t, 3> nodes{};
  std::array<double, 3> origin{}, spacing{1, 1, 1};
  /// Row by row: a sample lies at origin + direction (spacing times index).
  std::array<double, 9> direction{1, 0, 0, 0, 1, 0, 0, 0, 1};
  double level = 0;                   ///< c
  std::vector<std::uint8_t> samples;  ///< little-endian, x fastest

  std::size_t sample_count() const { return std::size_t{nodes[0]} * nodes[1] * nodes[2]; }
  /// Cubes along an axis: round interior samples, with `extended` round all.
  std::uint32_t cubes(std::size_t axis) const { return extended ? nodes[axis] : nodes[axis] - 2; }
};

/// Throws std::invalid_argument if the samples are not as many as the grid says.
void require_fit(const SplineVolume& volume);
std::size_t encoded_size(const SplineVolume& volume);
void write_volume(ByteWriter& out, const SplineVolume& volume);
/// Guarantees: what SPEC.md says of the numbers. Throws Malformed.
SplineVolume read_volume(ByteReader& reader);

}  // namespace crest::certify
