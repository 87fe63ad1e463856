// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Triangle meshes from files of all formats (io/formats), cleaned (io/clean), with the numbers that
// a command asks for at their vertices.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/clean/clean_up.hpp"
#include "io/clean/surface.hpp"
#include "kernel/geometry/triangle_mesh.hpp"

namespace crest::io {

/// What is wanted of a file.
struct MeshRequest {
  CleanOptions clean = {};
  std::optional<std::string> field = {};  ///< a scalar one; empty name: the only one there is
  bool normals = false;
  std::optional<std::int64_t> step = {};  ///< of the field's time steps; else the last
};

/// A mesh and what had to be done to the file's data to get it, one line each.
struct MeshFile {
  kernel::TriangleMesh mesh;
  FileNumbers numbers;
  std::vector<double> values;         ///< V, of the field, or none
  std::vector<kernel::Vec3> normals;  ///< V, of the length the file gives, or none
  CleanUp cleanup;
  std::vector<std::string> warnings;
};

/// Reads the format that the extension names, in any case; coordinates keep double precision.
/// Throws: kernel::InputError "FILE: ELEMENT: PROBLEM; REMEDY", one line. Vertex and face numbers
///   are those of the file, counted from 0 or by its tags.
/// Cost: O(n log n) in the file's size; nothing is allocated on the strength
///   of a count that the file is too short for.
MeshFile read_mesh(const std::string& path, const MeshRequest& request = {});

/// The same for a file that is in memory: `name` gives the format and stands in messages.
MeshFile read_mesh_bytes(const std::string& name, std::string_view bytes,
                         const MeshRequest& request = {});

/// The same for a soup; messages do without the file's name.
MeshFile mesh_of_soup(const Soup& soup, const MeshRequest& request = {});

}  // namespace crest::io
