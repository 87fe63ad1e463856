// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Degenerate curves of a piecewise linear tensor field: what the computation returns, io writes and
// a certificate claims. (Apart from degenerate_curves.hpp so that readers of results see no
// rationals.)
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "kernel/arithmetic/vec3.hpp"

namespace crest::modes {

/// xx yy zz xy yz xz, VTK's order; its trace plays no part.
using Tensor = std::array<double, 6>;
using TetCorners = std::array<std::uint32_t, 4>;
using FaceCorners = std::array<std::uint32_t, 3>;  ///< ascending

/// mode 1: two equal lower eigenvalues; mode -1: two equal upper ones.
enum class DegenerateType : std::uint8_t { linear, planar };

/// Where a curve passes a face: T = s (v v^T - I/3) with s > 0 iff linear.
struct FacePoint {
  std::uint32_t face;  ///< of DegenerateCurves::faces
  DegenerateType type;
  std::array<double, 3> weights;  ///< barycentric in the face
  std::array<double, 2> low,
      high;                ///< enclosures of the first two, no other point of the face there
  kernel::Vec3 direction;  ///< v, with unit norm
  kernel::Vec3 point;
};

enum class SpecialReason : std::uint8_t {
  zero_tensor,     ///< T vanishes at a corner
  dependent,       ///< dependent deviators: a constant field among them
  zero_quartic,    ///< P and Q share a component: a curve may lie in the face (symmetry planes)
  multiple_point,  ///< a multiple degenerate point, not outside
  on_rim,          ///< a degenerate point on an edge or at a vertex
  line_pair,       ///< of a tet: det Tbar = 0, its conic is two lines
};

/// A face whose degenerate tensors are not isolated points inside it.
struct SpecialFace {
  FaceCorners face;
  SpecialReason reason;
};
struct SpecialTet {
  std::uint32_t tet;
  SpecialReason reason;
};

/// A connected piece, from face point to face point; its polyline has points inside tets, too.
struct DegenerateCurve {
  DegenerateType type;
  bool closed = false;
  bool at_special = false;                 ///< an end is on a face of a special or undecided tet
  std::vector<std::uint32_t> face_points;  ///< in order; a closed curve's first is not repeated
  std::vector<kernel::Vec3> polyline;
  double length = 0;
};

/// An arc of a tet's conic between two of its face points.
struct DegenerateArc {
  std::uint32_t tet;
  std::array<std::uint32_t, 2> ends;
};

struct DegenerateCurves {
  std::vector<FaceCorners> faces;  ///< those with face points
  std::vector<FacePoint> points;
  std::vector<DegenerateArc> arcs;
  std::vector<DegenerateCurve> curves;
  std::vector<SpecialFace> special_faces;
  std::vector<SpecialTet> special_tets;
  /// Of special faces, with degenerate tensors all along; ascending. Curves, but not traced.
  std::vector<std::array<std::uint32_t, 2>> degenerate_edges;
  std::vector<std::uint32_t> undecided;  ///< tets; none of their arcs is listed
  /// Decided, but not always by claim 7's checker: faces whose conics have multiple common points
  /// that are not in the face.
  std::vector<FaceCorners> multiple_faces;

  /// Where the work went.
  struct Counts {
    std::size_t rejected_tets = 0, rejected_faces = 0, triage_faces = 0, exact_faces = 0;
  } counts;
};

}  // namespace crest::modes
