// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What a .vtp file holds as plain arrays, for those who know no data sets of VTK.
#include <vtkSmartPointer.h>

#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

class vtkPolyData;

namespace crest::io {

/// Numbers or texts with a name; so many components an element.
struct Column {
  std::string name;
  std::size_t components = 1;
  std::variant<std::vector<int>, std::vector<double>, std::vector<unsigned char>,
               std::vector<std::string>>
      values;
};

/// Cell i has the points connectivity[offsets[i]] .. connectivity[offsets[i + 1] - 1].
struct CellLists {
  std::vector<std::int64_t> offsets{0}, connectivity;
};

struct Geometry {
  std::vector<double> points;                   ///< three a point
  CellLists vertices, lines, polygons, strips;  ///< the order of the cells' columns, too
  std::vector<Column> point_data, cell_data;    ///< an element a point, a cell
  std::vector<Column> field_data;               ///< of the whole
};

Geometry geometry_of(const vtkSmartPointer<vtkPolyData>& data);

/// The .vtp file of geometry_of(data) is that of data.
/// Throws: kernel::InputError for another extension than .vtp, a place that cannot be written;
/// std::runtime_error as vtp_bytes() does.
void write_geometry(const std::string& path, const Geometry& geometry);

}  // namespace crest::io
