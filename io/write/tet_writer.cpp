// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write/tet_writer.hpp"

#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

#include "io/formats/files.hpp"
#include "io/write/formats.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::io {

void write_tets(const std::string& path, const std::vector<kernel::Vec3>& points,
                const std::vector<std::array<std::uint32_t, 4>>& tets, const std::string& name,
                const std::vector<std::array<double, 6>>& tensors) {
  if (lower_extension(path) != ".vtu")
    throw kernel::InputError(path + ": file: has an unknown extension; write .vtu");
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  for (const auto& p : points) places->InsertNextPoint(p.data());
  vtkNew<vtkCellArray> cells;
  for (const auto& t : tets) cells->InsertNextCell({t[0], t[1], t[2], t[3]});
  vtkNew<vtkDoubleArray> rows;
  rows->SetName(name.c_str());
  rows->SetNumberOfComponents(6);
  for (const auto& t : tensors) rows->InsertNextTuple(t.data());
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(places);
  grid->SetCells(VTK_TETRA, cells);
  grid->GetPointData()->AddArray(rows);
  grid->GetPointData()->SetActiveTensors(name.c_str());
  write_vtu(path, *grid);
}

}  // namespace crest::io
