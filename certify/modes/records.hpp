// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The certificate of claim 6, modes, as plain structs (SPEC.md).
#include <array>
#include <cstdint>
#include <vector>

namespace crest::certify {

inline constexpr std::uint32_t kModes = 6, kModesVersion = 3;

/// Codes of the nodes of trees, which are written in preorder (SPEC.md, "Trees").
namespace modes_code {
// Edge: 1 to 63: split at that many 64ths from its first end, the part at the first end follows,
// then the other.
inline constexpr std::uint8_t kRoots = 64;      ///< + k: not split, k roots, at most 6
inline constexpr std::uint8_t kOpenEdge = 127;  ///< not split, nothing stated
// Face: 0, 1, 2: split at that edge (edge k joins corners k and k + 1 mod 3); there follow the edge
// from the opposite corner to the new vertex, the part that keeps corner k, the part that keeps
// corner k + 1.
inline constexpr std::uint8_t kRejectedFace = 3, kGraphFace = 4, kPlainFace = 5, kOpenFace = 6;
// Tetrahedron: 0 to 5: split at edge 01, 02, 03, 12, 13, 23; there follow the inner face (the two
// corners that are not on the edge, in their order, then the new vertex), the part that keeps the
// edge's first corner, the part that keeps its second.
inline constexpr std::uint8_t kRejectedTet = 6, kGraphTet = 7, kPlainTet = 8, kOpenTet = 9;
}  // namespace modes_code

/// A vertex that is put into an edge, face or tetrahedron where the tensor is zero.
struct ZeroRecord {
  std::vector<std::uint32_t> corners;  ///< 2, 3 or 4, ascending
};

/// A root of an edge that is not split: in (low, high), measured from the edge's first end (0) to
/// its second (1). Next to an end: low = high = 0 or 1. Of a pair at one place both are listed.
struct RootRecord {
  double low, high;
  std::int8_t level;  ///< +1: on the surface of mode +mu (and of mode 0), -1: of -mu
};

/// Direction in the barycentrics of the face; the third number makes the sum 0.
struct FaceWitness {
  std::array<std::int16_t, 2> w;
  double lambda;  ///< 0 with kPlainFace
};
/// Two roots joined in a face, numbered along its edges 0, 1, 2 from corner 0 on; first < second.
struct ArcPair {
  std::uint8_t first, second;
};
/// Direction in the barycentrics of the cell; the fourth number makes the sum 0.
struct TetWitness {
  std::array<std::int16_t, 3> w;
  double lambda;                       ///< 0 with kPlainTet
  std::array<std::uint8_t, 2> pieces;  ///< components in the cell: of the + level, of the - level
};

/// A vertex inside a cell.
struct InnerVertex {
  std::uint32_t witness;          ///< of its cell, in the list of those of tetrahedra
  std::int8_t level;              ///< +1, -1, as a root's
  std::array<double, 3> weights;  ///< of the cell's corners 0, 1, 2
};

/// A component of a level that touches no open tetrahedron.
struct SurfaceComponent {
  std::int32_t euler_characteristic;
  std::uint32_t boundary_loops;
  friend auto operator<=>(const SurfaceComponent&, const SurfaceComponent&) = default;
};
struct SurfaceCounts {
  std::vector<SurfaceComponent> components;  ///< ascending
  std::uint32_t touched = 0;                 ///< components that touch open tetrahedra
};

/// The surfaces of mode +mu and -mu; of mode 0.
struct ModeLevel {
  std::uint64_t numerator = 0, denominator = 1;  ///< of mu, in lowest terms
  std::vector<std::array<std::uint32_t, 2>>
      edges;  ///< with a tree; corners ascending, all ascending
  std::vector<std::array<std::uint32_t, 3>> faces;
  std::vector<std::uint32_t> tets;  ///< with a tree, ascending
  // What the trees hold, in the order in which they are met: all edges, all faces, all tets.
  std::vector<std::uint8_t> codes;
  std::vector<RootRecord> roots;  ///< along each edge ascending
  std::vector<FaceWitness> face_witnesses;
  std::vector<ArcPair> arcs;  ///< in each face ascending
  std::vector<TetWitness> tet_witnesses;
  SurfaceCounts positive, negative;  ///< mode 0: positive only
  std::uint32_t open_tets = 0;       ///< leaves and whole tetrahedra where nothing is claimed
  // Positions, or nothing: all empty and 0.
  std::vector<double> root_places{};        ///< of each root on its leaf edge
  std::vector<std::uint16_t> arc_points{};  ///< inner points of each arc's polyline
  std::vector<std::array<double, 2>>
      points{};  ///< these, from an arc's first root on: weights of its face's corners 0 and 1
  std::vector<InnerVertex> inner{};          ///< by witness, of one cell those of the + level first
  std::uint32_t placed = 0, not_placed = 0;  ///< pieces of cells and cones: at least, the others
  std::uint32_t near = 0;  ///< roots, points and inner vertices whose mode is near: at least
};

/// Claim modes: level sets of the mode of a piecewise linear tensor field.
struct ModesCertificate {
  std::vector<std::array<double, 3>> points;       ///< V
  std::vector<std::array<std::uint32_t, 4>> tets;  ///< C
  std::vector<std::array<double, 6>> tensors;      ///< V: xx yy zz xy yz xz
  std::vector<ZeroRecord> zeros;                   ///< in the order of insertion
  std::vector<ModeLevel> levels;
};

}  // namespace crest::certify
