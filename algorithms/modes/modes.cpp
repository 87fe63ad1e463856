// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/modes.hpp"

#include <set>

namespace crest::modes {

Census take_census(const Input& input) {
  const std::set<kernel::Vec3> places(input.points.begin(), input.points.end());
  std::set<std::uint32_t> corners;
  for (const auto& cell : input.cells) corners.insert(cell.begin(), cell.end());
  return {static_cast<std::uint32_t>(places.size()), static_cast<std::uint32_t>(corners.size())};
}

}  // namespace crest::modes
