// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/predicates/within.hpp"

#include "kernel/predicates/stages.hpp"

namespace crest::kernel {

CREST_INSTANTIATE_STAGES(WithinDistance)

bool within(const Vec3& p, const Vec3& q, double t) {
  return climb(WithinDistance{p, q, t}).sign != Sign::negative;
}

}  // namespace crest::kernel
