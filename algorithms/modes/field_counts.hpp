// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What is special about a field's tetrahedra, whatever the level.
#include "algorithms/modes/modes.hpp"

namespace crest::modes {

struct FieldCounts {
  std::size_t zero_vertices = 0;  ///< whose deviator is 0
  std::size_t constant_tets = 0;  ///< four equal tensors
  /// Whose four deviators are linearly dependent, constant ones and those with a zero among them.
  std::size_t rank_deficient_tets = 0;
};

/// Exact: where doubles see a near dependency, rationals decide. Cost: a few products a
/// tetrahedron, by all threads.
FieldCounts count_field(const ModeField& field);

}  // namespace crest::modes
