// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The certificate of claim 2, features-mesh, as plain structs (SPEC.md).
#include <array>
#include <cstdint>
#include <vector>

namespace crest::certify {

inline constexpr std::uint32_t kFeaturesMesh = 2, kFeaturesMeshVersion = 2;

/// Of a subcomplex: euler = components - loops + closed surfaces.
struct BettiRecord {
  std::int32_t euler;
  std::uint32_t components, loops, closed;
};

/// Claim features-mesh: thinning a marked set of vertices.
struct FeaturesMeshCertificate {
  std::vector<std::array<std::uint32_t, 3>> faces;  ///< F
  std::vector<std::array<double, 3>> positions;     ///< V
  std::vector<std::uint8_t> marked_before;          ///< V: 0 or 1
  std::int32_t euler_characteristic = 0;
  std::uint32_t boundary_loops = 0;
  std::vector<std::uint32_t> removed;       ///< in the order of removal
  std::vector<std::uint32_t> marked_after;  ///< ascending
  std::vector<std::uint32_t> dropped;       ///< ascending
  std::uint32_t components = 0;             ///< of what is marked after without the dropped
  std::array<BettiRecord, 4> betti{};       ///< before: marked, complement; after: the same
};

}  // namespace crest::certify
