// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/predicates/umbilic_kind.hpp"

#include "kernel/predicates/stages.hpp"

namespace crest::kernel {

CREST_INSTANTIATE_STAGES(CubicDiscriminant)
CREST_INSTANTIATE_STAGES(GapDifference)

MaybeSign interval_umbilic_kind(const CubicDiscriminant& c) {
  return interval_stage(c);
}
Sign exact_umbilic_kind(const CubicDiscriminant& c) {
  return exact_stage(c);
}
Decision umbilic_kind(const CubicDiscriminant& c) {
  return climb(c);
}
Decision compare_gaps(const GapDifference& g) {
  return climb(g);
}

}  // namespace crest::kernel
