// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The trees of edges and faces of one level. A cut is a property of its edge alone: the edge with
// the largest angle between its ends' tensors is cut where that angle is halved, to 64ths; so both
// tetrahedra at a face cut it in the same way. A leaf face is rejected, or the curves in it are
// graphs along its witness, each an arc that joins two roots on its edges.
#include <span>
#include <vector>

#include "algorithms/modes/cell_test.hpp"
#include "algorithms/modes/lines.hpp"

namespace crest::modes {

inline constexpr Index kNone = ~Index{0};

struct Edge {
  Index first, second, line;
  kernel::Dyadic begin, end;  ///< of the line
  double from, to;            ///< the same, rounded down
  double measure;             ///< signed squared cosine of the angle between the ends' tensors
  Index middle = kNone;       ///< the vertex that cuts it
  Index part[2] = {kNone, kNone};
  Index first_root = kNone, root_count = 0;  ///< of the line's; kNone: not counted yet
};

enum class State : std::uint8_t { unknown, asked, rejected, graph, open };

struct Face {
  std::array<Index, 3> corners;
  std::array<Index, 3> edges;  ///< edge k joins corners k and k + 1 mod 3
  State state = State::unknown;
  Index parent = kNone;
  Index whole = kNone;     ///< the root of its tree
  Index account = 0;       ///< where its tests are counted
  std::int8_t split = -1;  ///< the edge that is cut
  std::uint8_t depth = 0;
  bool closed = false;    ///< all leaves below are rejected or graphs
  bool boundary = false;  ///< of the domain; of a tree's root
  Index inner = kNone;    ///< edge from the opposite corner to the new vertex
  Index part[2] = {kNone, kNone};
  Witness<2> witness{};
  Index first_arc = 0, arc_count = 0;
};

/// Two roots of one side joined in a leaf face.
struct Arc {
  Index face;
  std::array<Index, 2> roots;
  std::array<std::uint8_t, 2> numbers;  ///< along the face's edges 0, 1, 2
  Side side;
};

/// The roots of a part of a line, in the line's order.
struct RootRange {
  std::size_t first, count;  ///< in Lines::roots(line)
};

struct Limits {
  int depth = 40;
  std::uint64_t tests = 100'000;  ///< an account: of a tetrahedron with its inner faces, of a face
};

struct Counters {
  std::uint64_t tests = 0, exact_tests = 0;
  int depth = 0;
};

class Faces {
 public:
  Faces(Vertices& vertices, Lines& lines, const Level& level, const Limits& limits)
      : vertices_(vertices), lines_(lines), level_(level), limits_(limits) {}

  /// Room for the trees of so many tetrahedra, as many have.
  void reserve(std::size_t tets) {
    edges_.reserve(4 * tets);
    faces_.reserve(5 * tets);
  }
  /// An edge of the mesh, or the inner one of a face.
  Index add_edge(Index first, Index second);
  Index add_face(const std::array<Index, 3>& corners, const std::array<Index, 3>& edges, int depth,
                 Index account, Index whole = kNone);
  Index add_account() {
    spent_.push_back(0);
    return static_cast<Index>(spent_.size() - 1);
  }
  void spend(Index account) { ++spent_[account]; }
  bool is_spent(Index account) const { return spent_[account] >= limits_.tests; }

  const Edge& edge(Index e) const { return edges_[e]; }
  const Face& face(Index f) const { return faces_[f]; }
  Index face_count() const { return static_cast<Index>(faces_.size()); }
  Index edge_count() const { return static_cast<Index>(edges_.size()); }
  const std::vector<Arc>& arcs() const { return arcs_; }
  Vertices& vertices() { return vertices_; }
  Lines& lines() { return lines_; }

  /// The edge with these ends.
  Index edge_of(Index face, Index a, Index b) const;
  /// Whether edge a is cut before edge b.
  bool cut_before(Index a, Index b) const;
  /// Cuts the face, if it is not cut, at the edge that its rule names. Requires: unless that is
  /// done, no zero corner.
  void split(Index face);
  /// The part that keeps the corner. Requires: split.
  Index part_with(Index face, Index corner) const;
  void mark_boundary(Index face) { faces_[face].boundary = true; }
  /// Decides the faces' leaves, in parallel, cutting where needed.
  void close(std::span<const Index> faces);
  /// Whether all leaves are decided, after close().
  bool is_closed(Index face);
  template <class Use>
  void for_each_leaf(Index face, Use&& use) const {
    if (faces_[face].split < 0) return use(face);
    for (const Index part : faces_[face].part) for_each_leaf(part, use);
  }
  /// Calls use(a) for the arcs of a side in the face's leaves.
  template <class Use>
  void for_each_arc(Index face, Side side, Use&& use) const {
    for_each_leaf(face, [&](Index leaf) {
      const Face& f = faces_[leaf];
      for (Index a = f.first_arc; a < f.first_arc + f.arc_count; ++a)
        if (arcs_[a].side == side) use(a);
    });
  }
  RootRange roots(Index edge);
  const Counters& counters() const { return counters_; }

 private:
  friend class ArcMaker;
  void cut(Index edge);
  void add_leaves_to_test(Index face, std::vector<Index>& to);
  void take(Index face, const CellResult<2>& result, std::vector<Index>& graphs,
            std::vector<Index>& next);
  void refine(Index face, std::vector<Index>& next);
  void isolate_around(const std::vector<Index>& faces);

  Vertices& vertices_;
  Lines& lines_;
  Level level_;
  Limits limits_;
  std::vector<Edge> edges_;
  std::vector<Face> faces_;
  std::vector<Arc> arcs_;
  std::vector<std::uint64_t> spent_;  ///< tests, by account
  Counters counters_;
};

}  // namespace crest::modes
