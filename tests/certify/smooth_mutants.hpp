// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// False certificates of claim 4 from true ones.
#include <string>

#include "certify/ridges_smooth/encode.hpp"
#include "tests/certify/sample_meshes.hpp"

namespace crest::tests {

/// A wrong record: dropped, doubled, moved, with another number, verdict, type, patch or tree code.
/// Returns what was done; the certificate may be unchanged when the record does not exist.
std::string mutate_smooth_claim(certify::RidgesSmoothCertificate& c, Random& random);

/// Everything the claim states about the surface.
bool same_results(const certify::RidgesSmoothCertificate& a,
                  const certify::RidgesSmoothCertificate& b);

}  // namespace crest::tests
