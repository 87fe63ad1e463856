// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// False claims about Reeb graphs from true ones.
#include <string>

#include "certify/reeb/encode.hpp"
#include "tests/certify/sample_meshes.hpp"

namespace crest::tests {

/// A wrong record, order, count or cut. Returns what was done; the claim may be unchanged.
std::string mutate_reeb_claim(certify::ReebCertificate& certificate, Random& random);

/// Other values, faces or positions under the same claim.
std::string mutate_reeb_data(certify::ReebCertificate& certificate, Random& random);

/// Another graph on the same nodes: the ends of two arcs exchanged, an arc moved, added or left
/// out; then cuts at arcs chosen at random, so that most graphs become forests, each at a contour
/// that exists: `contours` has (lower end, least node) of every arc of the true graph.
void rewire(certify::ReebCertificate& certificate,
            const std::vector<std::array<std::uint32_t, 2>>& contours, Random& random);

}  // namespace crest::tests
