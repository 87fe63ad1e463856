// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A thinning as claim features-mesh of certify/features_mesh/SPEC.md.
#include "algorithms/feature_lines/feature_lines.hpp"
#include "certify/features_mesh/encode.hpp"

namespace crest::feature_lines {

/// Requires: the thinning is one of this mesh. Cost: O(V + F).
certify::FeaturesMeshCertificate make_certificate(const kernel::TriangleMesh& mesh,
                                                  const Thinning& thinning);

}  // namespace crest::feature_lines
