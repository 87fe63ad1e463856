// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/predicates/boundary_saddle.hpp"

namespace crest::kernel {

Decision boundary_saddle(const FaceValues& f) {
  const Decision side = centre_side({f});
  if (side.sign != Sign::zero) return side;
  const Decision h = hessian({f});
  return {-h.sign, side.stage < h.stage ? h.stage : side.stage};
}

}  // namespace crest::kernel
