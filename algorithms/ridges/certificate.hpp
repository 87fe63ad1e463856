// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The certificate of a ridge graph (claim ridges-mesh of certify/SPEC.md).
#include "algorithms/ridges/ridges.hpp"
#include "certify/certificate.hpp"

namespace crest::ridges {

/// The unfiltered graph as extract_ridge_graph returned it, in the certificate's canonical form.
certify::RidgesMeshCertificate make_certificate(const kernel::TriangleMesh& mesh,
                                                const std::vector<kernel::MongeForm>& forms,
                                                const RidgeGraph& graph);

}  // namespace crest::ridges
