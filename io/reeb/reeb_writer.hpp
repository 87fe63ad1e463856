// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Reeb graphs, level lines and monotone tiles to files.
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "algorithms/reeb/contours.hpp"
#include "algorithms/reeb/reeb_graph.hpp"
#include "algorithms/reeb/tile_complex.hpp"

template <class T>
class vtkSmartPointer;
class vtkPolyData;
class vtkUnstructuredGrid;

namespace crest::io {

inline constexpr int kJoinTreeKind = 3, kSplitTreeKind = 4, kContourTreeKind = 5;

/// A merge tree: its arcs join nodes of the tile complex.
struct TreeLines {
  int kind;                                        ///< one of the three above
  std::vector<std::array<kernel::Index, 2>> arcs;  ///< lower, upper
};

struct LevelLines {
  double level;
  std::vector<reeb::Contour> contours;
};

/// What is known about one surface; refers to what the run computed.
struct ReebScene {
  const kernel::QuadraticMesh& mesh;
  const reeb::TileComplex& tiles;
  const std::vector<reeb::NodePlace>& places;  ///< of the tiles' nodes
  const reeb::ReebGraph& graph;
  /// For every node of the tiles the arc of the graph it lies on, or kNone.
  const std::vector<kernel::Index>& arc_of_node;
  const std::vector<kernel::Index>& arc_of_tile;  ///< empty: not wanted
  const std::vector<TreeLines>& trees;
  const std::vector<LevelLines>& levels;
  std::string data_digest;  ///< hex, of the run's certificate; may be empty
  std::span<const std::int64_t> face_numbers =
      {};  ///< what the file calls the faces; else by place
};

/// Writes .vtp or .vtu, by the extension in any case.
///
/// .vtp: first the graph's nodes as vertices, then polylines (arcs of the graph, level lines, merge
/// trees), then the tiles if arc_of_tile is given. An arc runs from its lower to its upper node
/// along the middles of the nodes on it.
///   points: value; node (number in the tile complex, -1 if none); type (0 minimum, 1 saddle,
///     2 maximum, -1 else); multiplicity and on_boundary of the graph's nodes, else 0.
///   cells: kind (0 node, 1 arc, 2 level line, 3 join tree, 4 split tree, 5 contour tree, 6 tile);
///     arc (of arcs and tiles, else -1); lower and upper (positions of the graph's nodes for arcs,
///     nodes of the tile complex for trees, else -1); face (of tiles, else -1); level (of level
///     lines, else 0). Faces are numbered as in the file.
/// .vtu: the tiles as triangles over all nodes of the tile complex.
///   points: value; kind (0 vertex, 1 line-critical, 2 face-critical); type as above; arc (-1
///   none). cells: face, and arc if arc_of_tile is given.
/// field, in both: data_digest.
/// Guarantees: the same bytes for the same scene; no half-written file.
/// Throws: kernel::InputError for another extension or a place that cannot be written.
void write_reeb(const std::string& path, const ReebScene& scene);

/// What the .vtp file holds.
vtkSmartPointer<vtkPolyData> reeb_poly_data(const ReebScene& scene);
/// What the .vtu file holds.
vtkSmartPointer<vtkUnstructuredGrid> reeb_tiles(const ReebScene& scene);

/// The arc's polyline from lower to upper node, a list for each arc: the nodes on it in at most
/// `parts` groups of successive ones, each replaced by its mean.
std::vector<std::vector<reeb::NodePlace>> arc_polylines(const ReebScene& scene,
                                                        std::size_t parts = 12);

}  // namespace crest::io
