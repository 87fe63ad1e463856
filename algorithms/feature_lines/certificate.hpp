// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A thinning as claim features-mesh of certify/features_mesh/SPEC.md, sharp edges as claim
// sharp-edges of certify/sharp_edges/SPEC.md.
#include "algorithms/feature_lines/feature_lines.hpp"
#include "algorithms/feature_lines/sharp_edges.hpp"
#include "certify/features_mesh/encode.hpp"
#include "certify/sharp_edges/encode.hpp"

namespace crest::feature_lines {

/// Requires: the thinning is one of this mesh. Cost: O(V + F).
certify::FeaturesMeshCertificate make_certificate(const kernel::TriangleMesh& mesh,
                                                  const Thinning& thinning);

/// Of `lines.sharp`, before pruning and joining. Requires: extract_sharp_lines of this angle.
certify::SharpEdgesCertificate make_certificate(const kernel::TriangleMesh& mesh,
                                                const kernel::DecimalAngle& angle,
                                                const SharpLines& lines);

}  // namespace crest::feature_lines
