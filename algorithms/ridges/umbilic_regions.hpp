// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Umbilics that can be told apart. Where k1 - k2 < 3 sigma the principal directions are not known,
// and what umbilics there are is the noise's affair. An umbilic region is a component (faces that
// share a vertex) of
//   faces with a corner where k1 - k2 < 3 sigma,  faces of non-zero index,  umbilic patches,
//   9 sigma^2 = 9 sigma_gap^2 + ((k1 - k2) - (k1' - k2'))^2,
// the second term for the model's error: without it a noise-free sphere falls into pieces on large
// supports, because truncation is no noise. A region's index is the sum of its faces' indices, so
// the regions' indices sum to the graph's, whatever sigma is. Index 0: its umbilics cancel. A disk
// of index
// +-1/2 is one significant umbilic.
#include "algorithms/ridges/salience.hpp"

namespace crest::ridges {

/// By smallest face. Requires: fit.errors. Shapes: indices are those of the graph's face_indices.
/// Cost: O(F), nearly.
std::vector<UmbilicRegion> umbilic_regions(const kernel::TriangleMesh& mesh, const FitResult& fit,
                                           const RidgeGraph& graph);

}  // namespace crest::ridges
