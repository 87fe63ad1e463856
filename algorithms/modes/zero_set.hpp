// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// H2: where the tensor is zero inside an edge, a face or a tetrahedron, found exactly, a vertex is
// put there, so that the field's zero set is made of simplices of the mesh.
#include "algorithms/modes/modes.hpp"

namespace crest::modes {

/// Corners, ascending, of the simplices that got vertices, in the order of insertion: edges first,
/// then faces, then tetrahedra, each ascending. The new vertices follow the mesh's own; each
/// tetrahedron around is replaced by as many as the simplex has corners, each with the new vertex
/// instead of one of them: the first in its place, the others at the end.
struct ZeroSet {
  std::vector<std::vector<kernel::Index>> simplices;
  std::vector<kernel::TetMesh::Tet> tets;  ///< of the given mesh
  std::vector<kernel::Index> tet_of;  ///< the tetrahedron of the given mesh that each is part of
};

/// Changes the field if there are such places. Cost: a few products a simplex, integers where
/// doubles see a near dependency.
ZeroSet insert_zeros(ModeField& field);

}  // namespace crest::modes
