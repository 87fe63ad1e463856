// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Lines that are straight, exactly: where the velocity stays parallel to a direction. They run
// along edges and through vertices, where no corridor gets.
#include "algorithms/vector_fields/trace.hpp"

namespace crest::vector_fields {

/// Follows the start in its direction as long as it is straight. Either the trace has an end then,
/// or `trace.leg` says how a corridor goes on from a vertex; `kind` none: neither. Requires: a
/// direction.
void walk_straight(const Surroundings& around, const Start& start, Trace& trace);

}  // namespace crest::vector_fields
