// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/vector_fields/arrivals.hpp"

#include <algorithm>

namespace crest::vector_fields {

RegionSlots::RegionSlots(const Boundary& boundary) {
  Index ordinal = 0;
  for (Index i = 0; i < boundary.half_edges.size(); ++i) {
    const auto& loop = boundary.half_edges[i];
    const Index n = static_cast<Index>(loop.size());
    const bool whole = boundary.loops[i].zero == 0 &&
                       std::none_of(boundary.switch_points.begin(), boundary.switch_points.end(),
                                    [&](const SwitchPoint& s) { return s.loop == i; });
    // Two ends an edge; those of no region (zero or tangent) lie between regions.
    Index last = kNone;
    for (Index pass = 0; pass < 2; ++pass)
      for (Index k = 0; k < n; ++k) {
        const auto at = boundary.regions.find(loop[k]);
        if (at == boundary.regions.end()) continue;
        for (const Index r : {at->second.at_from, at->second.at_to}) {
          if (r == kNone) {
            last = kNone;
            continue;
          }
          if (r >= start_.size()) {
            first_.resize(r + 1, 0);
            length_.resize(r + 1, 1);
            start_.resize(r + 1, 0);
            cyclic_.resize(r + 1, 0);
          }
          if (r != last) {
            first_[r] = ordinal;
            length_[r] = n;
            start_[r] = k;
            cyclic_[r] = whole ? 1 : 0;
          }
          last = r;
        }
      }
    ordinal += n;
  }
}

}  // namespace crest::vector_fields
