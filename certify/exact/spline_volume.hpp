// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The data section that claims about quadratic splines of a volume begin with (spline_rays/SPEC.md,
// "Volume"): a grid of samples, where it lies, and a level.
#include <array>
#include <cstdint>
#include <vector>

#include "certify/container/byte_reader.hpp"
#include "certify/container/byte_writer.hpp"
#include "kernel/arithmetic/sign.hpp"

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

/// From sample indices to the world.
template <class Number>
using VolumeMatrix = std::array<std::array<Number, 3>, 3>;
template <class Number>
VolumeMatrix<Number> world_matrix(const SplineVolume& volume) {
  VolumeMatrix<Number> m;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t k = 0; k < 3; ++k)
      m[r][k] = Number(volume.direction[3 * r + k]) * Number(volume.spacing[k]);
  return m;
}
/// Of the rows and columns after r and k, cyclically.
template <class Number>
Number cofactor(const VolumeMatrix<Number>& m, std::size_t r, std::size_t k) {
  const std::size_t r1 = (r + 1) % 3, r2 = (r + 2) % 3, k1 = (k + 1) % 3, k2 = (k + 2) % 3;
  return m[r1][k1] * m[r2][k2] - m[r1][k2] * m[r2][k1];
}
template <class Number>
Number determinant(const VolumeMatrix<Number>& m) {
  return m[0][0] * cofactor(m, 0, 0) + m[0][1] * cofactor(m, 0, 1) + m[0][2] * cofactor(m, 0, 2);
}
/// The sign of the matrix's determinant. Throws Reject if it is 0.
kernel::Sign orientation(const SplineVolume& volume);

}  // namespace crest::certify
