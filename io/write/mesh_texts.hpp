// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Triangle meshes with attributes in the formats of meshes.
#include <span>
#include <string>
#include <vector>

#include "kernel/geometry/attribute.hpp"
#include "kernel/geometry/triangle_mesh.hpp"

namespace crest::io {

using MeshPoints = std::vector<kernel::Vec3>;
using MeshFaces = std::vector<kernel::Triangle>;
using Attributes = std::span<const kernel::Attribute>;
using LeftOut = std::vector<std::string>;  ///< names of attributes without a place in the format

std::string off_text(const MeshPoints& points, const MeshFaces& faces, Attributes attributes,
                     LeftOut& left_out);
std::string obj_text(const MeshPoints& points, const MeshFaces& faces, Attributes attributes,
                     LeftOut& left_out);
/// Properties are numbers, one a name: components get one each.
std::string ply_text(const MeshPoints& points, const MeshFaces& faces, Attributes attributes,
                     LeftOut& left_out);
/// This one is a file at once: it need not be in memory as a whole.
void write_vtp_mesh(const std::string& path, const MeshPoints& points, const MeshFaces& faces,
                    Attributes attributes, LeftOut& left_out);

}  // namespace crest::io
