// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write/planar_field_writer.hpp"

#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include "io/formats/files.hpp"
#include "io/write/formats.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::io {

vtkSmartPointer<vtkUnstructuredGrid> planar_field_grid(
    const std::vector<kernel::Vec2>& points, const std::vector<kernel::Triangle>& triangles,
    const std::string& name, const std::vector<kernel::Vec2>& vectors) {
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  for (const auto& p : points) places->InsertNextPoint(p[0], p[1], 0);
  vtkNew<vtkCellArray> cells;
  for (const auto& t : triangles) cells->InsertNextCell({t[0], t[1], t[2]});
  vtkNew<vtkDoubleArray> rows;
  rows->SetName(name.c_str());
  rows->SetNumberOfComponents(3);
  for (const auto& v : vectors) rows->InsertNextTuple3(v[0], v[1], 0);
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(places);
  grid->SetCells(VTK_TRIANGLE, cells);
  grid->GetPointData()->AddArray(rows);
  grid->GetPointData()->SetActiveVectors(name.c_str());
  return grid;
}

void write_planar_field(const std::string& path, const std::vector<kernel::Vec2>& points,
                        const std::vector<kernel::Triangle>& triangles, const std::string& name,
                        const std::vector<kernel::Vec2>& vectors) {
  if (lower_extension(path) != ".vtu")
    throw kernel::InputError(path + ": file: has an unknown extension; write .vtu");
  write_vtu(path, *planar_field_grid(points, triangles, name, vectors));
}

}  // namespace crest::io
