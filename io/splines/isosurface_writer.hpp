// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Isosurfaces of splines to files.
#include <string>

#include "algorithms/splines/isosurface.hpp"
#include "io/picture/viewpoint.hpp"

template <class T>
class vtkSmartPointer;
class vtkPolyData;

namespace crest::io {

/// .vtp (with the gradients `gradient`), .obj or .ply. `data_digest`: of the certificate, or empty.
/// Guarantees: the same bytes for the same surface; no half-written file. Throws:
/// kernel::InputError for another extension or a place that cannot be written.
void write_isosurface(const std::string& path, const splines::Isosurface& surface,
                      const std::string& data_digest);

/// What the .vtp file holds.
vtkSmartPointer<vtkPolyData> isosurface_poly_data(const splines::Isosurface& surface,
                                                  const std::string& data_digest);

struct Scene;  // io/page/scene.hpp

/// The mesh for a page, with the lengths of its gradients.
Scene isosurface_scene(const splines::Isosurface& surface, const Viewpoint& viewpoint);

}  // namespace crest::io
