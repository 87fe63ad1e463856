// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Which critical edges of a square are joined (SPEC.md, "Squares").
#include "certify/extremal/edges.hpp"
#include "certify/extremal/incidence.hpp"

namespace crest::certify::extremal {

struct Groups {
  bool tested = true;                                ///< all four edges
  unsigned critical = 0;                             ///< edges, of the tested ones
  std::array<std::int8_t, 4> group{-1, -1, -1, -1};  ///< of each edge of the square
  bool odd() const { return tested && critical % 2 == 1; }
};

class Squares {
 public:
  /// Counts odd and ambiguous squares; pairings belong to the latter. Throws Reject unless there
  /// are as many of each as stated.
  Squares(const ExtremalCertificate& c, const Grid& grid, const Cells& cells, const Edges& edges);

  Groups groups(const Square& square) const;
  /// Why an end of the mesh lies on this square, if not all of its edges are tested: 4 or 5.
  unsigned border_reason(const Square& square) const;
  size_t ambiguous() const { return ambiguous_.size(); }

 private:
  bool touches_listed(u32 edge) const;

  const ExtremalCertificate& c_;
  const Grid& grid_;
  const Cells& cells_;
  const Edges& edges_;
  std::vector<u32> ambiguous_;  ///< ascending
};

}  // namespace crest::certify::extremal
