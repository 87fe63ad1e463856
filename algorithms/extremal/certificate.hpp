// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Claim 8 of what was extracted (certify/extremal/SPEC.md).
#include "algorithms/extremal/extraction.hpp"
#include "certify/extremal/records.hpp"

namespace crest::extremal {

/// `mesh` is that of extremal edges.
certify::ExtremalCertificate make_certificate(const Volume& volume, const Extraction& extraction,
                                              const MeasuredMesh& mesh);

}  // namespace crest::extremal
