// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Tetrahedral meshes with a symmetric tensor at each vertex, from files (io/formats). Other solids
// are split; every quadrilateral is cut from its lowest vertex, so on both its sides alike.
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "kernel/geometry/tet_mesh.hpp"

namespace crest::io {

struct Soup;  // io/formats/soup.hpp

struct TensorRequest {
  std::string field = {};  ///< of points; empty: the only one of 6 or 9 components
  /// Of 6 components; empty: the format's, "xx yy zz xy yz xz" in VTK's files and Gmsh's.
  std::string order = {};
  std::optional<std::int64_t> step = {};  ///< of time; else the last (.msh, .frd)
};

struct TensorFile {
  kernel::TetMesh mesh;                        ///< without points that no cell uses
  std::vector<std::array<double, 6>> tensors;  ///< xx yy zz xy yz xz
  std::string field;
  double max_asymmetry = 0;           ///< of 9 components: the largest |T_ij - T_ji|
  std::vector<std::int64_t> cell_of;  ///< each tetrahedron's, as the file numbers cells
  std::vector<std::string> warnings;
};

/// Reads .vtu, .vtk, .msh, .frd, .mesh with the .sol beside it, and volumes as .nrrd. Of cells with
/// midside nodes the corners are taken; cells that are no solids are left out. Throws:
/// kernel::InputError "FILE: ELEMENT: PROBLEM; REMEDY", one line: no solids, no such field (with
/// those there are), a tensor that is not finite, a cell or face that TetMesh refuses.
TensorFile read_tensors(const std::string& path, const TensorRequest& request);

/// The same for a soup; messages do without the file's name.
TensorFile tensors_of_soup(const Soup& soup, const TensorRequest& request);

}  // namespace crest::io
