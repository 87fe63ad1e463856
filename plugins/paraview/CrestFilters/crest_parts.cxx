// SPDX-License-Identifier: GPL-3.0-or-later
#include "crest_parts.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace {

std::vector<vtkIdType> chosen_cells(vtkPolyData& whole, const char* array,
                                    std::initializer_list<int> values, bool wanted) {
  std::vector<vtkIdType> cells;
  vtkDataArray* codes = whole.GetCellData()->GetArray(array);
  if (whole.GetNumberOfCells() > 0 && !codes)
    throw std::logic_error(std::string("cells without the array ") + array);
  for (vtkIdType c = 0; c < whole.GetNumberOfCells(); ++c) {
    const double code = codes->GetComponent(c, 0);
    const bool listed = std::find(values.begin(), values.end(), code) != values.end();
    if (listed == wanted) cells.push_back(c);
  }
  return cells;
}

void take(vtkPolyData& whole, const std::vector<vtkIdType>& cells, vtkPolyData& part) {
  std::vector<vtkIdType> number(static_cast<std::size_t>(whole.GetNumberOfPoints()), -1);
  vtkNew<vtkIdList> corners;
  for (const vtkIdType c : cells) {
    whole.GetCellPoints(c, corners);
    for (const vtkIdType p : *corners) number[static_cast<std::size_t>(p)] = 0;
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  part.GetPointData()->CopyAllOn();
  part.GetPointData()->CopyAllocate(whole.GetPointData());
  for (std::size_t p = 0; p < number.size(); ++p) {
    if (number[p] < 0) continue;
    const auto old = static_cast<vtkIdType>(p);
    number[p] = points->InsertNextPoint(whole.GetPoint(old));
    part.GetPointData()->CopyData(whole.GetPointData(), old, number[p]);
  }
  part.SetPoints(points);
  part.AllocateEstimate(static_cast<vtkIdType>(cells.size()), 4);
  part.GetCellData()->CopyAllOn();
  part.GetCellData()->CopyAllocate(whole.GetCellData());
  for (const vtkIdType c : cells) {  // in VTK's order of kinds, as they are in the whole
    whole.GetCellPoints(c, corners);
    for (vtkIdType i = 0; i < corners->GetNumberOfIds(); ++i)
      corners->SetId(i, number[static_cast<std::size_t>(corners->GetId(i))]);
    const vtkIdType made = part.InsertNextCell(whole.GetCellType(c), corners);
    part.GetCellData()->CopyData(whole.GetCellData(), c, made);
  }
  part.GetFieldData()->ShallowCopy(whole.GetFieldData());
}

}  // namespace

void take_part(vtkPolyData& whole, const char* array, std::initializer_list<int> values,
               vtkPolyData& part) {
  take(whole, chosen_cells(whole, array, values, true), part);
}

void take_rest(vtkPolyData& whole, const char* array, std::initializer_list<int> values,
               vtkPolyData& part) {
  take(whole, chosen_cells(whole, array, values, false), part);
}
