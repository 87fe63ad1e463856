// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The certificate of a ridge graph (claim ridges-mesh of certify/ridges_mesh/SPEC.md).
#include "algorithms/ridges/ridges.hpp"
#include "certify/ridges_mesh/encode.hpp"

namespace crest::ridges {

/// The unfiltered graph as extract_ridge_graph returned it, in the certificate's canonical form.
certify::RidgesMeshCertificate make_certificate(const kernel::TriangleMesh& mesh,
                                                const std::vector<kernel::MongeForm>& forms,
                                                const RidgeGraph& graph);

struct CertifiedRidges {
  RidgeGraph graph;
  certify::Bytes certificate;   ///< encoded and sealed
  certify::Digest data_digest;  ///< names the data the certificate speaks of
};

/// extract_ridge_graph with its certificate. Once edges and faces are decided, a second thread
/// encodes and hashes the certificate's data section while the graph is made of them.
CertifiedRidges extract_certified(const kernel::TriangleMesh& mesh,
                                  const std::vector<kernel::MongeForm>& forms,
                                  const GraphOptions& options = {},
                                  PredicateReport* report = nullptr,
                                  const Workers* workers = nullptr);

}  // namespace crest::ridges
