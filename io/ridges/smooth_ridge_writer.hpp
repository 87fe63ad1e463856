// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The ridge graph of a smooth surface, and the triangulation that proves it, for other programs.
#include <string>

#include "algorithms/smooth_ridges/smooth_ridges_result.hpp"

template <class T>
class vtkSmartPointer;
class vtkPolyData;

namespace crest::io {

/// What the arrays `kind` say; 1 and 3: 1-ridge and 3-ridge umbilics.
enum SmoothKind { kRidgePart = -1, kTurningPoint = 4, kPurplePoint = 5, kUndecidedCell = 6 };

/// Writes .vtp, .obj or .ply, by the extension in any case. Names and neutral values (-1 for codes
/// and ids, 0 for quantities) as write_ridges() has them.
///
/// .vtp (ParaView opens it without a filter): vertex cells for umbilics, turning points, purple
/// points and undecided cells, then polylines: a ridge is cut where its type changes.
///   points and cells: kind (-1 ridge, 1 and 3 umbilics, 4 turning, 5 purple, 6 undecided), colour
///   (0
///     blue, 1 red; of a turning point, too), type (0 none, 1 elliptic, 2 hyperbolic, 3 a segment
///     with a turning point on it; of a point: of the segment that starts there), index,
///     twice_index, blue_branches, red_branches of an umbilic, size of an undecided cell.
///   cells also: ridge (its number), loop, end_kind_0, end_kind_1 (0 open, 1 umbilic, 2 boundary),
///     end_umbilic_0, end_umbilic_1 of the whole ridge; length of the part; umbilic (its number).
///   field: certified (0 or 1), undecided (number of cells), data_digest (of the certificate; empty
///     if there is none).
/// .obj: v, p and l lines, a group a kind or colour. .ply: text, vertices with the point data
/// above, then an edge element with colour and type. Both say in a comment if the result is not
/// certified. Guarantees: the same bytes for the same result; no half-written file. Throws:
/// kernel::InputError for another extension or a place that cannot be written.
void write_smooth_ridges(const std::string& path, const smooth_ridges::SmoothRidges& result,
                         const std::string& data_digest_hex);

/// Writes the triangulation as write_mesh() does; .vtp with cell arrays in_patch and undecided (0
/// or 1) and the field data above.
/// Throws: kernel::InputError for another extension or a place that cannot be written.
void write_smooth_mesh(const std::string& path, const smooth_ridges::SmoothRidges& result,
                       const std::string& data_digest_hex);

/// What the two .vtp files hold.
vtkSmartPointer<vtkPolyData> smooth_ridge_poly_data(const smooth_ridges::SmoothRidges& result,
                                                    const std::string& data_digest_hex);
vtkSmartPointer<vtkPolyData> smooth_mesh_poly_data(const smooth_ridges::SmoothRidges& result,
                                                   const std::string& data_digest_hex);

}  // namespace crest::io
