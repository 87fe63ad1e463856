// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// An oriented triangle 2-manifold without places: which half-edges face each other. Faces of area
// zero are welcome here, TriangleMesh refuses them.
#include <span>
#include <vector>

#include "kernel/geometry/index.hpp"

namespace crest::kernel {

/// Half-edge h = 3 f + k runs from corner k of face f to corner (k + 1) % 3.
inline constexpr Index next_half(Index h) {
  return h % 3 == 2 ? h - 2 : h + 1;
}
inline constexpr Index previous_half(Index h) {
  return h % 3 == 0 ? h + 2 : h - 1;
}

/// Shapes: F faces with corners below V.
class CornerTable {
 public:
  CornerTable() = default;
  /// Guarantees: no face with a repeated vertex; every edge in at most two faces, oppositely
  ///   directed; no two faces with the same corners; every vertex has one fan of faces.
  /// Throws: InputError naming the element otherwise.
  /// Cost: O(V + F).
  CornerTable(Index vertices, std::span<const Triangle> faces);

  Index vertex_count() const { return static_cast<Index>(half_of_.size()); }
  Index face_count() const { return static_cast<Index>(opposite_.size() / 3); }
  /// The half-edge that runs the other way, or kNone on the boundary.
  Index opposite(Index h) const { return opposite_[h]; }
  /// A half-edge that starts at v: on the boundary the one whose opposite is missing.
  Index half_of(Index v) const { return half_of_[v]; }

 private:
  std::vector<Index> opposite_, half_of_;
};

}  // namespace crest::kernel
