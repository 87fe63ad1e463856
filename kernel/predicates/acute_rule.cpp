// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/predicates/acute_rule.hpp"

#include "kernel/predicates/stages.hpp"

namespace crest::kernel {

CREST_INSTANTIATE_STAGES(AcuteProduct)

MaybeSign interval_acute_rule(const Vec3& d, const Vec3& e) {
  return interval_stage(AcuteProduct{d, e});
}

Sign exact_acute_rule(const Vec3& d, const Vec3& e) {
  return exact_stage(AcuteProduct{d, e});
}

Decision acute_rule(const Vec3& d, const Vec3& e) {
  const Decision c = climb(AcuteProduct{d, e});
  if (c.sign != Sign::zero) return c;
  return {symbolic_acute_rule(d, e), Stage::symbolic};
}

}  // namespace crest::kernel
