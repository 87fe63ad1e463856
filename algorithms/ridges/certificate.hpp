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

/// A graph whose certificate is not yet bytes.
struct ClaimedRidges {
  RidgeGraph graph;
  certify::Envelope envelope;   ///< of the certificate: all that is not in the mesh and its forms
  certify::Digest data_digest;  ///< names the data the certificate speaks of
};

/// extract_ridge_graph with what its certificate claims. Once edges and faces are decided, a second
/// thread hashes the certificate's data section while the graph is made of them.
ClaimedRidges extract_claimed(const kernel::TriangleMesh& mesh,
                              const std::vector<kernel::MongeForm>& forms,
                              const GraphOptions& options = {}, PredicateReport* report = nullptr,
                              const Workers* workers = nullptr);

/// The certificate's bytes in pieces, of the mesh and the forms that `envelope` was made of.
void hand_on_certificate(const certify::Envelope& envelope, const kernel::TriangleMesh& mesh,
                         const std::vector<kernel::MongeForm>& forms,
                         const certify::TakePiece& take);

struct CertifiedRidges {
  RidgeGraph graph;
  certify::Bytes certificate;   ///< encoded and sealed
  certify::Digest data_digest;  ///< names the data the certificate speaks of
};

/// extract_claimed with the certificate in memory: 136 bytes a vertex, 12 a face and the claims.
CertifiedRidges extract_certified(const kernel::TriangleMesh& mesh,
                                  const std::vector<kernel::MongeForm>& forms,
                                  const GraphOptions& options = {},
                                  PredicateReport* report = nullptr,
                                  const Workers* workers = nullptr);

}  // namespace crest::ridges
