// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/extremal/squares.hpp"

#include <algorithm>

#include "certify/container/reject.hpp"

namespace crest::certify::extremal {

Squares::Squares(const ExtremalCertificate& c, const Grid& grid, const Cells& cells,
                 const Edges& edges)
    : c_(c), grid_(grid), cells_(cells), edges_(edges) {
  std::int64_t odd = 0;
  for (const u32 edge : edges.critical) {
    const auto around = squares_round(grid, edge);
    for (unsigned i = 0; i < around.count; ++i) {
      const Square& square = around.at[i];
      if (square.id == kNothing) continue;
      unsigned critical = 0;
      bool tested = true, first = true;
      for (const u32 other : square.edges) {
        tested = tested && edges.state[other] != Edges::kUntested;
        critical += edges.is_critical(other);
        first = first && !(edges.is_critical(other) && other < edge);
      }
      if (!first || !tested) continue;
      odd += critical % 2;
      if (critical == 4) ambiguous_.push_back(square.id);
    }
  }
  std::ranges::sort(ambiguous_);
  require_equal(c.odd_faces, odd, "odd faces");
  require_equal(static_cast<std::int64_t>(c.pairings.size()), ambiguous_.size(), "ambiguous faces");
}

Groups Squares::groups(const Square& square) const {
  Groups out;
  for (size_t i = 0; i < 4; ++i) {
    const std::uint8_t state = edges_.state[square.edges[i]];
    out.tested = out.tested && state != Edges::kUntested;
    out.critical += state >= Edges::kCritical;
    if (state >= Edges::kCritical) out.group[i] = 0;
  }
  if (!out.tested) {  // nothing is joined
    std::int8_t next = 0;
    for (auto& group : out.group)
      if (group == 0) group = next++;
  } else if (out.critical == 4) {
    const auto at = std::ranges::lower_bound(ambiguous_, square.id) - ambiguous_.begin();
    if (c_.pairings[static_cast<size_t>(at)] == 0)
      out.group = {0, 0, 1, 1};
    else
      out.group = {0, 1, 1, 0};
  }
  return out;
}

bool Squares::touches_listed(u32 edge) const {
  const auto [node, axis] = edge_place(grid_, edge);
  const Place p = grid_.place(node);
  const unsigned a = (axis + 1) % grid_.dimension, b = (axis + 2) % grid_.dimension;
  for (const u32 i : {0U, 1U})
    for (const u32 j : {0U, 1U}) {
      if (i > p[a] || (b != axis && j > p[b])) continue;
      const u32 cell = node - i * grid_.stride[a] - (b == axis ? 0 : j * grid_.stride[b]);
      if (cells_.code(cell) != Cells::kUnlisted) return true;
    }
  return false;
}

unsigned Squares::border_reason(const Square& square) const {
  for (const u32 edge : square.edges)
    if (edges_.state[edge] == Edges::kUntested && touches_listed(edge)) return 5;
  return 4;
}

}  // namespace crest::certify::extremal
