// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Triangles of the pieces: their loops' polylines, shared with the cells next door, projected along
// the witness, triangulated and lifted to where the mode is right.
#include <set>
#include <span>
#include <unordered_map>
#include <unordered_set>

#include "algorithms/modes/cells.hpp"
#include "algorithms/modes/mode_function.hpp"
#include "algorithms/modes/mode_surface.hpp"
#include "algorithms/modes/planar_pieces.hpp"

namespace crest::modes {

class SurfaceBuilder {
 public:
  SurfaceBuilder(Faces& faces, const Level& level, Side side,
                 const std::vector<kernel::Vec3>& mesh_points,
                 const std::unordered_set<Index>& open_faces);

  /// Prepares the pieces of a leaf cell with closed facets. `orientation`: of the cell, corners in
  /// their order.
  void add_cell(Index number, const Cell& cell, int orientation, std::vector<Piece> pieces);
  /// The cone from a zero corner (or the fan from two) over the curve on the opposite face (the
  /// roots of the opposite edge): triangles with one or two mesh vertices.
  void add_cone(Index tet, Index apex, Index face);
  void add_fan(Index tet, Index zero_a, Index zero_b, Index edge);
  /// Before these: the face of a zero corner and this edge is that of an open cell.
  void leave_open(Index zero, Index edge) { open_spokes_.insert({zero, faces_.edge(edge).line}); }
  /// Refines polylines until projections are simple, and all until nothing is further than
  /// `deviation` (0: that does not matter) from the surface; triangulates.
  ModeSurface build(double deviation);
  /// Of polylines on the domain's boundary, after build().
  std::size_t boundary_segments() const { return boundary_segments_; }
  /// The inner points of the arcs' polylines, in the arcs' leaf faces, after build().
  std::unordered_map<Index, std::vector<std::array<double, 3>>> polylines() const;
  /// The vertices inside cells, by a cell's number: weights of its corners, after build().
  const std::unordered_map<Index, std::vector<std::array<double, 4>>>& inner() const {
    return inner_;
  }
  /// Whether the triangle's piece ends at an open cell, after build().
  bool touches_open(std::size_t triangle) const { return touches_[triangle] != 0; }

 private:
  using Barycentric = std::array<double, 4>;
  struct ArcPoint {
    double place;  ///< 0 at the arc's first root, 1 at its second
    std::array<double, 3> at;
    Index point = kNone;
  };
  struct ConeJob {
    Index tet, apex, arc;
  };
  struct Job {
    Index number;
    Cell cell;
    int orientation;
    Piece piece;
    int halvings;  ///< of all its loops' parts so far
    bool done;     ///< the triangulation stands
    PlanarPiece planar;
    std::vector<std::array<std::size_t, 3>> triangles;
  };
  /// Of polylines, by arc.
  using Parts = std::unordered_map<Index, std::set<std::size_t>>;
  struct Layout {
    PlanarPiece planar;
    std::vector<Barycentric> at;
    std::vector<Index> points;                         ///< of the surface
    std::vector<std::pair<Index, std::size_t>> parts;  ///< of arcs, from each point on
    std::array<std::size_t, 4> order{};                ///< the two kept coordinates, the two others
  };

  Barycentric in_cell(const Cell& cell, std::unordered_map<Index, Barycentric>& known,
                      Index vertex) const;
  std::array<double, 3> root_in_face(Index root, Index face) const;
  std::span<ArcPoint> inside(Index arc) {
    if (inside_of_[arc] == kNone) return {};
    return inside_[inside_of_[arc]];
  }
  ArcPoint middle(Index arc, std::size_t part);
  void refine(Index arc, const std::set<std::size_t>& parts);
  void bend(Index arc);
  void lay_out(const Job& job, Layout& layout);
  static Barycentric unfolded(const Layout& layout, const std::array<double, 2>& p);
  std::vector<std::size_t> missed(const Job& job, const Layout& layout,
                                  const PlanarPiece& planar) const;
  static void add_crossing(const Layout& layout, Parts& parts);
  static void add_all(const Layout& layout, Parts& parts);
  static void add_nearest(const Layout& layout, const PlanarPiece& planar,
                          const std::vector<std::size_t>& missed, Parts& parts);
  static void add_part(const Layout& layout, std::size_t point, std::size_t next, Parts& parts);
  void refine_all();
  kernel::Vec3 in_space(const Cell& cell, const Barycentric& b);
  void straighten(Index arc, double deviation);
  bool add_far_points(const Job& job, const Layout& layout, double deviation, PlanarPiece& planar);
  void refine_inside(Job& job, double deviation);
  void mesh(const Job& job);
  void mesh_piece(const Job& job);
  void mesh(const ConeJob& job);
  bool count_segments(Index arc);
  bool ends_open(Index zero, Index root) const;
  Index zero_point(Index vertex);
  Barycentric pulled(const Job& job, const Layout& layout, const Barycentric& b) const;
  void emit(const Job& job, Layout& layout, const PlanarPiece& planar,
            const std::vector<std::array<std::size_t, 3>>& triangles, bool lift);
  Index add_point(const kernel::Vec3& p, const Symmetric& t);
  Index root_point(Index root);
  Index arc_point(Index arc, std::size_t k);
  const kernel::Vec3& place(Index vertex);
  template <std::size_t N>
  std::array<double, N> lifted(const std::array<Index, N>& corners, std::array<double, N> base,
                               const std::array<double, N>& w, bool* crosses = nullptr) const;

  Faces& faces_;
  Level level_;
  Side side_;
  ModeFunction function_;
  std::vector<kernel::Vec3> places_;
  const std::unordered_set<Index>& open_faces_;
  std::set<std::array<Index, 2>> open_spokes_;  ///< zero corner, line
  std::vector<std::size_t> open_fans_;          ///< triangles
  std::vector<char> touches_;                   ///< triangles
  std::vector<Job> jobs_;
  std::vector<ConeJob> cones_;
  std::size_t boundary_segments_ = 0;
  std::vector<Index> inside_of_;  ///< by arc: where its points are; kNone: it is a segment
  std::vector<std::vector<ArcPoint>> inside_;
  std::unordered_map<Index, std::vector<Barycentric>> inner_;
  std::vector<Index> root_points_;  ///< by root
  std::unordered_map<Index, Index> zero_points_;
  Layout layout_;  ///< of the job at hand
  ModeSurface surface_;
};

}  // namespace crest::modes
