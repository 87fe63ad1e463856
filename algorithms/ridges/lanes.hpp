// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Four vertices side by side: lane j of every quantity belongs to the j-th of them. Lanes never
// mix, so a vertex gets the same bits whatever its neighbours in a batch, on any instruction set.
#include <array>
#include <span>
#include <vector>

#include "kernel/arithmetic/vec3.hpp"
#include "kernel/geometry/index.hpp"

namespace crest::ridges {

inline constexpr std::size_t kLanes = 4;
// The alignment is said twice over: without AVX the compiler would take 16.
using Lanes = double __attribute__((vector_size(8 * kLanes), aligned(8 * kLanes)));

#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && \
    !defined(__SANITIZE_ADDRESS__)
#define CREST_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define CREST_CLONES
#endif

/// One point of each of the four neighbourhoods; live is 1, or 0 where a shorter neighbourhood has
/// ended (then the point is the origin).
struct alignas(8 * kLanes) PointLanes {
  Lanes x, y, z, live;
};

/// The points of a vertex's fit, itself first; then those that only the second, wider fit has.
struct Support {
  std::vector<kernel::Index> points;
  std::size_t inner = 0;  ///< points of the first fit
};

/// Lane j holds inner[j] points in the rows before `split`, the wider support's others after it;
/// both parts have an even number of rows, filled up with points that are not live.
struct NeighbourhoodLanes {
  std::vector<PointLanes> rows;
  std::size_t split = 0;
  std::array<std::size_t, kLanes> inner{}, all{};

  std::span<const PointLanes> first() const { return {rows.data(), split}; }
  std::span<const PointLanes> second() const { return {rows.data() + split, rows.size() - split}; }
};

}  // namespace crest::ridges
