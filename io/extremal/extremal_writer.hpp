// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Extremal curves and surfaces to files.
#include <string>

#include "algorithms/extremal/extremal_result.hpp"

template <class T>
class vtkSmartPointer;
class vtkPolyData;

namespace crest::io {

/// .vtp: polygons (in 2D segments) with the cell arrays critical_type, component, strength, s,
/// plateness, feature (0), the point array normal; every edge of valence other than 2 as a line (in
/// 2D: a vertex) with its reason in feature, the other arrays -1 or 0 there. The field data_digest,
/// unless it is empty, is the certificate's. .obj, .ply: points and polygons alone.
/// Guarantees: the same bytes for the same result; no half-written file. Throws:
/// kernel::InputError for another extension or a place that cannot be written.
void write_extremal(const std::string& path, const extremal::Result& result,
                    const std::string& data_digest = {});

/// What the .vtp file holds.
vtkSmartPointer<vtkPolyData> extremal_poly_data(const extremal::Result& result,
                                                const std::string& data_digest);

}  // namespace crest::io
