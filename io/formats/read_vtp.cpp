// SPDX-License-Identifier: GPL-3.0-or-later
// VTK XML polygonal data.
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include "io/formats/files.hpp"
#include "io/formats/vtk_input.hpp"

namespace crest::io {

/// The polygons: vertices and lines beside them are what other programs draw.
Soup read_vtp(std::string bytes, const FieldRequest& request) {
  Soup soup;
  vtkNew<vtkXMLPolyDataReader> reader;
  auto& data = static_cast<vtkPolyData&>(read_vtk(*reader, bytes, "VTP", request, soup));
  if (data.GetNumberOfStrips() > 0)
    fail("faces", "there are triangle strips", "convert these to triangles");
  const auto type_of = [](std::size_t, std::size_t nodes) {
    return nodes == 3 ? CellType::triangle : nodes == 4 ? CellType::quad : CellType::polygon;
  };
  if (data.GetNumberOfPolys() > 0) take_cells(*data.GetPolys(), "face", type_of, soup.cells);
  return soup;
}

}  // namespace crest::io
