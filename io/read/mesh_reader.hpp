// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Triangle meshes from files: OFF, OBJ, PLY, STL (CGAL's polygon-soup readers) and VTP (VTK).
#include <string>
#include <vector>

#include "kernel/geometry/triangle_mesh.hpp"

namespace crest::io {

/// A mesh and what had to be done to the file's data to get it, one line each.
struct MeshFile {
  kernel::TriangleMesh mesh;
  std::vector<std::string> warnings;
};

/// Reads the format that the extension names, in any case; coordinates keep double precision.
/// Unreferenced vertices are dropped, exactly equal STL corners merged in order of first
/// appearance, and faces oriented against the majority of their component flipped (a tie keeps the
/// first face); each of these but the merging leaves a warning.
/// Guarantees: face i of the mesh is face i of the file; vertices keep their order.
/// Throws: kernel::InputError "FILE: ELEMENT: PROBLEM; REMEDY", one line. Vertex and face numbers
///   are those of the file, counted from 0.
/// Cost: linear in the file's size; nothing is allocated on the strength
///   of a count that the file is too short for.
MeshFile read_mesh(const std::string& path);

/// The same for a file that is in memory: `name` gives the format and stands in messages.
MeshFile read_mesh_bytes(const std::string& name, std::string bytes);

}  // namespace crest::io
