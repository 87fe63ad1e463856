// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The values of a tile complex's nodes and their total order (certify/reeb/SPEC.md, "Nodes").
#include <vector>

#include "algorithms/reeb/tile_complex.hpp"
#include "kernel/predicates/critical_value.hpp"

namespace crest::reeb {

/// Side k of the face joins its corners k and (k + 1) % 3.
kernel::FaceValues face_values(const kernel::QuadraticMesh& mesh, Index face);

/// The value of a node from data that do not depend on the order of faces and corners: an edge from
/// its smaller vertex, a face with its corners sorted. `signs`: those of the second derivatives of
/// all nodes but the vertices, in their order; where empty the denominator's sign is not set.
kernel::CriticalValue node_value(const kernel::QuadraticMesh& mesh, const TileComplex& tiles,
                                 const std::vector<kernel::Sign>& signs, Index node);

/// Sets order, rank and tied of `tiles`, whose nodes are given. Adds the decisions between
/// successive nodes to `counts`: triage decides those whose enclosures are disjoint.
/// Cost: O(n) for n nodes of different values, O(n log n) in general.
void order_nodes(const kernel::QuadraticMesh& mesh, const std::vector<kernel::Sign>& signs,
                 bool guarded, TileComplex& tiles, kernel::StageCounts& counts);

}  // namespace crest::reeb
