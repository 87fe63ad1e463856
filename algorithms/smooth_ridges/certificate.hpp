// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The certificate of claim ridges-smooth (certify/ridges_smooth/SPEC.md).
#include "algorithms/smooth_ridges/completeness.hpp"
#include "algorithms/smooth_ridges/refinement.hpp"

namespace crest::smooth_ridges {

/// Without witnesses (certify/smooth_witness/record.hpp). `cover`, `sheets`: of an implicit
/// surface. Requires: a refined surface without undecided cells, its graph assembled.
certify::RidgesSmoothCertificate make_certificate(const Surface& surface,
                                                  const RefinedSurface& refined,
                                                  const SmoothRidges& result, const Cover& cover,
                                                  const OneSheet& sheets);

}  // namespace crest::smooth_ridges
