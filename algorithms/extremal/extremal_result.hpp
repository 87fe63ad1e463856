// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Extremal curves and surfaces with all that is reported of them: the result that writers see.
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "kernel/arithmetic/vec3.hpp"
#include "kernel/geometry/index.hpp"

namespace crest::extremal {

/// Why an edge of the mesh (in 2D a vertex) has other than two polygons.
enum class Reason : std::uint8_t {
  discontinuity = 1,  ///< of n: round its face n cannot be oriented
  inflection = 2,     ///< of s along n
  trim = 3,           ///< the level of min-value or min-strength
  border = 4,         ///< of the data: outside, inactive or flat nodes
  undecided = 5,      ///< an edge of the grid that is listed
};

struct Feature {
  kernel::Index a, b;  ///< points; in 2D a = b
  Reason reason;
};

struct Component {
  std::size_t polygons = 0, vertices = 0;
  std::int64_t euler_characteristic = 0;
  std::size_t boundary_loops = 0;  ///< pieces of the rim; in 2D 0
  std::size_t ends = 0;            ///< in 2D: vertices with one segment
  bool orientable = true;          ///< across edges of valence 2
  double area = 0;                 ///< in 2D the length
  std::optional<bool> isotopic;    ///< theorem (b); empty: not stated (hessian)
  int critical_type = 1;           ///< 1: all its zeros are extremal
};

struct Counts {
  std::size_t nodes = 0, active_nodes = 0, flat_nodes = 0;
  std::size_t empty = 0, regular = 0, cone = 0, open = 0;  ///< cells
  std::size_t edges = 0;                                   ///< tested
  std::size_t critical_edges = 0, extremal_edges = 0, undecided_edges = 0, undecided_types = 0;
  std::size_t odd_faces = 0, junction_edges = 0, ambiguous_faces = 0, sheets_split = 0;
  std::array<std::size_t, 4>
      valence{};  ///< edges of the mesh (2D: vertices) by valence 1, 2, 3, 4+
  std::size_t odd_valence_unexplained = 0;
  std::vector<std::size_t>
      bisections;                  ///< edges of the grid by depth; those that a cell decides: 0
  std::size_t cone_tests = 0;      ///< of edges
  std::size_t leaves = 0;          ///< of the octree
  int depth = 0;                   ///< of the octree
  std::size_t points_dropped = 0;  ///< zero normals
};

/// An edge of the grid where nothing is proven.
struct UndecidedEdge {
  kernel::Vec3 a, b;
  bool type = false;  ///< its flag is proven, the type of its zeros is not
};

struct Result {
  int dimension = 3;
  double h = 0;  ///< the paper's: sqrt 2 sigma in world units, or the radius
  std::vector<kernel::Vec3> points;
  std::vector<kernel::Vec3> normals;  ///< n at the points, unit vectors up to sign
  /// Polygon p has the points corners[first[p]] .. corners[first[p + 1] - 1]; in 2D segments.
  std::vector<kernel::Index> first{0}, corners;
  // A polygon's:
  std::vector<std::uint8_t> critical_type;  ///< 1 extremal, 0 merely critical
  std::vector<kernel::Index> component;
  std::vector<double> strength, s, plateness;  ///< s_nn, s, lambda1 / (lambda1 + lambda2)
  std::vector<Feature> features;               ///< every edge of valence other than 2
  std::vector<Component> components;           ///< by their first polygon
  std::vector<UndecidedEdge> undecided;        ///< by edge
  Counts counts;
  double max_residual = 0;  ///< largest |g / s_nn| left at a point, in the smallest spacing

  std::size_t polygons() const { return first.size() - 1; }
};

}  // namespace crest::extremal
