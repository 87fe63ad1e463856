// SPDX-License-Identifier: GPL-3.0-or-later
// Expressions over Taylor models over MPFR intervals.
#include "certify/ridges_smooth/evaluator_impl.hpp"

namespace crest::certify::smooth {

CREST_SMOOTH_EVALUATOR(MpModel3);
CREST_SMOOTH_EVALUATOR(MpModel4);
CREST_SMOOTH_EVALUATOR(MpModel5);

}  // namespace crest::certify::smooth
