// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Stream lines in plain doubles, a triangle at a time: to search, never to prove. Where rounding
// may matter they are lost.
#include <map>

#include "algorithms/vector_fields/barrier.hpp"
#include "algorithms/vector_fields/collapse_mesh.hpp"
#include "algorithms/vector_fields/trace.hpp"

namespace crest::vector_fields {

/// So near a side's end, in shares of it, a line is lost.
inline constexpr double kNearVertex = 0x1p-30;

/// A triangle is left through a half-edge of its own, at a share from its tail.
struct Step {
  HalfEdge exit = kNone;
  double share = 0;
};

enum class QuickEnd : std::uint8_t { crossed, trapped, lost };

/// Where corridors around lines were tried, by the corners of triangles: near those places the
/// answer is taken to be the same.
class TriedPlaces {
 public:
  bool provable(const CollapseMesh& mesh, bool forward, HalfEdge entry, double share,
                const TrapShape* trap);

 private:
  struct Place {
    double share;
    bool provable;
  };
  std::map<std::array<Index, 4>, std::vector<Place>> places_;  ///< the last number: forward
};

/// From a share of a side through its triangle; trap: an ellipse in it that lines only enter, or
/// none. Lines that creep are tried as corridors, too, if `tried` is given.
QuickEnd cross_quickly(const CollapseMesh& mesh, bool forward, HalfEdge entry, double share,
                       const TrapShape* trap, Step& step, TriedPlaces* tried);

/// Points of the line that enters a side at a share, through so many triangles.
std::vector<Vec2> points_along(const CollapseMesh& mesh, bool forward, HalfEdge entry, double share,
                               std::size_t triangles);
/// Whether a point lies in a polygon.
bool inside(const std::vector<Vec2>& polygon, const Vec2& x);

/// Whether a corridor around the line gets through the triangle, or into the trap.
bool provable(const CollapseMesh& mesh, bool forward, HalfEdge entry, double share,
              const TrapShape* trap);

/// Whether a chain of corridors leads from a side's segment, in shares of it, back into it.
bool closes(const CollapseMesh& mesh, const AnnulusDoor& door, const std::vector<HalfEdge>& exits);

/// How the line through a vertex goes on in the mesh as it is.
Start start_now(const CollapseMesh& mesh, Index vertex, bool forward);

/// The first step of a separatrix; `start.place` and `start.vertex` are half-edges of the mesh.
QuickEnd begin_quickly(const CollapseMesh& mesh, const Start& start, const TrapShape* trap,
                       Step& step);

}  // namespace crest::vector_fields
