// SPDX-License-Identifier: GPL-3.0-or-later
// Expressions over Taylor models of order 5.
#include "certify/ridges_smooth/evaluator_impl.hpp"

namespace crest::certify::smooth {

CREST_SMOOTH_EVALUATOR(Model5);

}  // namespace crest::certify::smooth
