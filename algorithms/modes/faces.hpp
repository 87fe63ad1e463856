// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The trees of edges and faces of one level. A cut is a property of its edge alone: the edge with
// the largest angle between its ends' tensors is cut where that angle is halved, to 64ths; so both
// tetrahedra at a face cut it in the same way. A leaf face is rejected, or the curves in it are
// graphs along its witness, each an arc that joins two roots on its edges.
#include <unordered_map>
#include <vector>

#include "algorithms/modes/cell_test.hpp"
#include "algorithms/modes/lines.hpp"

namespace crest::modes {

inline constexpr Index kNone = ~Index{0};

struct Edge {
  Index first, second, line;
  kernel::Dyadic begin, end;  ///< of the line
  double measure;             ///< signed squared cosine of the angle between the ends' tensors
  Index middle = kNone;       ///< the vertex that cuts it
  Index part[2] = {kNone, kNone};
};

enum class State : std::uint8_t { unknown, rejected, graph, open };

struct Face {
  std::array<Index, 3> corners;
  std::array<Index, 3> edges;  ///< edge k joins corners k and k + 1 mod 3
  State state = State::unknown;
  Index parent = kNone;
  Index whole = kNone;     ///< the root of its tree
  std::int8_t split = -1;  ///< the edge that is cut
  std::uint8_t depth = 0;
  bool closed = false;  ///< all leaves below are rejected or graphs
  Index inner = kNone;  ///< edge from the opposite corner to the new vertex
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
  std::uint64_t tests = 100'000;  ///< for one tetrahedron
};

struct Counters {
  std::uint64_t tests = 0, exact_tests = 0;
  int depth = 0;
};

class Faces {
 public:
  Faces(Vertices& vertices, Lines& lines, const Level& level, const Limits& limits)
      : vertices_(vertices), lines_(lines), level_(level), limits_(limits) {}

  /// An edge of the mesh, or the inner one of a face.
  Index add_edge(Index first, Index second);
  Index add_face(const std::array<Index, 3>& corners, const std::array<Index, 3>& edges, int depth,
                 Index whole = kNone);

  /// What test_cell says of a face, for when it is asked.
  void foresee(Index face, const CellResult<2>& result) { foreseen_.emplace(face, result); }

  const Edge& edge(Index e) const { return edges_[e]; }
  const Face& face(Index f) const { return faces_[f]; }
  Index face_count() const { return static_cast<Index>(faces_.size()); }
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
  /// Decides leaves, cutting where needed; false if one stays open.
  bool close(Index face);
  /// What close() tests at most, from now on; leaves that are left then stay open.
  void allow(std::uint64_t tests) { budget_ = counters_.tests + tests; }
  void leaves(Index face, std::vector<Index>& to) const;
  RootRange roots(Index edge);
  const Counters& counters() const { return counters_; }

 private:
  friend class ArcMaker;
  void cut(Index edge);
  CellResult<2> tested(Index face);
  void test(Index face);

  Vertices& vertices_;
  Lines& lines_;
  Level level_;
  Limits limits_;
  std::vector<Edge> edges_;
  std::vector<Face> faces_;
  std::vector<Arc> arcs_;
  std::unordered_map<Index, CellResult<2>> foreseen_;
  Counters counters_;
  std::uint64_t budget_ = 0;
};

}  // namespace crest::modes
