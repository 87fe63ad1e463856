// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Curvatures on their mesh, and focal surfaces, for other programs.
#include <string>
#include <vector>

#include "algorithms/curvature/curvature.hpp"
#include "algorithms/curvature/focal.hpp"

template <class T>
class vtkSmartPointer;
class vtkPolyData;

namespace crest::io {

/// Writes .vtp, .vtu, these in pieces (io/write/vtk_pieces.hpp) or .ply, by the extension in any
/// case.
///   points: k1, k2, K, H, asymmetry, d1, d2, Normals.
///   cells, if corners is not empty (.vtp and .vtu): corner_k1, corner_k2, corner_K, corner_H,
///     corner_asymmetry with 3 components, one a corner of the face, corner_d1 and corner_d2
///     with 9.
/// .ply is binary (little-endian): points as above (d1x .. d2z, nx ny nz), then the faces.
/// Guarantees: the same bytes for the same data; no half-written file; .vtp and .ply read back by
///   read_mesh and read_normals.
/// Throws: kernel::InputError for another extension or a place that cannot be written.
void write_curvature(const std::string& path, const kernel::TriangleMesh& mesh,
                     const curvature::Result& result,
                     const std::vector<curvature::CornerCurvatures>& corners);

/// What the .vtp file holds.
vtkSmartPointer<vtkPolyData> curvature_poly_data(
    const kernel::TriangleMesh& mesh, const curvature::Result& result,
    const std::vector<curvature::CornerCurvatures>& corners);

/// Writes focal surfaces as one .vtp: triangles and their boundary curves as polylines.
///   points: value (K or H), colour (RGB: green for positive, red for negative, grey for zero).
///   cells: quantity (0 Gaussian, 1 mean), face (of the mesh), curve (1: boundary curve).
///   field: scale, one a quantity.
/// Throws: kernel::InputError as above.
void write_focal(const std::string& path, const std::vector<curvature::FocalSurface>& surfaces);

}  // namespace crest::io
