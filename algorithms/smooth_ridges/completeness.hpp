// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Completeness and one sheet, which theorem 8 (certify/ridges_smooth/SPEC.md) needs besides charts:
// the tree over the box which shows that every component of S = {F = 0} passes through a graph box,
// and faces over which there is nothing else of S.
//
// Cells are decided by double intervals: F by the mean value form F(c) + grad F(K) . (K - c), and
// by its plain value; a . grad F, b . grad F likewise with the Hessian. Left are cells around
// critical points of (a x b) . X on S, zeros of (F, a . grad F, b . grad F); Newton's method finds
// them, a graph box is put around each, as large as its conditions hold, and cells inside it are
// done.
#include <optional>
#include <string>
#include <vector>

#include "algorithms/smooth_ridges/graded_grid.hpp"
#include "algorithms/smooth_ridges/stop.hpp"

namespace crest::smooth_ridges {

/// The tree and its graph boxes; `vertex` of a box is set by place_vertices().
struct Cover {
  certify::Bytes tree;
  std::vector<certify::GraphBoxRecord> boxes;
  std::vector<Vec3> critical_points;  ///< on S, one in each box
  std::size_t cells = 0;              ///< that were looked at
};

/// Why the box could not be covered, and where.
struct CoverFailure {
  enum class Reason {
    boundary,   ///< F has a zero, or nearly so, on the box's boundary
    singular,   ///< F and grad F are nearly zero
    undecided,  ///< degenerate critical points, or the budget is spent
    stopped
  };
  Reason reason;
  Vec3 where;
  std::string text;  ///< one line
};

struct CoverResult {
  std::optional<Cover> cover;
  std::optional<CoverFailure> failure;  ///< if and only if there is no cover
};

/// Requires: an implicit surface. `budget`: cells.
CoverResult cover_box(const Surface& surface, std::size_t budget = 2000000, const Stop& stop = {});

/// Its points of S, each with half the side of its graph box: the surface is no finer there.
std::vector<FineSpot> known_points(const Cover& cover);

/// Gives each graph box the vertex well inside it nearest to its critical point; where there is
/// none the mesh is refined around that point first. Vertices stay when a mesh is refined on, so
/// this may be done once, early. Returns the number of the first box that stays without one (the
/// mesh lacks a component), or nothing.
std::optional<std::size_t> place_vertices(Cover& cover, Triangulation& mesh);

/// The axis of a face: that of the largest component of the sum of its normals.
std::uint8_t face_axis(const Triangulation& mesh, Index face);

struct OneSheet {
  std::vector<Index> faces;     ///< ascending, one a component
  std::optional<Index> failed;  ///< a face of a component where no face was found
  bool stopped = false;         ///< before it was looked for everywhere
};
/// Enclosures of the images of faces, as far as they are known: the rest are infinite.
using FaceImages = std::vector<std::array<kernel::Range, 3>>;

/// One face a component that satisfies "One sheet" with its face_axis(), no face with skip[f] != 0
/// among them (empty: no face is skipped). `images` (empty: not known) save their charts.
/// Requires: all charts hold.
/// Cost: a chart a face, and a bounding box test a face and candidate.
OneSheet one_sheet(const Surface& surface, const Triangulation& mesh,
                   const std::vector<std::uint8_t>& skip = {}, const FaceImages& images = {},
                   const Stop& stop = {});

}  // namespace crest::smooth_ridges
