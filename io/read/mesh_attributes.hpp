// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The fields of a soup as attributes of the surface made from it.
#include <string>
#include <vector>

#include "io/clean/surface.hpp"
#include "kernel/geometry/attribute.hpp"

namespace crest::io {

/// Numbers of points, cells and corners at the vertices, faces and corners of the triangles; those
/// of corners at vertices where a vertex' corners agree, everywhere. A triangle of a polygon has
/// the polygon's. A number that the type its file states cannot hold makes the type wider.
/// `left_out`: names of those that are no numbers.
std::vector<kernel::Attribute> attributes_of(const Soup& soup, const Surface& surface,
                                             std::vector<std::string>& left_out);

}  // namespace crest::io
