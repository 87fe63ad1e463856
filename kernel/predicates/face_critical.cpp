// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/predicates/face_critical.hpp"

#include "kernel/predicates/stages.hpp"

namespace crest::kernel {

CREST_INSTANTIATE_STAGES(CentreSide)
CREST_INSTANTIATE_STAGES(Hessian)

MaybeSign interval_centre_side(const CentreSide& x) {
  return interval_stage(x);
}
Sign exact_centre_side(const CentreSide& x) {
  return exact_stage(x);
}
Decision centre_side(const CentreSide& x) {
  return climb(x);
}

MaybeSign interval_hessian(const Hessian& x) {
  return interval_stage(x);
}
Sign exact_hessian(const Hessian& x) {
  return exact_stage(x);
}
Decision hessian(const Hessian& x) {
  return climb(x);
}

Decision face_critical(const FaceValues& f) {
  Decision all = centre_side({f});
  for (std::size_t k = 1; k < 3 && all.sign != Sign::zero; ++k) {
    const Decision side = centre_side({f.rotated(k)});
    if (all.stage < side.stage) all.stage = side.stage;
    if (side.sign != all.sign) all.sign = Sign::zero;
  }
  return all;
}

}  // namespace crest::kernel
