// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Occluding edges, exactly: which edges are drawn, where their visibility changes, and how many
// faces are in front of each piece. Definitions and theorems: README.md.
#include <vector>

#include "algorithms/line_art/view.hpp"

namespace crest::line_art {

struct SightEvent {
  enum class Kind : std::uint8_t {
    crossing,  ///< an occluding edge passes in front
    piercing,  ///< the edge goes through a face
    contact    ///< a face that touches the edge begins or ends to be in front
  };
  Kind kind = Kind::crossing;
  Index partner = 0;  ///< edge (of Contours::edges), face of the scene
  int change = 0;     ///< of the faces in front; contact: of the touching ones among these
  kernel::EventPlace place;
};

/// Between consecutive places that differ in the limit.
struct Piece {
  double from = 0, to = 1;  ///< t of the ends, rounded
  Index in_front = 0;       ///< N: faces between it and the eye
  Index touching = 0;       ///< those that are there by perturbation only
  /// N0 = 0.
  bool drawn() const { return in_front == touching; }
};

struct ContourEdge {
  Index a, b;           ///< vertices of the scene, a < b
  Index left, right;    ///< L, R: faces with [e, a, b, .] > 0, < 0
  bool occluding;       ///< L != R
  bool rim;             ///< edge-on: L = R only by perturbation
  bool boundary;        ///< one face
  bool crease;          ///< not occluding nor a rim, sharp
  bool end_on = false;  ///< a point of the picture: its pieces are not drawn
  Index first_piece = 0, pieces = 0;
  Index first_event = 0, events = 0;  ///< ascending by place
  Index start = 0;                    ///< faces in front at a, passing towards b
};

struct ContourCounts {
  std::size_t edges = 0, creases = 0, crossings = 0, piercings = 0, cusps = 0, pieces = 0,
              visible = 0, hidden = 0, edge_on = 0, contact = 0;
};

struct Contours {
  std::vector<ContourEdge> edges;  ///< ascending by (a, b)
  std::vector<Piece> pieces;
  std::vector<SightEvent> events;
  ContourCounts counts;  ///< crossings to hidden: of occluding edges alone
  kernel::SightCounts decisions;
};

struct ContourOptions {
  std::optional<double> crease = 60;  ///< degrees between normals; none: no creases
};

/// Guarantees: the same for any number of threads; the balance of faces in front holds on every
/// edge. Throws: std::logic_error if it does not (a bug).
/// Cost: linear in faces and events, for cells that hold a bounded number of each.
Contours find_contours(const Scene& scene, const View& view, const ContourOptions& options = {});

}  // namespace crest::line_art
