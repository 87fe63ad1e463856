// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Plane triangle meshes with a vector at each vertex, from files (io/formats).
#include <optional>
#include <string>
#include <vector>

#include "kernel/arithmetic/vec3.hpp"
#include "kernel/geometry/index.hpp"

class vtkDataSet;

namespace crest::io {

struct Soup;  // io/formats/soup.hpp

/// How cells of grids are split: along the diagonal that rises or falls, or the shorter one.
enum class Diagonal { up, down, shorter };

struct VectorRequest {
  std::string field;           ///< of points; empty: the only one of 2 or 3 components
  bool cell_to_point = false;  ///< take a field of cells, as the mean around each point
  Diagonal diagonal = Diagonal::up;
  std::optional<int> slice = {};  ///< the layer of a grid that has several, from 0
  bool all = false;               ///< keep points that the file flags as bad
};

struct PlanarFieldFile {
  std::vector<kernel::Vec2> points, vectors;
  std::vector<kernel::Triangle> triangles;  ///< counter-clockwise
  std::string field;
  std::vector<std::int64_t> cell_of;  ///< each triangle's, as the file numbers cells
  std::vector<std::string> warnings;
};

/// Reads meshes (.vtu .vtp .vtk .msh .ply), whose quadrilaterals are split along the shorter
/// diagonal, VTK's grids (.vti .vtr .vts .vtk), NRRD (.nrrd .nhdr), NetCDF (.nc), winds (.json, as
/// grib2json writes them) and texts of particle image velocimetry (.txt .vec, by DaVis, Insight,
/// OpenPIV). Points that no cell uses
/// are left out, cells of grids with missing vectors become holes. Throws: kernel::InputError
/// "FILE: ELEMENT: PROBLEM; REMEDY", one line: no triangles, not in a plane z = constant, no such
/// field (with those there are), a vector or a point that is not finite, a triangle without area.
PlanarFieldFile read_planar_field(const std::string& path, const VectorRequest& request);

/// The same for a soup, and for a grid of VTK; messages do without the file's name.
PlanarFieldFile planar_field_of_soup(const Soup& soup, const VectorRequest& request);
PlanarFieldFile planar_field_of_grid(vtkDataSet& grid, const VectorRequest& request);

}  // namespace crest::io
