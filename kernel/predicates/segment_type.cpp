// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/predicates/segment_type.hpp"

#include "kernel/predicates/stages.hpp"

namespace crest::kernel {

CREST_INSTANTIATE_STAGES(SegmentSide)

MaybeSign interval_segment_side(const SegmentSide& s) {
  return interval_stage(s);
}
Sign exact_segment_side(const SegmentSide& s) {
  return exact_stage(s);
}
Decision segment_side(const SegmentSide& s) {
  return climb(s);
}

}  // namespace crest::kernel
