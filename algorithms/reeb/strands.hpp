// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Strands: enough descending paths that every contour is crossed by one, and few enough that the
// Reeb graph follows from them alone.
//
// Every vertex designates, in each lower run of its link, the edge to the lowest vertex. A strand
// starts at a stop (a critical vertex; on demand others, too), goes down the designated edge of
// one lower run and on through vertices that are no stops, by their designated edges, to the next
// stop. Strands may meet on the way and then go on together.
// Every contour is crossed by a strand: between two stops the paths from the upper one stay inside
// the family of contours between them until they leave it at its lower end.
// A contour is a cyclic or linear sequence of strands. Those that go on together are neighbours in
// it, in the order in which they meet, so they can all be put in where the lowest of them ends:
// only stops change sequences.
#include <vector>

#include "algorithms/reeb/vertex_stars.hpp"

namespace crest::reeb {

/// A stop with the runs of its link: alternately lower and upper ones in the link's direction.
struct Stop {
  Index vertex;
  Index lower_begin;  ///< its lower runs, see StrandLists
  Index upper_begin;
  std::uint8_t closed;        ///< the link is a cycle
  std::uint8_t starts_lower;  ///< the first run is a lower one (always if closed, unless no such)
  std::uint8_t critical;
};

/// An upper run of a stop and the strands that end there, in the order in which a contour crosses
/// them that has larger values on its left, for an observer who sees the link turn to the left:
/// against the link's direction.
struct UpperRun {
  Index strand_begin;  ///< up to that of the next run
  Index least;         ///< the vertex of the run with the least number
};

struct StrandLists {
  std::vector<Stop> stops;          ///< ascending vertices; one more at the end for the ranges
  std::vector<Index> strand_above;  ///< for every lower run its strand
  std::vector<UpperRun> upper;      ///< one more at the end
  /// For every strand 1 if the directions of the links at its ends disagree along it.
  std::vector<std::uint8_t> turned;

  Index lower_count(Index stop) const {
    return stops[stop + 1].lower_begin - stops[stop].lower_begin;
  }
  Index upper_count(Index stop) const {
    return stops[stop + 1].upper_begin - stops[stop].upper_begin;
  }
};

/// Starts the cyclic link of v at the first vertex of a lower run, if it has runs of both kinds;
/// the runs are then met in the order in which its stop has them.
void rotate_to_lower_run(Link& link, std::span<const Index> rank, Index v);

/// Stops: the critical vertices and those `asked` for (a mark a vertex; empty: none).
/// Cost: O(n) time (plus sorting the strands that meet in one vertex), O(n) memory.
StrandLists find_strands(const OrderedComplex& complex, VertexStars& stars,
                         std::span<const std::uint8_t> asked);

}  // namespace crest::reeb
