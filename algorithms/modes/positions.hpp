// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Which pieces of a record have polylines that project along their witness to simple, nested
// polygons (claim 6, theorem 16). In doubles with room to spare: what is not clearly so is not
// counted.
#include <vector>

#include "algorithms/modes/extraction.hpp"
#include "certify/modes/records.hpp"

namespace crest::modes {

/// Where the record has an edge's places, an arc's points.
struct RecordedPositions {
  std::vector<Index> places;  ///< of a leaf edge: the first; kNone: it has none
  struct Points {
    std::size_t first = 0, count = 0;
  };
  std::vector<Points> points;  ///< by arc
};

/// Sets the counts of the level's pieces that are placed, and that are not.
void count_placed(Extraction& extraction, const RecordedPositions& positions,
                  certify::ModeLevel& record);

/// Whether doubles show the mode at a point of a simplex, given by its corners' weights, to be near
/// the signed level (theorem 16 (ii)).
template <std::size_t n>
bool is_near(const Vertices& vertices, const std::array<Index, n>& corners,
             const std::array<double, n>& weights, double level);

/// Whether no tetrahedron is flat and two with a common face are on its two sides.
bool is_embedded(const kernel::TetMesh& mesh);

}  // namespace crest::modes
