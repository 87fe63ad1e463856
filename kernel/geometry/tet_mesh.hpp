// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Tetrahedral meshes as complexes: faces shared by the tetrahedra around them.
#include <array>
#include <vector>

#include "kernel/arithmetic/vec3.hpp"
#include "kernel/geometry/index.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::kernel {

class TetMesh {
 public:
  static constexpr Index kNoTet = ~Index{0};
  using Tet = std::array<Index, 4>;
  struct Face {
    std::array<Index, 3> corners;  ///< ascending
    std::array<Index, 2> tets;     ///< ascending; the second is kNoTet on the boundary
  };

  TetMesh() = default;
  /// Throws: InputError naming a tetrahedron with a repeated corner, one that is there twice, a
  /// face of three tetrahedra. Positions are not looked at. Cost: O(C log C).
  TetMesh(std::vector<Vec3> points, std::vector<Tet> tets);

  const std::vector<Vec3>& points() const { return points_; }
  /// Corners as given.
  const std::vector<Tet>& tets() const { return tets_; }
  const std::vector<Face>& faces() const { return faces_; }
  /// Corners ascending.
  Tet sorted(Index tet) const;
  /// Face i lies opposite the i-th of the sorted corners.
  const std::array<Index, 4>& faces_of(Index tet) const { return faces_of_[tet]; }
  /// The sign of the volume, corners as given: 1 where corner 3 sees 0, 1, 2 anticlockwise. Exact.
  int orientation(Index tet) const;

 private:
  std::vector<Vec3> points_;
  std::vector<Tet> tets_;
  std::vector<Face> faces_;
  std::vector<std::array<Index, 4>> faces_of_;
};

}  // namespace crest::kernel
