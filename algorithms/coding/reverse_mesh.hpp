// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Triangles glued on in the reverse of the order in which strips conquered them, one triangle an
// operation (paper 001, algorithm 4.3 without its special cases; docs/cmc-format.md, "Gluing").
#include <vector>

#include "algorithms/coding/connectivity.hpp"

namespace crest::coding {

/// What the last triangle of a strip is glued to: the letters of a tree's nodes.
enum class NodeType : std::uint8_t { leaf, left, right, both };

/// Pieces of surface, their boundaries as loops of slots, and the stack of the pieces' gates. A new
/// triangle is (a, b, c): its gate runs from a to b, its left edge from b to c, its right one from c
/// to a.
/// Throws: StreamError for what glues nothing or makes a loop of fewer than three edges or a vertex
///   of fewer than three; that two vertices have two edges is not noticed.
class ReverseMesh {
 public:
  /// A boundary edge from a vertex to the next slot's.
  struct Slot {
    Index vertex, next, previous;
    Index triangles;  ///< of the vertex, those decoded so far between its two boundary edges; 0: no
                      ///< longer on the boundary
  };
  explicit ReverseMesh(Index max_faces) : max_faces_(max_faces) {}

  const std::vector<Slot>& slots() const { return slots_; }
  std::size_t depth() const { return gates_.size(); }
  /// The gates pushed last: 0 the last one.
  Index gate(std::size_t below) const { return gates_[gates_.size() - 1 - below]; }
  const std::vector<Triangle>& faces() const { return faces_; }

  /// Single triangles and the last one of a strip: gates are popped, the new one is pushed.
  void add_leaf();
  void add_left();
  void add_right();
  void add_both();
  /// Instead of add_both(): the right edge meets a slot of the boundary.
  void add_split(Index slot);
  /// The triangle before, which its strip left through the edge at the gate on top.
  void close(bool left);
  /// The triangle that closes the piece below `below` others, whose boundary has three edges.
  void fill(std::size_t below);

  /// Faces with vertices numbered from 0 by their first appearance as a vertex of this class.
  std::vector<Triangle> take_faces(Index& vertices);

 private:
  Index pop();
  Index add_slot(Index vertex) {
    slots_.push_back({vertex, 0, 0, 1});
    return static_cast<Index>(slots_.size() - 1);
  }
  void link(Index a, Index b) {
    slots_[a].next = b;
    slots_[b].previous = a;
  }
  void emit(Index a, Index b, Index c);
  void glue(Index left, Index right);
  void require_loop(Index s) const;

  std::vector<Slot> slots_;
  std::vector<Index> gates_;
  std::vector<Triangle> faces_;
  std::vector<std::pair<Index, Index>> joined_;  ///< vertices that became one
  Index vertices_ = 0, max_faces_;
};

}  // namespace crest::coding
