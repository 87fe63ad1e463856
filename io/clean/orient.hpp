// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The parts of a surface (components by shared sides), and the side from which they are seen.
#include "io/clean/sides.hpp"

namespace crest::io {

struct Parts {
  struct Part {
    std::size_t faces = 0, against = 0;
    bool closed = true;  ///< every side has a face across
  };
  std::vector<Part> parts;            ///< in the order of their first faces
  std::vector<kernel::Index> of;      ///< F: number of its part
  std::vector<std::uint8_t> against;  ///< F: not oriented like the part's first face
  /// Sides across which this cannot be so: there are some iff a part is one-sided. The others are
  /// enough to keep each part together.
  std::vector<std::pair<kernel::Index, std::uint8_t>> clashes;
};

/// Goes through each part from its first face on, by breadth. Cost: O(F).
Parts parts_of(const Neighbours& across);

/// Turns the faces oriented against the majority of their part (of halves: against the first face);
/// returns how many. Requires: no clashes.
std::size_t turn_minorities(Surface& surface, const Parts& parts);

/// Closed parts whose volume is negative, decided exactly. Requires: faces oriented alike.
std::vector<bool> inside_out(const Surface& surface, const Parts& parts);

/// Turns the parts with a mark.
void turn(Surface& surface, const Parts& parts, const std::vector<bool>& marked);

}  // namespace crest::io
