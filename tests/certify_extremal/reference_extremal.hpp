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

/// What follows from a certificate's data, tested edges, undecided types, pairings and places, made
/// anew: counts and components. Odd faces are ~0 where its types are not those of the data.
certify::ExtremalCertificate reference_of(const certify::ExtremalCertificate& c);

/// Is the cell regular with this w, and does the box test hold?
bool is_boxed(const ReferenceFields& fields, std::uint32_t cell,
              const certify::ExtremalDirection& w);

/// What diag(d) grad g is within on a regular cell, n oriented by w, and what h_i alone span.
struct GradientBox {
  Vec low, high, inner_low, inner_high;
};
GradientBox gradient_box(const ReferenceFields& fields, std::uint32_t cell,
                         const certify::ExtremalDirection& w);

/// Does the code hold at points of the cell? (g, n . w and s_nn are sampled)
bool code_holds(const ReferenceFields& fields, std::uint32_t cell, std::uint8_t code,
                const certify::ExtremalDirection& w);

/// Counts the mesh of edges with these states; pairings and places are those of `stated` if given.
void count_mesh(certify::ExtremalCertificate& c, const ReferenceFields& fields,
                const std::vector<std::uint8_t>& edge_states,
                const certify::ExtremalCertificate* stated = nullptr);

}  // namespace crest::tests
