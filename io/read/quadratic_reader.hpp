// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Surfaces with a function linear or quadratic on each face, from files.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/clean/clean_up.hpp"
#include "io/clean/surface.hpp"
#include "kernel/expressions/expression.hpp"
#include "kernel/geometry/quadratic_mesh.hpp"

namespace crest::io {

/// Where the values come from.
struct FunctionSource {
  std::string field = {};  ///< a scalar field; empty: the file's only one
  /// In x, y, z; instead of a field: sampled at the nodes, on linear meshes at the vertices and,
  /// unless it is affine and so linear on every face, at the edges' midpoints.
  std::optional<kernel::Expression> expression = {};
  bool linear = false;  ///< without midpoints: the function linear between the corners' values
  CleanOptions clean = {};
  std::optional<std::int64_t> step = {};  ///< of the field's time steps; else the last
};

struct QuadraticFile {
  kernel::QuadraticMesh mesh;
  FileNumbers numbers;
  std::string function;  ///< the field's name or the expression's text
  CleanUp cleanup;
  std::vector<std::string> warnings;
};

/// Reads the formats of read_mesh, cleaned for a function (io/clean): the surface may be one-sided,
/// triangles of 6 nodes are quadratic. A linear face among quadratic ones has the means of its ends
/// as midside values (with an expression: its values there). Of welded vertices the first one's
/// value counts. Throws: kernel::InputError "FILE: ELEMENT: PROBLEM; REMEDY", one line, in the
/// file's numbers. Cost: O(n log n) in the file's size; nothing is allocated on the strength of a
/// count that the file is too short for.
QuadraticFile read_quadratic_mesh(const std::string& path, const FunctionSource& source);

/// The same for a file that is in memory: `name` gives the format and stands in messages.
QuadraticFile read_quadratic_mesh_bytes(const std::string& name, std::string_view bytes,
                                        const FunctionSource& source);

/// The same for a soup; messages do without the file's name.
QuadraticFile quadratic_mesh_of_soup(const Soup& soup, const FunctionSource& source);

}  // namespace crest::io
