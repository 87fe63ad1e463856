// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Lines: the edges of the mesh and those that cuts of faces make, undivided, with all roots of f on
// them under rule H3 (README.md), isolated exactly. A part of a line shares its roots.
#include <optional>
#include <span>
#include <vector>

#include "algorithms/modes/vertices.hpp"
#include "kernel/polynomial/algebraic_number.hpp"

namespace crest::modes {

/// A crossing of a line a, b by a surface, at (1 - t) a + t b.
struct Root {
  Index line;
  Side side;
  /// Towards f < 0: 1 along the line, -1 against it. The root of f + epsilon is off its place by an
  /// infinitesimal that way.
  std::int8_t shift;
  double low, high;  ///< around the place
  double t;          ///< of the vertex in the output, strictly inside the line
  std::optional<kernel::AlgebraicNumber> number;  ///< the place; made when needed
};

/// Consecutive numbers of roots.
struct RootNumbers {
  Index first = 0, count = 0;
  Index operator[](std::size_t i) const { return first + static_cast<Index>(i); }
  std::size_t size() const { return count; }
  RootNumbers part(std::size_t begin, std::size_t size) const {
    return {(*this)[begin], static_cast<Index>(size)};
  }
};

class Lines {
 public:
  explicit Lines(Vertices& vertices, const Level& level) : vertices_(vertices), level_(level) {}

  /// Requires: T is nowhere zero between a and b, nor there.
  Index add(Index a, Index b);
  struct Line {
    Index a, b;
    bool known = false;
    RootNumbers roots{};  ///< in their order along the line
  };
  const Line& line(Index l) const { return lines_[l]; }
  /// Isolates them at the first call.
  RootNumbers roots(Index line) {
    if (!lines_[line].known) isolate({&line, 1});
    return lines_[line].roots;
  }
  /// Isolates those of many lines, each line once, in parallel.
  void isolate(std::span<const Index> lines);

  Index root_count() const { return static_cast<Index>(roots_.size()); }
  const Root& root(Index r) const { return roots_[r]; }

  /// The place against a parameter of the line.
  kernel::Sign compare_place(Index root, const kernel::Dyadic& t);
  /// Below or above; a root at t lies on the side of its shift.
  bool is_below(Index root, const kernel::Dyadic& t);
  /// Ends of an interval no wider than 2^-bits (or equal) around the place.
  std::array<kernel::Rational, 2> bounds(Index root, long bits);

 private:
  using RootList = std::vector<Root>;
  RootList isolated(Index line);
  template <class F, class C>
  bool isolate_in_doubles(Index line, const F& f, const C& c, RootList& roots) const;
  double crossing(Index line, const Root& root) const;
  RootList isolate_exactly(Index line);
  static void separate(RootList& roots);
  kernel::IntegerPolynomial polynomial(Index line);
  kernel::AlgebraicNumber& number(Index root);

  Vertices& vertices_;
  Level level_;
  std::vector<Line> lines_;
  std::vector<Root> roots_;
};

}  // namespace crest::modes
