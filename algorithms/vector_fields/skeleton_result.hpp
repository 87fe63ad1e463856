// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The topological skeleton of a plane vector field: what extract_skeleton() returns.
#include <array>
#include <map>
#include <optional>
#include <vector>

#include "algorithms/vector_fields/planar_field.hpp"

namespace crest::vector_fields {

enum class ZeroKind : std::uint8_t { saddle, source, sink, centre, higher_order, undecided };
enum class ZeroPlace : std::uint8_t { triangle, edge, vertex, line, region };

/// How many of each kind lie around a zero; of half fans those between rays.
struct Sectors {
  int hyperbolic = 0, elliptic = 0, parabolic = 0;
};

/// A connected component of the zero set.
struct CriticalPoint {
  ZeroKind kind = ZeroKind::higher_order;
  bool focus = false;        ///< a source or sink with complex eigenvalues
  std::optional<int> index;  ///< none at the boundary
  ZeroPlace where = ZeroPlace::triangle;
  Index simplex = 0;  ///< triangle, vertex, or 3 t + k of an edge; of others the least triangle
  Vec2 point{};
  std::optional<std::array<double, 4>> jacobian = {};  ///< xx xy yx yy, inside a triangle
  std::optional<Sectors> sectors = {};                 ///< at vertices and on edges
};

struct SwitchPoint {
  Index loop = 0;
  Vec2 point{};
  bool inside = false;  ///< the stream line through it touches the boundary from inside
  bool corner = false;  ///< at a vertex where the boundary turns, or a tangent run that ends at one
  bool inflow_after = false;  ///< along the loop, the domain at the left
  Index edge = 0;             ///< 3 t + k: the edge, or the one that leaves the run's first vertex
  bool at_vertex = false;
  bool tangent = false;  ///< v is tangent there
  Index last_edge = 0;   ///< at a vertex: the edge that arrives at the (last) one
  Index side = 0;        ///< the edge that holds the last sign before it
};

struct BoundaryLoop {
  std::optional<int> winding;  ///< none if a zero lies on it
  int turning = 0;             ///< 1: an outer loop, -1: around a hole
  int interior = 0, exterior = 0;
  int inflow = 0, outflow = 0, tangent = 0, zero = 0;  ///< maximal runs of each
  Index length = 0;                                    ///< edges
};

enum class EndKind : std::uint8_t {
  critical_point,
  boundary,
  closed_orbit,
  zero_flow,
  switch_point,
  undecided
};
enum class OpenReason : std::uint8_t { none, saddle_connection, vertex_hit, weak_focus, budget };

/// What a separatrix starts from and where it ends.
struct Separatrix {
  bool forward = true;
  bool from_switch_point = false;
  Index origin = 0;  ///< critical point or switch point, of witnesses a vertex
  EndKind end = EndKind::undecided;
  Index target = 0;  ///< critical point, region of the boundary, orbit
  OpenReason reason = OpenReason::none;
  int bits = 53;
  double width = 0;  ///< of the corridor where it ends
  Index crossings = 0;
  std::vector<Vec2> line;
};

/// An annulus that lines enter only (backward: leave only), and so a closed orbit at least.
struct ClosedOrbit {
  bool attracting = true;
  std::vector<Vec2> line;  ///< a polygon in the annulus
};

/// A part of a boundary edge with flow of one direction.
struct BoundaryPiece {
  Vec2 from, to;
  int flow = 0;  ///< 1: in, -1: out, 0: tangent or zero
};

struct SkeletonCounts {
  std::uint64_t crossings = 0;
  std::map<int, std::uint64_t> bits = {};  ///< separatrices by the precision that decided them
};

struct Skeleton {
  int euler_characteristic = 0;
  Index components = 0, zero_triangles = 0, zero_regions = 0, zero_edges = 0;
  std::vector<CriticalPoint> critical_points;
  std::vector<SwitchPoint> switch_points;  ///< by loops
  std::vector<BoundaryLoop> loops;
  /// Both sides of the index relation: indices of the components off the boundary, winding of the
  /// field around all triangles that meet none at the boundary.
  int index_sum = 0, winding_sum = 0;
  std::vector<Separatrix> separatrices;
  std::vector<Separatrix> witnesses;  ///< stream lines through vertices, where no separatrix ends
  std::vector<ClosedOrbit> orbits;
  std::vector<BoundaryPiece> boundary;  ///< along the loops
  SkeletonCounts counts;
};

}  // namespace crest::vector_fields
