// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/modes.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <unordered_map>

#include "algorithms/modes/extraction.hpp"

namespace crest::modes {

ModeResult extract(const ModeField& field, const Level& level, const ModeOptions& options) {
  Extraction e(field, level, options);
  return e.result();
}

}  // namespace crest::modes
