// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The public call of plane vector fields (theory and limits: README.md beside this file).
#include "algorithms/vector_fields/skeleton_result.hpp"

namespace crest::vector_fields {

/// Zeros, switch points, regions of the boundary, separatrices with their ends, and the closed
/// orbits that these end in.
/// Guarantees: what README.md states; the same result for any number of threads.
/// Throws: kernel::InputError naming the element if a number is not finite, a triangle is not
///   counter-clockwise, triangles overlap along an edge, or all vectors are zero.
/// Cost: O(V + T) and about a microsecond a triangle that a separatrix crosses.
Skeleton extract_skeleton(const PlanarField& field);

}  // namespace crest::vector_fields
