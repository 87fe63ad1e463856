// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The trees of tetrahedra of one level: leaves are rejected, graphs along a witness whose pieces
// are known, or open.
#include <utility>
#include <vector>

#include "algorithms/modes/cell_topology.hpp"

namespace crest::modes {

struct Cell {
  std::array<Index, 4> corners;
  std::array<Index, 4> faces;  ///< face i lies opposite corner i
  Index tet;
  Index account;  ///< where its tests are counted
  State state = State::unknown;
  std::uint8_t depth = 0;
  std::array<std::uint8_t, 2> split{};  ///< the corners whose edge is cut, if there are parts
  Index inner = kNone;                  ///< the face between the parts
  Index part[2] = {kNone, kNone};
  Witness<3> witness{};
  std::array<std::uint8_t, 3> pieces{};  ///< of the minus, the neutral, the plus side
};

/// A test of a cell, and the corners whose edge it was then cut at (0, 0: it was not).
struct CellTest {
  CellResult<3> result;
  std::array<std::uint8_t, 2> split{};
};

/// Tests that were made elsewhere, of each tetrahedron in the order in which its tree grows.
class KnownTests {
 public:
  KnownTests() = default;
  /// counts: how many of the tests are of each tetrahedron; none: no test is known.
  KnownTests(std::vector<CellTest> tests, const std::vector<std::uint32_t>& counts);
  /// The tetrahedron's next one, or null.
  const CellTest* next(Index tet);
  /// The tetrahedron's others are of another tree.
  void drop(Index tet);

 private:
  std::vector<CellTest> tests_;
  std::vector<std::size_t> next_, end_;  ///< by tetrahedron
};

class Cells {
 public:
  Cells(Faces& faces, const Level& level, const Limits& limits)
      : faces_(faces), level_(level), limits_(limits) {}

  /// A tetrahedron with these faces; its tree's root. Requires: no zero corner.
  Index add(Index tet, const std::array<Index, 4>& corners, const std::array<Index, 4>& faces);
  /// Decides all trees, cutting where needed, all at once: their cells in parallel, then their
  /// facets.
  void decide(KnownTests known);
  /// Cuts all trees where tests of their cells alone ask for it. The tests, each with its
  /// tetrahedron, round by round.
  std::vector<std::pair<Index, CellTest>> test_trees();

  const Cell& cell(Index c) const { return cells_[c]; }
  Index size() const { return static_cast<Index>(cells_.size()); }
  /// Gives up a leaf whose facets do not close.
  void open(Index cell) { cells_[cell].state = State::open; }
  const Counters& counters() const { return counters_; }
  /// Whether tests ran out in some tetrahedron.
  bool exhausted() const { return exhausted_; }
  std::uint64_t uniform() const { return uniform_; }

 private:
  void take(Index cell, const CellResult<3>& result, std::vector<Index>& next);
  void refine(Index cell, std::vector<Index>& next);
  struct Found {
    CellResult<3> result;
    const CellTest* known = nullptr;
  };
  std::vector<Found> find(const std::vector<Index>& asked);
  void test(std::vector<Index> asked);
  void close_facets();
  void settle_all(std::vector<Index>& next);
  bool settle(Cell& cell, bool by_loops);
  void split(Index cell);
  Index edge(const Cell& cell, std::size_t i, std::size_t j) const;

  Faces& faces_;
  Level level_;
  Limits limits_;
  std::vector<Cell> cells_;
  KnownTests known_;
  std::vector<std::pair<Index, CellTest>> made_;
  bool keeps_ = false;         ///< what is tested is kept in made_
  std::vector<Index> graphs_;  ///< leaves with a witness
  std::size_t settled_ = 0;    ///< of them, whose pieces are known
  Counters counters_;
  std::uint64_t uniform_ = 0;
  bool exhausted_ = false;
};

}  // namespace crest::modes
