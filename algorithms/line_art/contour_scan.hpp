// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// One drawn edge at a time: what changes the number of faces in front of it, and how many there
// are.
#include "algorithms/line_art/contours.hpp"

namespace crest::line_art {

/// On which side of every face the eye is.
struct FaceSides {
  std::vector<std::int8_t> sign;   ///< of [e, p, q, r] for the face's corners in their order
  std::vector<std::uint8_t> flat;  ///< 1: seen edge-on, the sign is the perturbation's
};

/// What all edges' scans share. Refers to all of it.
struct ScanScene {
  const Scene& scene;
  kernel::Sight sight;
  std::vector<PagePoint> seen;  ///< V
  FaceSides sides;
  std::vector<PageBox> face_boxes, edge_boxes;  ///< F; drawn edges
  CellFrame frame;
  CellLists faces, occluders;               ///< occluders: numbers of drawn edges
  std::vector<Index> around_begin, around;  ///< faces around vertices of drawn edges
  std::vector<ContourEdge> edges;

  ScanScene(const Scene& scene, const View& view, std::vector<ContourEdge> edges, FaceSides sides);
  std::span<const Index> around_vertex(Index v) const {
    return {around.data() + around_begin[v], around.data() + around_begin[v + 1]};
  }
};

/// Working memory of a thread and what it counts.
class EdgeScan {
 public:
  explicit EdgeScan(const ScanScene& shared) : s_(shared) {}

  /// far(v): faces without v between the eye and v.
  Index faces_before(Index v);
  /// loc(a, b): faces at a, not at b, that are in front of where ab begins.
  Index faces_at(Index a, Index b);
  /// The events of an edge in order, its pieces and start; far: of all vertices.
  void scan(Index edge, const std::vector<Index>& far);

  std::vector<SightEvent> events;  ///< of the edge scanned last
  std::vector<Piece> pieces;
  Index start = 0, finish = 0;  ///< faces in front at its ends, on the edge
  kernel::SightCounts counts;

 private:
  bool wedge_before(const kernel::Triangle& f, Index a, Index b);
  bool has(Index face, Index v) const;
  void find_crossings(Index edge);
  void find_piercings(Index edge);
  void find_contacts(Index edge);
  void add_contact(Index a, Index b, Index face);
  void make_pieces(Index a, Index b);

  const ScanScene& s_;
  std::vector<Index> found_, touching_;
  Index touching_start_ = 0;
};

}  // namespace crest::line_art
