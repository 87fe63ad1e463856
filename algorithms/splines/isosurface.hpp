// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A level set of a quadratic spline as a mesh of proven topology: marching tetrahedra on a
// conforming bisection whose tetrahedra are all empty or simple.
//
// Signs: zero counts as +. A simplex is empty if its coefficients, less c, have one sign. A
// tetrahedron is simple if (i) each edge has a zero iff its ends' signs differ, (ii) on each face
// that is not empty the tangential gradient, (iii) in the tetrahedron the gradient has a positive
// product with its mean over the corners, at all corners. Theorem (certify/spline_isosurface):
// then for all small e > 0 the surface {s = c - e} and the mesh, with its vertices anywhere inside
// their edges, are isotopic by an isotopy that keeps every simplex.
#include <string>

#include "algorithms/splines/quadratic.hpp"
#include "kernel/geometry/index.hpp"

namespace crest::splines {

struct Isosurface {
  std::vector<Vec3> points;  ///< of the world, on s = c as far as doubles tell
  std::vector<Vec3> gradients;
  std::vector<kernel::Triangle> triangles;  ///< counter-clockwise seen from where s < c
  /// A vertex: the bracket of its place on its edge, in [0, 1] from the end that comes first by z,
  /// y, x.
  std::vector<std::array<double, 2>> brackets;
  /// Bisected tetrahedra, 24 cube + number, ascending, and their trees in preorder: 1 bisected, 0 a
  /// leaf.
  std::vector<std::uint32_t> bisected;
  std::vector<std::uint8_t> trees;

  /// The centres of leaves that are neither empty nor simple at the greatest depth, or after 16384
  /// bisections in one tetrahedron of the partition, or 65536 and four a tetrahedron in all.
  std::vector<Vec3> undecided;
  int depth = 0;
  std::int64_t euler_characteristic = 0;
  std::size_t components = 0, boundary_loops = 0;
  std::size_t coincident = 0;     ///< vertices at the place of an earlier one
  std::size_t exact_corners = 0;  ///< corners of leaves with s = c
};

/// Requires: c finite, 0 <= max_depth <= 54. Throws: kernel::InputError for more than 2^32 / 24
/// cubes or vertices. Guarantees: the same for any number of threads.
Isosurface extract_isosurface(const QuadraticSpline& spline, double c, int max_depth);

}  // namespace crest::splines
