// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The certificate of claim 8, extremal, as plain structs (SPEC.md).
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace crest::certify {

inline constexpr std::uint32_t kExtremal = 8, kExtremalVersion = 3;

namespace extremal_code {
/// Of a listed cell. Each but kOpen passes the cone test for its w, so it decides its edges.
inline constexpr std::uint8_t kOpen = 0, kCone = 1, kEmpty = 2, kRegular = 3,
                              kRegularExtremal = 4;  ///< regular, and s_nn > 0 on the cell
/// Of a node in a bisection tree, in preorder.
inline constexpr std::uint8_t kLeaf = 0, kSplit = 1;
/// Of a critical edge.
inline constexpr std::uint8_t kMerelyCritical = 0, kExtremalEdge = 1, kUndecidedType = 2;
/// Of samples: i8 u8 i16 u16 i32 u32 i64 u64 f32 f64 are 0 to 9. Width in bytes.
inline constexpr std::array<std::uint8_t, 10> kSampleSize = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
inline constexpr unsigned kMostRefined = 3;
/// A direction's number along its axis.
inline constexpr std::int16_t kScale = 16384;
/// From these bits of a listed cell's byte on: the axis of w, the axis of a, its sign along that.
inline constexpr unsigned kAxis = 3, kGradientAxis = 5, kNegative = 7;
/// The byte of a split in a tree; a leaf's is the axis of its w.
inline constexpr std::uint8_t kSplitByte = 3;
}  // namespace extremal_code

/// The data section.
struct ExtremalData {
  std::uint8_t dimension = 3;  ///< 2 or 3; of what follows the first `dimension` count
  std::uint8_t type = 8;       ///< of samples: extremal_code::kSampleSize
  bool valley = false;         ///< s = L, else s = -L
  bool hessian = false;        ///< T = -+Hess L, else the structure tensor
  std::uint8_t refine = 0;     ///< so often the grid of the samples is halved
  std::array<std::uint32_t, 3> nodes{1, 1, 1};
  std::array<double, 3> spacing{1, 1, 1};
  bool has_min_value = false;
  double min_value = 0;                ///< 0 without one
  double min_strength = 0;             ///< 0: none
  double sigma = 1, tensor_sigma = 1;  ///< in units of the least spacing
  /// Along each axis, of offsets 0 to R; {1}: not smoothed.
  std::array<std::vector<double>, 3> weights{}, tensor_weights{};  ///< T's are {1} with `hessian`
  std::vector<std::uint8_t> samples;                               ///< little-endian, x fastest
};

/// Listed cells first .. first + length - 1.
struct CellRun {
  std::uint32_t first, length;
};
/// A direction, an integer vector that is not zero; with dimension 2 the last number is 0. In the
/// file: the axis of its largest number, and the others where that is kScale.
using ExtremalDirection = std::array<std::int16_t, 3>;

/// A component of the mesh as written (trimmed).
struct ExtremalComponent {
  std::uint32_t polygons = 0;  ///< untrimmed: extremal edges of which something is left
  std::int32_t euler_characteristic = 0;
  std::uint32_t loops = 0;  ///< components of the boundary; with dimension 2: ends
  bool orientable = true;
  bool isotopic = false;  ///< to a component of {g = 0}
  bool extremal = false;  ///< isotopic, and s_nn > 0 on all of its cluster
  bool cut = false;       ///< something was trimmed off
  friend bool operator==(const ExtremalComponent&, const ExtremalComponent&) = default;
};

/// Edges of the mesh (dimension 2: vertices) by the number of polygons (segments) there.
struct ExtremalValences {
  std::uint32_t two = 0;
  std::array<std::uint32_t, 5> one{};  ///< by reason 1 to 5
  std::uint32_t three = 0;             ///< reason 1
  friend bool operator==(const ExtremalValences&, const ExtremalValences&) = default;
};

/// Claim extremal: extremal surfaces of a volume, extremal curves of an image, on the grid of the
/// samples.
struct ExtremalCertificate {
  ExtremalData data;
  std::vector<CellRun> cells;                 ///< ascending, apart; a cell is its lowest node
  std::vector<std::uint8_t> codes;            ///< a listed cell
  std::vector<ExtremalDirection> directions;  ///< w, a listed cell that is not open
  std::vector<ExtremalDirection> gradients;   ///< a, a regular cell
  std::vector<std::uint32_t> edges;           ///< dimension * node + axis; ascending
  std::vector<std::uint8_t> trees;            ///< of `edges`, in preorder
  std::vector<ExtremalDirection> leaves;      ///< w, a leaf
  std::vector<std::uint8_t> types;            ///< of critical edges, ascending
  std::vector<std::uint8_t> pairings;         ///< of ambiguous faces, ascending
  std::vector<std::array<std::uint16_t, 3>> vertices;  ///< place in the cell, in 65536ths
  std::vector<std::uint16_t>
      fan_points;  ///< place on extremal edges with a polygon; only if trimmed
  std::uint32_t odd_faces = 0;
  ExtremalValences valences;
  std::vector<ExtremalComponent> components;
};

}  // namespace crest::certify
