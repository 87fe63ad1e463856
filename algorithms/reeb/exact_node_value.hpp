// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Values of nodes as rationals. (Apart from contours.hpp so that readers of results see no GMP.)
#include "algorithms/reeb/tile_complex.hpp"
#include "kernel/arithmetic/rational.hpp"

namespace crest::reeb {

/// The exact value of a node (certify/reeb/SPEC.md, "Definitions").
kernel::Rational exact_node_value(const kernel::QuadraticMesh& mesh, const TileComplex& tiles,
                                  Index node);

}  // namespace crest::reeb
