// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Certificates of claim 11 straight from its SPEC.md: all cuts of a ray listed and sorted, in
// rationals.
#include "certify/spline_rays/records.hpp"
#include "tests/certify_splines/reference_volume.hpp"

namespace crest::tests {

/// The volume's first zeros on these rays.
certify::SplineRaysCertificate reference_rays(const SplineVolume& volume,
                                              const std::vector<std::array<double, 6>>& rays);

}  // namespace crest::tests
