// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The ridge graph as polylines and points for other programs.
#include <string>

#include "algorithms/ridges/ridge_graph.hpp"
#include "kernel/geometry/triangle_mesh.hpp"

template <class T>
class vtkSmartPointer;
class vtkPolyData;

namespace crest::io {

/// Writes .vtp, .pvtp (io/write/vtk_pieces.hpp), .obj or .ply, by the extension in any case.
///
/// .vtp (ParaView opens it without a filter): one vertex cell an umbilic, then one polyline a
/// ridge: lead-in, crossings, lead-out; a loop ends with the point it starts with. Every array is
/// defined everywhere; neutral values are -1 for codes and ids, 0 for quantities.
///   points: colour (0 blue, 1 red), type and type_third_order of the segment that starts in the
///     point, crossing_type (0 flat, 1 elliptic, 2 hyperbolic, 3 turning), k1, k2, b (|b0| or
///     |b3|), P (P1 or P2), strength and sharpness of the ridge, significance,
///     crest_significance, prominence; index, kind (1, 3: 1-ridge, 3-ridge; 0 degenerate) and
///     coherent of an umbilic; level (0 dropped, 1 significant, 2 salient) of both.
///   cells: colour, loop, length, strength, sharpness, weight, end_kind_0, end_kind_1 (0 open,
///     1 umbilic, 2 boundary, 3 cut), end_umbilic_0, end_umbilic_1 (number of the umbilic),
///     umbilic (number of its own), index, kind, coherent.
///   field: data_digest, the digest a certificate of the run carries; fit_scale, fit_points: the
///     supports' radius or least number of points, 0 if neither was given.
/// .obj: v, p (umbilics, ridges of one point) and l lines, a group a colour. .ply: text, vertices
/// with the point data above, then an edge element with colour and type. Guarantees: the same bytes
/// for the same graph; no half-written file. Throws: kernel::InputError for another extension or a
/// place that cannot be written.
void write_ridges(const std::string& path, const kernel::TriangleMesh& mesh,
                  const ridges::FitResult& fit, const ridges::RidgeGraph& graph,
                  const std::string& data_digest_hex);

/// What the .vtp file holds.
vtkSmartPointer<vtkPolyData> ridge_poly_data(const kernel::TriangleMesh& mesh,
                                             const ridges::FitResult& fit,
                                             const ridges::RidgeGraph& graph,
                                             const std::string& data_digest_hex);

}  // namespace crest::io
