// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The local test of paper 001, algorithms 5.1 and 5.4, as printed: separatrices and switch points
// stand in the same circular order on the ring around the collapsed vertex before and after, and
// no separatrix enters twice before. Rings of boundary vertices are not closed: there is none.
#include "algorithms/vector_fields/search.hpp"

namespace crest::vector_fields {

class ThesisTest {
 public:
  /// Requires: the collapse is not applied; lines: those through its star.
  ThesisTest(const SearchState& state, const Collapse& plan, const std::vector<Index>& lines);
  /// Requires: it is, and the lines are followed anew.
  bool allows(const SearchState& state, const std::vector<Index>& lines) const;

 private:
  /// A place on the ring.
  struct Mark {
    std::size_t side;
    double share;
    Index label;
  };
  std::size_t side_of(Index from, Index to) const;
  void add_switches(const SearchState& state);
  /// Of the places where lines enter and leave; whether each enters once.
  bool add_lines(const SearchState& state, const std::vector<Index>& lines,
                 std::vector<Mark>& marks) const;
  static std::vector<Index> circular(std::vector<Mark> marks);

  std::vector<Index> star_;                    ///< ascending
  std::vector<std::pair<Index, Index>> ring_;  ///< sides by their vertices, counter-clockwise
  std::vector<Mark> switches_;
  std::vector<Index> before_;
  bool closed_ = true, once_ = true;
};

}  // namespace crest::vector_fields
