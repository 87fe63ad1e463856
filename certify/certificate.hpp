// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Certificates as plain structs, their bytes, and files (format: certify/SPEC.md).
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace crest::certify {

using Bytes = std::vector<std::uint8_t>;
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

/// What expressions define a smooth surface: claim ridges-smooth.
struct SmoothSurfaceData {
  std::uint8_t kind = 0;           ///< 0 implicit, 1 parametric
  std::vector<std::string> texts;  ///< kind 0: F; kind 1: x, y, z, u0, u1, v0, v1
  std::array<double, 6> box{};     ///< kind 0: x0, x1, y0, y1, z0, z1
  std::uint8_t periodic = 0;       ///< kind 1: bit 0 in u, bit 1 in v
};

/// A face of claim ridges-smooth. Directions: SPEC.md, Forms.
struct SmoothFaceRecord {
  static constexpr std::uint8_t kNoZero = 255;
  bool in_patch = false;  ///< then nothing else is written
  std::uint8_t axis = 0;
  std::array<std::uint8_t, 2> type{};  ///< blue, red: 0 none, 1 elliptic, 2 hyperbolic, 3 turning
  bool purple = false;
  std::uint8_t w = 0;
  std::array<std::uint8_t, 2> verdict{};  ///< blue, red: kNoZero, or the direction c
};

struct SmoothPatchRecord {
  std::uint8_t axis = 0;
  std::int8_t twice_index = 0;
  std::array<std::uint8_t, 2> branches{};  ///< blue, red
  std::array<double, 2> centre{};
  double rho = 0, radius = 0;
  std::array<double, 2> height{};    ///< kind 0: m0, m1
  std::vector<std::uint32_t> faces;  ///< ascending
};

struct GraphBoxRecord {
  std::array<double, 6> box{};  ///< x0, x1, y0, y1, z0, z1
  std::uint8_t axis = 0;
  std::uint32_t vertex = 0;
};

/// Claim ridges-smooth: ridges and umbilics of a smooth surface given by expressions.
struct RidgesSmoothCertificate {
  SmoothSurfaceData surface;
  std::int32_t euler_characteristic = 0;
  std::uint32_t boundary_loops = 0, components = 0;
  std::array<std::uint32_t, 4> umbilics{};  ///< index +1/2, -1/2; 1-ridge, 3-ridge
  std::array<std::uint32_t, 4> counts{};    ///< blue loops, blue paths, red loops, red paths
  std::array<std::uint32_t, 2> turning_points{};
  std::uint32_t purple_points = 0;
  std::vector<std::array<double, 6>> vertices;      ///< kind 0: x, N; kind 1: U, V, then zeros
  std::vector<std::array<std::uint32_t, 3>> faces;  ///< F
  std::vector<std::uint8_t> lifts;                  ///< F if periodic, else none
  std::vector<SmoothFaceRecord> face_records;       ///< F
  std::vector<SmoothPatchRecord> patches;           ///< by ascending first face
  std::vector<std::uint32_t> one_sheet_faces;       ///< kind 0, ascending
  std::vector<GraphBoxRecord> graph_boxes;          ///< kind 0
  Bytes tree;                                       ///< kind 0: codes 0-6, 6 followed by u32
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
