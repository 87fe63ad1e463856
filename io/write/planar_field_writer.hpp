// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Plane meshes with a vector at each point, to .vtu.
#include <string>
#include <vector>

#include "kernel/arithmetic/vec3.hpp"
#include "kernel/geometry/index.hpp"

template <class T>
class vtkSmartPointer;
class vtkUnstructuredGrid;

namespace crest::io {

/// Guarantees: no half-written file. Throws: kernel::InputError for another extension or a place
/// that cannot be written.
void write_planar_field(const std::string& path, const std::vector<kernel::Vec2>& points,
                        const std::vector<kernel::Triangle>& triangles, const std::string& name,
                        const std::vector<kernel::Vec2>& vectors);

/// What the .vtu file holds.
vtkSmartPointer<vtkUnstructuredGrid> planar_field_grid(
    const std::vector<kernel::Vec2>& points, const std::vector<kernel::Triangle>& triangles,
    const std::string& name, const std::vector<kernel::Vec2>& vectors);

}  // namespace crest::io
