// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Certificates as plain structs, their bytes, and files (format: certify/SPEC.md).
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "certify/ridges_smooth/records.hpp"

namespace crest::certify {

using Digest = std::array<std::uint8_t, 32>;

/// Data section: V vertices, F faces.
struct MeshData {
  std::vector<std::array<std::uint32_t, 3>> faces;  ///< F
  std::vector<std::array<double, 3>> positions;     ///< V
  /// V x (d1 x 3, n x 3, k1, k2, b0, b1, b2, b3, c0, c4)
  std::vector<std::array<double, 14>> monge;
};

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

/// Claim ridges-mesh. The producer fills the records in any order of ridges and any direction or
/// start of a ridge; encode() brings them into the canonical form.
struct RidgesMeshCertificate {
  MeshData data;
  std::int32_t euler_characteristic = 0;
  std::uint32_t boundary_loops = 0;
  std::int32_t twice_index_sum = 0;
  std::uint32_t conflict_triangles = 0;
  std::uint32_t ambiguous_edges = 0;
  std::array<std::uint32_t, 2> zero_extremalities{};
  std::vector<FaceIndexRecord> face_indices;
  std::vector<PatchRecord> patches;
  std::array<std::uint32_t, 4> counts{};  ///< blue loops, blue paths, red loops, red paths
  std::vector<RidgeRecord> ridges;
};

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
  std::array<BettiRecord, 4> betti{};       ///< before: marked, complement; after: the same
};

struct ArcRecord {
  std::uint32_t lower, upper;  ///< positions in critical_nodes
};
struct CutRecord {
  std::uint32_t arc, node;
};

/// Claim reeb: the Reeb graph of a function linear or quadratic on each face.
struct ReebCertificate {
  std::vector<std::array<std::uint32_t, 3>> faces;  ///< F
  std::vector<std::array<double, 3>> positions;     ///< V
  std::vector<double> values;                       ///< V
  std::vector<double> edge_values;                  ///< E midpoint values; empty: linear
  std::int32_t euler_characteristic = 0;
  std::uint32_t boundary_loops = 0, components = 0;
  std::uint32_t line_critical = 0, face_critical = 0, tiles = 0;
  std::uint32_t minima = 0, saddles = 0, maxima = 0;  ///< saddles with multiplicity
  std::vector<std::uint32_t> order;                   ///< all nodes, ascending
  std::vector<std::uint32_t> critical_nodes;          ///< ascending in the order
  std::vector<ArcRecord> arcs;                        ///< by (lower, upper)
  std::vector<CutRecord> cuts;                        ///< by arc
};

/// The first bytes of a certificate, up to the end of its data section. They depend on the data
/// alone, so they can be made beside the extraction.
struct EncodedData {
  Bytes bytes;
  Digest digest;  ///< of the data section
};
EncodedData encode_data(const MeshData& data);

/// The file's bytes, sealed, in canonical form. Cost: linear.
Bytes encode(RidgesMeshCertificate certificate);
/// The same with `data` made before; certificate.data is not read.
Bytes encode(RidgesMeshCertificate certificate, EncodedData data);
Bytes encode(const FeaturesMeshCertificate& certificate);
Bytes encode(const ReebCertificate& certificate);
Bytes encode(const RidgesSmoothCertificate& certificate);

/// Digest of the data section as encode() writes it.
Digest data_digest(const Bytes& certificate);
std::string hex(const Digest& digest);

/// Recomputes the seal (reseal), or the data digest and the seal (rebind). Throws
/// std::invalid_argument when the container's lengths do not fit the bytes.
void reseal(Bytes& certificate);
void rebind(Bytes& certificate);

/// Writes to a temporary file beside it, then renames. Throws std::runtime_error.
void write_file(const std::string& path, const Bytes& bytes);
Bytes read_file(const std::string& path);

}  // namespace crest::certify
