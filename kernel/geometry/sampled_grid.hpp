// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Scalar samples on a regular grid of dimension 2 or 3, in the type they were stored in.
#include <array>
#include <cstddef>
#include <cstdint>
#include <variant>
#include <vector>

#include "kernel/arithmetic/vec3.hpp"

namespace crest::kernel {

/// Types of samples, by their place in SampledGrid::Samples.
enum class SampleType : std::uint8_t { i8, u8, i16, u16, i32, u32, i64, u64, f32, f64 };

struct SampledGrid {
  using Samples =
      std::variant<std::vector<std::int8_t>, std::vector<std::uint8_t>, std::vector<std::int16_t>,
                   std::vector<std::uint16_t>, std::vector<std::int32_t>,
                   std::vector<std::uint32_t>, std::vector<std::int64_t>,
                   std::vector<std::uint64_t>, std::vector<float>, std::vector<double>>;

  std::array<std::size_t, 3> size{1, 1, 1};  ///< the first axis is the fastest; size[2] = 1: 2D
  Vec3 spacing{1, 1, 1};                     ///< positive
  Vec3 origin{};                             ///< of sample 0 0 0
  std::array<Vec3, 3> directions{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  ///< of the axes, unit vectors
  Samples samples{};

  int dimension() const { return size[2] == 1 ? 2 : 3; }
  std::size_t count() const { return size[0] * size[1] * size[2]; }
  SampleType type() const { return static_cast<SampleType>(samples.index()); }
  /// Exactly: whoever fills the grid leaves no integer that a double does not hold.
  double at(std::size_t i) const {
    return std::visit([i](const auto& x) { return static_cast<double>(x[i]); }, samples);
  }
  /// A position in the grid's own frame, in world units from its origin, as one of the world.
  Vec3 to_world(const Vec3& p) const { return origin + direction_to_world(p); }
  Vec3 direction_to_world(const Vec3& v) const {
    return v[0] * directions[0] + v[1] * directions[1] + v[2] * directions[2];
  }
};

}  // namespace crest::kernel
