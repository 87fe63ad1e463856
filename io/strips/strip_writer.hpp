// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Triangle strips as cells, as an index buffer and as a picture.
#include <string>
#include <vector>

#include "algorithms/strips/strips.hpp"
#include "io/picture/viewpoint.hpp"
#include "kernel/geometry/triangle_mesh.hpp"

template <class T>
class vtkSmartPointer;
class vtkPolyData;

namespace crest::io {

/// Writes .vtp: the mesh's points in their order, a triangle strip a strip; a swap is a repeated
/// vertex, whose triangle has no area.
///   cells: strip (its number), faces (how many it holds).
/// Guarantees: the same bytes for the same input; no half-written file.
/// Throws: kernel::InputError for another extension or a place that cannot be written.
void write_strips(const std::string& path, const std::vector<kernel::Vec3>& points,
                  const strips::Strips& strips);

/// What the .vtp file holds.
vtkSmartPointer<vtkPolyData> strip_poly_data(const std::vector<kernel::Vec3>& points,
                                             const strips::Strips& strips);

/// Writes the strips' vertices as unsigned 32-bit numbers, the lowest byte first, with 0xffffffff
/// between two strips (primitive restart). Guarantees, Throws: as write_strips.
void write_index_buffer(const std::string& path, const strips::Strips& strips);

/// Writes .png or .svg: each strip in a tint. Throws: kernel::InputError for another extension, a
/// place that cannot be written or a direction that is none.
void write_strip_picture(const std::string& path, const kernel::TriangleMesh& mesh,
                         const strips::Strips& strips, const Viewpoint& viewpoint = {});

struct Scene;  // io/page/scene.hpp

/// The same for a page: each strip in a tint, and the way through its faces as a line.
Scene strip_scene(const kernel::TriangleMesh& mesh, const strips::Strips& strips,
                  const Viewpoint& viewpoint);

}  // namespace crest::io
