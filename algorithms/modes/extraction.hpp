// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// All trees of one level over a mesh: what the surface and the certificate are made from.
#include <unordered_map>
#include <unordered_set>

#include "algorithms/modes/cells.hpp"
#include "algorithms/modes/edge_table.hpp"
#include "algorithms/modes/modes.hpp"
#include "algorithms/modes/pieces.hpp"
#include "algorithms/modes/surface_builder.hpp"

namespace crest::modes {

/// A tetrahedron with zero corners, ascending, and others. Open: the face opposite to its one zero
/// corner is not decided, so nothing is said of what is inside.
struct Cone {
  Index tet;
  std::vector<Index> zeros, others;
  bool open = false;
};

class Extraction {
 public:
  /// Decides all tetrahedra. The field must outlive this.
  Extraction(const ModeField& field, const Level& level, const ModeOptions& options,
             const Workers* workers);
  ModeResult result();

  struct Tree {
    Index tet, cell;
  };
  const std::vector<Tree>& trees() const { return trees_; }
  const std::vector<Cone>& cones() const { return cones_; }
  const Cells& cells() const { return cells_; }
  Faces& faces() { return faces_; }
  /// By face of the mesh: its number among the trees'; kNone: it has none.
  const std::vector<Index>& mesh_faces() const { return mesh_faces_; }
  /// kNone: no tree has it.
  Index edge_between(Index a, Index b) const { return mesh_edges_.find(a, b); }
  /// The tree's root on the face opposite a cone's zero corner. Requires: it has one.
  Index face_of(const Cone& cone) const { return mesh_faces_[opposite_face(cone)]; }
  /// The inner points of an arc's polyline, after result().
  std::span<const std::array<double, 3>> polyline(Index arc) const;
  /// The vertices of a side inside a cell, as weights of its corners, after result().
  std::span<const std::array<double, 4>> inner(Index cell, Side side) const;
  int scale() const { return scale_; }
  const Level& level() const { return level_; }
  const ModeField& field() const { return field_; }

 private:
  void decide_all(const Workers* workers);
  Index face(Index mesh_face);
  Index edge(Index a, Index b);
  void close_cones();
  void list_open();
  int orientation(const Cell& cell) const;
  Index opposite_face(const Cone& cone) const;
  void add_pieces(SurfaceBuilder& builder, Side side);
  ModeSurface surface(Side side, std::size_t cone_rims);
  void add_leaves(SurfaceBuilder& builder, Side side, Index cell, int orientation);
  std::size_t face_loops(Side side) const;
  std::size_t cone_rims(Side side);
  Perturbed perturbed(Side side);

  const ModeField& field_;
  int scale_;
  Level level_;
  Limits limits_;
  double deviation_;
  Vertices vertices_;
  Lines lines_;
  Faces faces_;
  Cells cells_;
  std::vector<Tree> trees_;
  std::vector<Cone> cones_;
  std::vector<Index> mesh_faces_;
  EdgeTable mesh_edges_;
  ModeCounts counts_;
  std::vector<Index> open_;
  std::unordered_set<Index> open_faces_;  ///< leaves at open cells
  std::array<std::unordered_map<Index, std::vector<std::array<double, 3>>>, 3>
      polylines_;  ///< of the minus, the neutral, the plus side, by arc
  std::array<std::unordered_map<Index, std::vector<std::array<double, 4>>>, 3>
      inner_;  ///< the same, by cell
};

}  // namespace crest::modes
