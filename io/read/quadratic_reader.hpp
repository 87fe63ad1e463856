// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Surfaces with a function linear or quadratic on each face, from files.
#include <optional>
#include <string>
#include <vector>

#include "kernel/expressions/expression.hpp"
#include "kernel/geometry/quadratic_mesh.hpp"

namespace crest::io {

/// Where the values come from.
struct FunctionSource {
  std::string field = {};  ///< a scalar point field; empty: the file's only one
  /// In x, y, z; instead of a field: sampled at the nodes, on linear meshes at the vertices and,
  /// unless it is affine and so linear on every face, at the edges' midpoints.
  std::optional<kernel::Expression> expression = {};
  bool linear = false;  ///< without midpoints: the function linear between the corners' values
};

struct QuadraticFile {
  kernel::QuadraticMesh mesh;
  std::string function;  ///< the field's name or the expression's text
  std::vector<std::string> warnings;
};

/// Reads .vtu (cell types 5 and 22), .msh (Gmsh text 2.2 and 4.1, orders 1 and 2), .vtp, and with
/// an expression also .off, .obj, .ply and .stl. The surface may be one-sided. A linear face among
/// quadratic ones has the means of its ends as midside values (with an expression: its values
/// there).
/// Guarantees: face i of the mesh is triangle i of the file; vertices are its corners in their
/// order. Throws: kernel::InputError "FILE: ELEMENT: PROBLEM; REMEDY", one line, in the file's
/// numbers. Cost: linear in the file's size; nothing is allocated on the strength of a count that
/// the file
///   is too short for.
QuadraticFile read_quadratic_mesh(const std::string& path, const FunctionSource& source);

/// The same for a file that is in memory: `name` gives the format and stands in messages.
QuadraticFile read_quadratic_mesh_bytes(const std::string& name, std::string bytes,
                                        const FunctionSource& source);

}  // namespace crest::io
