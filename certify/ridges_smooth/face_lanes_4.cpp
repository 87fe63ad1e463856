// SPDX-License-Identifier: GPL-3.0-or-later
// Eight faces at once with Taylor models of order 4, and a derivative.
#include "certify/ridges_smooth/evaluator_impl.hpp"
#include "certify/ridges_smooth/face_lanes_impl.hpp"

namespace crest::certify::smooth {

CREST_SMOOTH_LANES_EVALUATOR(kernel::TaylorLanes<4>, 4);
template class FaceLanes<4, 1>;

}  // namespace crest::certify::smooth
