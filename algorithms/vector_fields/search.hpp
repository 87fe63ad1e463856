// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Looks for half-edge collapses that keep the skeleton. Only separatrices through the collapsed
// vertex' star can change: they are followed anew to their ends, in plain doubles.
#include <algorithm>

#include "algorithms/vector_fields/analysis.hpp"
#include "algorithms/vector_fields/arrivals.hpp"
#include "algorithms/vector_fields/collapse_mesh.hpp"
#include "algorithms/vector_fields/compression_result.hpp"

namespace crest::vector_fields {

/// A separatrix of the mesh at hand.
struct SearchLine {
  Start start;
  Index ordinal = kNone;  ///< of the boundary edge at which it starts
  EndKind end = EndKind::undecided;
  Index target = 0;
  bool ordered = false;            ///< its place among the arrivals at its end is known
  std::optional<Step> first = {};  ///< as long as its triangle stays
  std::vector<Step> steps;
};

/// What of the input has to stay.
struct Kept {
  std::vector<bool> zeros, lines;
  bool all() const {
    return std::find(zeros.begin(), zeros.end(), false) == zeros.end() &&
           std::find(lines.begin(), lines.end(), false) == lines.end();
  }
};

/// A closed orbit: a chain of sides around it, in each a segment; the first one's lines return
/// strictly inside it.
struct SearchOrbit {
  bool forward = true;
  std::vector<HalfEdge> exits;
  std::vector<double> low, high;   ///< one more than exits: of the return
  std::vector<Index> around = {};  ///< zeros and loops that it runs around
};

/// A zero inside a triangle.
struct SearchZero {
  ZeroKind kind = ZeroKind::saddle;
  Index triangle = kNone;  ///< kNone: gone, or not inside a triangle
  bool moved = false;
  bool kept = true;
  std::optional<TrapShape> trap = {};
};

/// The separatrices on a mesh that changes.
class SearchState {
 public:
  /// pinned: separatrices all of whose triangles stay. Requires: `input` and `kept` outlive the
  /// state.
  SearchState(const Analysis& input, const std::vector<bool>& pinned, const Kept& kept);

  bool frozen(Index t) const { return frozen_[t] != 0; }
  Index line_count() const { return static_cast<Index>(lines.size()); }
  /// The triangle of a step; after the last one that of the zero it ends at, or none.
  Index triangle_of(const SearchLine& line, std::size_t step) const;
  /// Goes on from the last step (none: from the start) to an end; lost after so many.
  QuickEnd follow(SearchLine& line, std::size_t most, EndKind& end, Index& target);
  /// Around from the k-th segment on, made wider; whether it returns strictly inside.
  bool close(const SearchOrbit& orbit, std::size_t k, double wider, SearchOrbit& result) const;
  /// Its lines stand in the same order as before.
  enum class Order : std::uint8_t { same, other, open };
  Order order_at(Index end);
  /// Numbers of the ends of lines in `arrivals`: regions, zeros, both sides of orbits.
  Index end_of(Index line) const;
  /// Zeros and loops around which an orbit runs, as a list.
  std::vector<Index> enclosed(const SearchOrbit& orbit) const;

  void place_zero(Index zero, const SearchZero& at);
  Vec2 place_of(Index zero) const;
  Vec2 place(const Step& step) const;

  CollapseMesh mesh;
  std::vector<SearchZero> zeros;
  std::vector<SearchLine> lines;
  std::vector<SearchOrbit> orbits;
  std::vector<Index> zero_in;                ///< of a triangle, or none
  std::vector<std::vector<Index>> passing;   ///< by triangle: lines, then orbits
  std::vector<std::vector<Index>> arrivals;  ///< lines in their order, by their ends
  std::uint64_t crossings = 0;
  std::size_t inherited = 0;

 private:
  void take_zeros();
  void take_orbits();
  void take_lines(const std::vector<bool>& pinned);
  void freeze_way(const Trace& trace);
  void note_passing();
  void note_arrivals();
  const TrapShape* trap_in(Index t, bool forward) const;
  std::optional<Index> orbit_entered(bool forward, const Step& step) const;
  std::optional<Index> wall_reached(bool forward, HalfEdge entry, double share) const;
  Index region_left(const Step& step, bool forward) const;
  std::optional<Arrival> arrival(Index line, Index end) const;
  bool cyclic(Index end) const;

  const Analysis& input_;
  const Kept& kept_;
  RegionSlots slots_;
  TriedPlaces tried_;
  std::vector<std::uint8_t> frozen_;  ///< triangles that stay; 2: with a wall
  std::vector<Vec2> loop_points_;     ///< one of each loop of the boundary
};

/// The steps of a corridor that was proven; none if a part of it is straight.
std::vector<Step> steps_of(const Domain& domain, const Trace& trace);

}  // namespace crest::vector_fields
