// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/modes.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <unordered_map>

#include "algorithms/modes/extraction.hpp"

namespace crest::modes {

double diagonal(const ModeField& field) {
  const auto& points = field.mesh.points();
  if (points.empty()) return 0;
  kernel::Vec3 low = points[0], high = points[0];
  for (const kernel::Vec3& p : points)
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::fmin(low[k], p[k]);
      high[k] = std::fmax(high[k], p[k]);
    }
  return std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
}

ModeResult extract(const ModeField& field, const Level& level, const ModeOptions& options,
                   const Workers* workers) {
  Extraction e(field, level, options, workers);
  return e.result();
}

}  // namespace crest::modes
