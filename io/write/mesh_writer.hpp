// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Triangle meshes to files.
#include <span>
#include <string>
#include <vector>

#include "kernel/geometry/attribute.hpp"
#include "kernel/geometry/triangle_mesh.hpp"

namespace crest::io {

/// Writes OFF, OBJ, PLY (text) or VTP, by the extension in any case; text numbers are the shortest
/// decimals that read back as the same doubles.
/// Shapes: V points, F faces with indices below V. Guarantees: the same bytes for the same mesh;
/// no half-written file; numbers of attributes as they are, NaN and infinities, too.
/// Returns the names of attributes for which the format has no place: corners have one in OBJ
/// alone, which has none but for "Normals", "TCoords" and the vertices' "RGB"; OFF has none.
/// Throws: kernel::InputError for another extension or a place that cannot be written.
std::vector<std::string> write_mesh(const std::string& path,
                                    const std::vector<kernel::Vec3>& points,
                                    const std::vector<kernel::Triangle>& faces,
                                    std::span<const kernel::Attribute> attributes = {});

}  // namespace crest::io
