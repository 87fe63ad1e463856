// SPDX-License-Identifier: GPL-3.0-or-later
// VTK XML polygonal data.
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include "io/formats/vtk_input.hpp"

namespace crest::io {

Soup read_vtp(std::string_view bytes, const FieldRequest& request) {
  Soup soup;
  vtkNew<vtkXMLPolyDataReader> reader;
  auto& data = static_cast<vtkPolyData&>(read_xml(*reader, bytes, "VTP", request, soup));
  const auto take = [&](vtkCellArray* cells, const char* element, PolyKind kind) {
    const auto type_of = [kind](std::size_t, std::size_t nodes) { return poly_type(kind, nodes); };
    if (cells && cells->GetNumberOfCells() > 0) take_cells(*cells, element, type_of, soup.cells);
  };
  take(data.GetVerts(), "vertex cell", PolyKind::vertices);
  take(data.GetLines(), "line", PolyKind::lines);
  take(data.GetPolys(), "face", PolyKind::polygons);
  take(data.GetStrips(), "strip", PolyKind::strips);
  return soup;
}

}  // namespace crest::io
