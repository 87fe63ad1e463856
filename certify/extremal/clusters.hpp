// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Which components are isotopic to components of {g = 0} (SPEC.md, theorem 15).
#include "certify/extremal/components.hpp"

namespace crest::certify::extremal {

/// Sets `isotopic` and `extremal` of all components. Requires: everything that the certificate says
/// of cells, edges and squares is proven.
void find_isotopic(const ExtremalCertificate& c, const Grid& grid, const Cells& cells,
                   const Edges& edges, const Squares& squares, const Mesh& mesh,
                   Components& components);

}  // namespace crest::certify::extremal
