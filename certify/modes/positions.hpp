// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Positions of pieces: polygons that are simple and nested across w (SPEC.md, theorem 16).
#include "certify/modes/cells.hpp"

namespace crest::certify::modes {

/// Whether no tetrahedron is flat and two with a common face are on its two sides. Exact.
/// Requires: build_domain(c).
bool is_embedded(const ModesCertificate& c, const Domain& domain);

struct PlacedPieces {
  u32 placed = 0, not_placed = 0;
};

class Positions {
 public:
  /// Throws Reject unless the lists of positions fit those of roots and arcs, and each position is
  /// where it may be.
  explicit Positions(const LevelContext& context);

  /// Whether there are any.
  bool stated() const { return !first_point_.empty(); }
  /// Of an arc, from its first root on. Requires: there are positions.
  std::span<const std::array<double, 2>> points_of(u32 arc) const {
    return std::span(context_.stated.points)
        .subspan(first_point_[arc], first_point_[arc + 1] - first_point_[arc]);
  }
  /// The pieces of a cell with a witness. Requires: its arcs are proven.
  PlacedPieces place_cell(const Cell& cell, const CellPieces& pieces) const;
  /// The cones over a face of the complex.
  PlacedPieces place_cones(u32 face) const;

 private:
  const LevelContext& context_;
  std::vector<std::size_t> first_point_;  ///< of each arc
};

}  // namespace crest::certify::modes
