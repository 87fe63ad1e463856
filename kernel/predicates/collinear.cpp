// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/predicates/collinear.hpp"

#include "kernel/predicates/stages.hpp"

namespace crest::kernel {

CREST_INSTANTIATE_STAGES(CrossCoordinate)

bool collinear(const Vec3& a, const Vec3& b, const Vec3& c) {
  auto coordinate = [&](std::size_t i, std::size_t j) {
    return CrossCoordinate{a[i], a[j], b[i], b[j], c[i], c[j]};
  };
  // Any coordinate certainly non-zero settles it, cheapest stage first.
  for (const auto& [i, j] : {std::pair{0u, 1u}, {1u, 2u}, {2u, 0u}})
    if (triage(coordinate(i, j))) return false;
  for (const auto& [i, j] : {std::pair{0u, 1u}, {1u, 2u}, {2u, 0u}})
    if (climb(coordinate(i, j)).sign != Sign::zero) return false;
  return true;
}

}  // namespace crest::kernel
