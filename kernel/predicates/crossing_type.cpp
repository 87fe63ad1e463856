// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/predicates/crossing_type.hpp"

#include "kernel/predicates/stages.hpp"

namespace crest::kernel {

CREST_INSTANTIATE_STAGES(InterpolatedP)

MaybeSign interval_crossing_type(const RidgeEndData& p, const RidgeEndData& q) {
  return interval_stage(InterpolatedP{p, q});
}
Sign exact_crossing_type(const RidgeEndData& p, const RidgeEndData& q) {
  return exact_stage(InterpolatedP{p, q});
}
Decision crossing_type(const RidgeEndData& p, const RidgeEndData& q) {
  return climb(InterpolatedP{p, q});
}

}  // namespace crest::kernel
