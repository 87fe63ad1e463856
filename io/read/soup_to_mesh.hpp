// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// From a soup to the surface in it.
#include <array>
#include <string>
#include <vector>

#include "io/formats/soup.hpp"
#include "io/read/mesh_reader.hpp"

namespace crest::io {

/// The triangles among a soup's cells; faces are numbered by themselves.
struct SoupFaces {
  std::vector<std::size_t> cells;  ///< of the soup
  /// The nodes in the middle of the sides (0 1), (1 2), (2 0), or kNone thrice for a linear face;
  /// empty: all are linear.
  std::vector<std::array<kernel::Index, 3>> midside;
  std::size_t thin = 0;  ///< points and lines, which are left out

  std::int64_t tag(const Soup& soup, std::size_t f) const { return soup.cell_tag(cells[f]); }
  void warn(std::vector<std::string>& warnings) const;
};

/// Throws: kernel::InputError for a cell that is neither a triangle, linear or quadratic, nor
/// thin, or has a wrong number of nodes or a mid-side node that does not exist.
SoupFaces faces_of(const Soup& soup);

/// The faces' corners. Throws: kernel::InputError unless there are faces, each has three distinct
/// corners and these exist, and all points are finite.
std::vector<kernel::Triangle> proper_corners(const Soup& soup, const SoupFaces& faces);

/// Throws: kernel::InputError naming an edge in three faces, a vertex with two fans or a face that
/// is there twice. Requires: `corners` of proper_corners.
void require_manifold(const Soup& soup, const SoupFaces& faces,
                      const std::vector<kernel::Triangle>& corners);

/// The points that are corners of faces, ascending: the vertices of mesh_of_soup.
/// Throws: as faces_of and proper_corners.
std::vector<kernel::Index> used_points(const Soup& soup);

/// The manifold in the soup, oriented. Throws: kernel::InputError naming the element that prevents
/// one. Cost: O(V + F) for bounded valences.
MeshFile mesh_of_soup(const Soup& soup);

}  // namespace crest::io
