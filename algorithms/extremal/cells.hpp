// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// All cells (an image: squares) with what is proven of them.
#include <vector>

#include "algorithms/extremal/cell_proofs.hpp"
#include "algorithms/extremal/nodes.hpp"

namespace crest::extremal {

class Cells {
 public:
  Cells(const Fields& fields, const Nodes& nodes);

  CellState state(std::size_t v) const { return states_[v]; }
  /// Does the cell decide its edges?
  bool decides(std::size_t v) const {
    return states_[v] != CellState::open && states_[v] != CellState::unlisted;
  }
  bool regular(std::size_t v) const {
    return states_[v] == CellState::regular || states_[v] == CellState::regular_extremal;
  }
  /// w of a cell that decides its edges.
  const Short3& direction(std::size_t v) const { return proofs_[ids_.rank(v)].direction; }
  const CellProof& proof(std::size_t v) const { return proofs_[ids_.rank(v)]; }
  std::size_t count(CellState s) const;

 private:
  const Fields& fields_;
  std::vector<CellState> states_;
  RankedBits ids_;  ///< of cells that decide their edges
  std::vector<CellProof> proofs_;
};

}  // namespace crest::extremal
