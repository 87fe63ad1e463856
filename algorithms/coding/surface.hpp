// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The oriented surface that is coded: combinatorics alone, areas play no part.
#include <span>
#include <vector>

#include "algorithms/coding/connectivity.hpp"
#include "kernel/geometry/corner_table.hpp"

namespace crest::coding {

using kernel::next_half;
using kernel::previous_half;

/// Half-edges are numbered as in kernel::CornerTable; the faces are the caller's.
class Surface {
 public:
  /// Guarantees and throws: as kernel::CornerTable.
  /// Cost: O(V + F).
  Surface(Index vertices, std::span<const Triangle> faces);

  Index from(Index h) const { return faces_[h / 3][h % 3]; }
  Index to(Index h) const { return from(next_half(h)); }
  Index twin(Index h) const { return table_.opposite(h); }
  const kernel::CornerTable& table() const { return table_; }
  std::span<const Triangle> faces() const { return faces_; }
  Index face_count() const { return table_.face_count(); }
  const Counts& counts() const { return counts_; }

  /// Calls `each` with the half-edges from v, counter-clockwise, from that without a twin on, or
  /// from the lowest.
  template <class Each>
  void around(Index v, Each&& each) const {
    const Index first = table_.half_of(v);
    Index h = first;
    do {
      each(h);
      h = twin(previous_half(h));
    } while (h != kNone && h != first);
  }

  /// The component of a face; components are numbered by their first faces.
  Index component(Index f) const { return component_[faces_[f][0]]; }
  /// The first half-edge of each boundary loop, ascending.
  const std::vector<Index>& loops() const { return loops_; }
  /// Half-edges without a twin.
  std::size_t side_count() const { return sides_; }
  /// The boundary half-edge after the boundary half-edge h.
  Index next_on_boundary(Index h) const;

 private:
  void find_components();
  void find_loops();

  std::span<const Triangle> faces_;
  kernel::CornerTable table_;
  std::vector<Index> component_;  ///< of a vertex
  std::vector<Index> loops_;
  std::size_t sides_ = 0;
  Counts counts_;
};

}  // namespace crest::coding
