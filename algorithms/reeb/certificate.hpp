// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What a Reeb graph's certificate records (certify/reeb/SPEC.md).
#include "algorithms/reeb/reeb_graph.hpp"
#include "algorithms/reeb/tile_complex.hpp"
#include "certify/reeb/encode.hpp"

namespace crest::reeb {

/// Requires: `graph` is the Reeb graph of `tiles`, and they are the tessellation of `mesh`.
/// Cost: O(n log n).
certify::ReebCertificate make_certificate(const kernel::QuadraticMesh& mesh,
                                          const TileComplex& tiles, const ReebGraph& graph);

/// A tile complex as the graph algorithms see it.
inline OrderedComplex ordered(const TileComplex& tiles) {
  return {tiles.tiles, tiles.rank, tiles.order};
}

}  // namespace crest::reeb
