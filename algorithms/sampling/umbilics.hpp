// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The umbilics of an exact surface, to rounding.
#include "algorithms/sampling/mesh_surface.hpp"

namespace crest::sampling {

struct ExactUmbilic {
  Vec3 point;       ///< world
  int twice_index;  ///< +1 or -1; 0 where the third order does not decide
};

/// Umbilics reached by Newton's method on the deviator of the second fundamental form from every
/// vertex of the sample where k1 - k2 is least among the neighbours.
/// Guarantees: every result is an umbilic to rounding, each is given once. That none is missing is
///   not proved; on a closed surface compare the sum of the indices with the Euler characteristic.
/// Source: at p, in the principal frame, the deviator is ((k1 - k2)/2, 0) +
///   (((b0 - b2) x + (b1 - b3) y)/2, b1 x + b2 y) + O(2), from paper 002, equation 1.
std::vector<ExactUmbilic> find_umbilics(const Surface& surface, const SurfaceSample& sample);

}  // namespace crest::sampling
