// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The certificate of claim 7, modes-curves, as plain structs (SPEC.md).
#include <array>
#include <cstdint>
#include <vector>

namespace crest::certify {

inline constexpr std::uint32_t kModesCurves = 7, kModesCurvesVersion = 2;

/// A degenerate tensor inside a face: the only one whose weights of corners 0 and 1 (they and the
/// third sum to 1) lie in these intervals.
struct DegeneratePoint {
  std::uint32_t face;               ///< place in `faces`
  std::int8_t type;                 ///< +1 linear, -1 planar
  std::array<double, 2> low, high;  ///< low <= high; may reach outside the face
};

/// Two points of a tetrahedron's faces, joined by a curve inside it.
struct DegenerateArc {
  std::uint32_t tet;
  std::array<std::uint32_t, 2> points;  ///< places in `points`, ascending
};

struct CurveCounts {
  std::uint32_t open = 0, closed = 0;  ///< curves that touch no special place
  std::uint32_t touched = 0;           ///< components of the rest that do
};

/// Claim modes-curves: where a piecewise linear tensor field has mode 1 or -1.
struct ModesCurvesCertificate {
  std::vector<std::array<double, 3>> points;       ///< V
  std::vector<std::array<std::uint32_t, 4>> tets;  ///< C
  std::vector<std::array<double, 6>> tensors;      ///< V: xx yy zz xy yz xz
  std::vector<std::array<std::uint32_t, 3>>
      faces;                                 ///< with points; corners ascending, all ascending
  std::vector<DegeneratePoint> face_points;  ///< by face
  std::vector<DegenerateArc> arcs;           ///< by tetrahedron, then points
  std::vector<std::array<std::uint32_t, 3>> special_faces;  ///< nothing is claimed there
  std::vector<std::uint32_t> special_tets;
  std::vector<std::array<std::uint32_t, 2>>
      degenerate_edges{};  ///< every tensor is degenerate there
  std::vector<std::array<std::uint32_t, 3>>
      plane_faces{};  ///< special faces whose two conics have a line in common
  CurveCounts linear, planar;
};

}  // namespace crest::certify
