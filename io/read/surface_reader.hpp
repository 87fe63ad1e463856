// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Triangle surfaces of which nothing may be lost: faces of area zero stay, and what a mesh would be
// mended for is refused.
#include <string>
#include <vector>

#include "io/clean/clean_up.hpp"
#include "io/clean/surface.hpp"
#include "kernel/arithmetic/vec3.hpp"
#include "kernel/geometry/attribute.hpp"

namespace crest::io {

struct SurfaceFile {
  std::vector<kernel::Vec3> points;
  std::vector<kernel::Triangle> faces;
  std::vector<kernel::Attribute> attributes;  ///< if asked for
  FileNumbers numbers;
  CleanUp cleanup;
  std::vector<std::string> warnings;
};

/// An oriented manifold, every vertex used and finite. Polygons are cut into triangles, cells of
/// other dimensions and vertices that no face uses left out, one warning each; so are the file's
/// numbers unless they are asked for.
/// Throws: kernel::InputError as read_mesh(), and for faces with repeated corners or with the
///   vertices of another, vertices of several fans, faces that disagree with their neighbours.
SurfaceFile read_surface(const std::string& path, bool with_attributes = false);

}  // namespace crest::io
