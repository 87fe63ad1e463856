// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/predicates/line_critical.hpp"

#include "kernel/predicates/stages.hpp"

namespace crest::kernel {

CREST_INSTANTIATE_STAGES(EndSlope)

MaybeSign interval_end_slope(const EndSlope& x) {
  return interval_stage(x);
}
Sign exact_end_slope(const EndSlope& x) {
  return exact_stage(x);
}
Decision end_slope(const EndSlope& x) {
  return climb(x);
}

}  // namespace crest::kernel
