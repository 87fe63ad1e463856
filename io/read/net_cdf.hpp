// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Winds and currents from NetCDF, by the conventions for climate and forecast (CF) or as ICON
// writes them: u and v on a grid of longitudes and latitudes, or at cells, whose centres are
// triangulated (Delaunay).
#include "io/read/planar_field_reader.hpp"

namespace crest::io {

/// Points are longitude and latitude in degrees, or x and y; request.field: "U,V", two variables,
/// else known by their standard names or names. Other axes than the last ones are layers. Throws:
/// kernel::InputError without the file's name.
void read_net_cdf(const std::string& path, const VectorRequest& request, PlanarFieldFile& file);

}  // namespace crest::io
