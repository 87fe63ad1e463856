// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The certificate of claim 1, ridges-mesh, as plain structs (SPEC.md).
#include <array>
#include <cstdint>
#include <vector>

namespace crest::certify {

inline constexpr std::uint32_t kRidgesMesh = 1, kRidgesMeshVersion = 2;

/// Data section: V vertices, F faces.
struct MeshData {
  std::vector<std::array<std::uint32_t, 3>> faces;  ///< F
  std::vector<std::array<double, 3>> positions;     ///< V
  /// V x (d1 x 3, n x 3, k1, k2, b0, b1, b2, b3, c0, c4)
  std::vector<std::array<double, 14>> monge;
};
/// Bytes of a vertex.
inline constexpr std::size_t kVertexSize = 17 * 8;

struct FaceIndexRecord {
  std::uint32_t face;
  std::int8_t twice_index;
};
struct PatchRecord {
  std::uint32_t centre;
  std::int8_t twice_index;
  std::uint8_t kind;
  std::uint8_t coherent;
  std::vector<std::uint32_t> faces;
};
struct NodeRecord {
  std::uint32_t edge;
  std::uint8_t type;  ///< bits 0-1 crossing, bits 2-3 segment after it
};
struct RidgeRecord {
  std::uint8_t flags;  ///< bit 0 red, bit 1 loop
  std::array<std::uint8_t, 2> end_kind;
  std::array<std::uint32_t, 2> end_patch;
  std::vector<NodeRecord> nodes;
};

/// The producer fills the records in any order of ridges and any direction or
/// start of a ridge; encode() brings them into the canonical form.
struct RidgesMeshCertificate {
  MeshData data;
  std::int32_t euler_characteristic = 0;
  std::uint32_t boundary_loops = 0;
  std::int32_t twice_index_sum = 0;
  std::uint32_t conflict_triangles = 0;
  std::uint32_t ambiguous_edges = 0;
  std::array<std::uint32_t, 2> zero_extremalities{};
  /// Vertices with n against the faces, with k1 = k2, with n x d1 = 0.
  std::uint32_t against_faces = 0, equal_curvatures = 0, parallel_frames = 0;
  std::vector<FaceIndexRecord> face_indices;
  std::vector<PatchRecord> patches;
  std::array<std::uint32_t, 4> counts{};  ///< blue loops, blue paths, red loops, red paths
  std::vector<RidgeRecord> ridges;
};

}  // namespace crest::certify
