// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Certificates of claim 8 made straight from SPEC.md, for small grids: Jacobi's eigenvectors,
// sampled edges, the mesh as explicit triangles that are cut one by one.
#include "tests/certify_extremal/reference_fields.hpp"

namespace crest::tests {

/// What a test may ask for besides.
struct ReferenceOptions {
  bool no_cells = false;     ///< all cells open, so that every edge has a tree
  bool world_units = false;  ///< a mistake: the regular test in world units
};

certify::ExtremalCertificate reference_extremal(const certify::ExtremalData& data,
                                                const ReferenceOptions& options = {});

/// Makes everything that follows from cells, trees, types, pairings and places anew.
void count_mesh(certify::ExtremalCertificate& c, const ReferenceFields& fields,
                const std::vector<std::uint8_t>& edge_states);

}  // namespace crest::tests
