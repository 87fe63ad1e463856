// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Vectors on a grid in the plane, and the triangles of its cells.
#include <string>
#include <vector>

#include "io/read/planar_field_reader.hpp"

namespace crest::io {

/// Row by row; vectors that are missing are NaN.
struct PlaneGrid {
  std::size_t nx = 0, ny = 0;
  std::vector<kernel::Vec2> points, vectors;
};

/// The cells whose four corners have vectors, two triangles each; others become holes, with a
/// warning. Rows and columns may run either way. Throws: kernel::InputError without the file's name
/// if there are no such cells.
void add_triangles(const PlaneGrid& grid, Diagonal diagonal, PlanarFieldFile& file);

/// x, y, u, v of points on a grid in any order: distinct coordinates make its columns and rows.
PlaneGrid grid_of_points(const std::vector<std::array<double, 4>>& points);

/// Readers of grids; each throws kernel::InputError without the file's name.
PlaneGrid read_wind_json(const std::string& path, PlanarFieldFile& file);
PlaneGrid read_particle_image_text(const std::string& path, const VectorRequest& request,
                                   PlanarFieldFile& file);
PlaneGrid read_vector_nrrd(const std::string& path, const VectorRequest& request,
                           PlanarFieldFile& file);
PlaneGrid read_vtk_grid(const std::string& path, const VectorRequest& request,
                        PlanarFieldFile& file);

/// Whether a legacy VTK file holds a grid.
bool is_legacy_grid(const std::string& path);

}  // namespace crest::io
