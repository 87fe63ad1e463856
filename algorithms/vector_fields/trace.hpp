// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Separatrices: where each starts, the triangles it crosses, its proven end.
#include <span>
#include <unordered_map>

#include "algorithms/vector_fields/barrier.hpp"
#include "algorithms/vector_fields/boundary.hpp"
#include "algorithms/vector_fields/skeleton_result.hpp"
#include "algorithms/vector_fields/zeros.hpp"

namespace crest::vector_fields {

/// Sums of doubles, which hold numbers of more bits exactly.
using Expansion = std::vector<double>;

enum class StartKind : std::uint8_t { ray, fan_ray, point, along, none };

/// What a separatrix starts from, whatever the precision.
struct Start {
  StartKind kind = StartKind::none;
  bool forward = true;
  bool from_switch_point = false;
  bool from_vertex = false;  ///< a witness
  Index origin = 0;          ///< zero, switch point or vertex
  /// ray of a saddle in a triangle: 3 t; fan_ray: the side that it meets. point: the half-edge that
  /// leaves the vertex with the line at its left. along: the side at which it starts.
  HalfEdge place = kNone;
  int sense = 1;     ///< ray: which of the two; along: 1 towards the head, -1 towards the tail
  int at = 0;        ///< along: 0 inside the side, -1 at its tail, 1 at its head
  double share = 0;  ///< fan_ray: where on the side, nearly; 0 at its tail, 1 at its head
  /// Where the line is straight at first, its direction, and a half-edge that leaves its vertex.
  std::optional<Vec2> direction = {};
  HalfEdge vertex = kNone;
};

/// The first part of a line, straight; through so many triangles or along so many edges.
struct StraightPart {
  Vec2 direction;
  HalfEdge vertex = kNone;
  Index elements = 0;
  std::vector<Index> triangles = {};  ///< all that it meets, some several times
};

/// Of corridors in doubles.
inline constexpr BarrierSetting kDoubles{53, 36, 12, 0};

/// A gate that a line went through: its ends in doubles, which are strictly inside a segment of
/// doubles only if they are so before rounding.
struct PassedGate {
  HalfEdge side = kNone;
  Index turns = 0;  ///< before it
  double left = 0, right = 0;
  double width = 0;
};

/// One separatrix as it was proven.
struct Trace {
  Start start;
  BarrierSetting setting;
  std::optional<StraightPart> straight = {};
  Start leg;  ///< how the corridor starts: as the line, or where it stops being straight
  HalfEdge first_side = kNone;  ///< ray: the side by which the zero's triangle is left
  Expansion first, second;      ///< as a certificate's leg has them
  Expansion second_height;      ///< along: of the inner start
  std::vector<std::uint8_t> turns;
  std::vector<std::pair<Index, BarrierSetting>> special;  ///< cells with other settings
  EndKind end = EndKind::undecided;
  Index target = 0;
  OpenReason reason = OpenReason::none;
  bool creeps = false;  ///< undecided next to a zero corner, where it may end
  double width = 0;
  std::vector<Vec2> line;
  std::vector<PassedGate> gates;  ///< a point of the line each, the last ones
};

/// An annulus that lines enter through a gate and return to.
struct Annulus {
  BarrierSetting setting;
  bool forward = true;
  HalfEdge side = kNone;
  double left = 0, right = 0;
  double back_left = 0, back_right = 0;  ///< where its lines return
  std::vector<std::uint8_t> turns;
  std::vector<std::pair<Index, BarrierSetting>> special;
  std::vector<Vec2> line;
};

/// A side's segment, in shares from its tail, that may be an annulus' gate.
struct AnnulusDoor {
  bool forward = true;
  HalfEdge side = kNone;
  double low = 0, high = 0;
};

struct Trap {
  Index zero;
  TrapShape shape;
};

/// Around a sink (of the field turned round: a source) inside a triangle, in the frame of corner 0.
std::optional<TrapShape> ellipse_in(const TriangleFrame<double>& frame, bool attracting);

/// A polygon around a zero at an inner vertex that lines enter only: shares of the fan's edges at
/// which its corners lie. Nothing if there is none of this kind, or the triangles' traces have not
/// one sign. Found in doubles; a certificate's checker proves it.
struct TrapPolygon {
  std::vector<HalfEdge> leaving;  ///< the vertex, counter-clockwise
  std::vector<double> shares;
  bool attracting = true;
};
std::optional<TrapPolygon> polygon_around(const Domain& domain, const ZeroComponent& zero);

/// Around sinks and sources, by triangle.
std::unordered_map<Index, Trap> make_traps(const Domain& domain,
                                           const std::vector<ZeroComponent>& zeros);

struct Surroundings {
  const Domain& domain;
  const Boundary& boundary;
  const std::vector<ZeroComponent>& zeros;
  const std::unordered_map<Index, Trap>& traps;

  /// What lines forward, or backward, only enter in a triangle; or none.
  const TrapShape* trap_in(Index t, bool forward) const {
    const auto at = traps.find(t);
    return at != traps.end() && at->second.shape.attracting == forward ? &at->second.shape
                                                                       : nullptr;
  }
};

/// Annuli while one line is followed.
struct AnnulusNotes {
  std::span<const Annulus> known;
  std::vector<Annulus> found = {};
  std::vector<PassedGate> asked = {};  ///< where a known one would have stopped the search

  std::size_t size() const { return known.size() + found.size(); }
  const Annulus& operator[](std::size_t i) const {
    return i < known.size() ? known[i] : found[i - known.size()];
  }
};

/// Follows a start at rising precision: all attempts, of which the last one counts.
std::vector<Trace> trace(const Surroundings& around, const Start& start, AnnulusNotes& notes);

/// Follows all starts, on several threads; annuli that are found join the others. Each line ends
/// where it first enters one of them. Guarantees: the same result for any number of threads.
std::vector<Trace> trace_all(const Surroundings& around, const std::vector<Start>& starts,
                             std::vector<Annulus>& annuli);

}  // namespace crest::vector_fields
