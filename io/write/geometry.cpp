// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write/geometry.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>

#include <stdexcept>

#include "io/formats/files.hpp"
#include "io/write/formats.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::io {
namespace {

template <class Array, class Value>
bool take(vtkAbstractArray& from, Column& to) {
  auto* const array = Array::SafeDownCast(&from);
  if (array == nullptr) return false;
  std::vector<Value> values;
  values.reserve(static_cast<std::size_t>(array->GetNumberOfValues()));
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i) values.push_back(array->GetValue(i));
  to.values = std::move(values);
  return true;
}

std::vector<Column> columns_of(vtkFieldData& data) {
  std::vector<Column> columns;
  for (int i = 0; i < data.GetNumberOfArrays(); ++i) {
    vtkAbstractArray& array = *data.GetAbstractArray(i);
    Column column{array.GetName(), static_cast<std::size_t>(array.GetNumberOfComponents()), {}};
    if (!take<vtkIntArray, int>(array, column) && !take<vtkDoubleArray, double>(array, column) &&
        !take<vtkUnsignedCharArray, unsigned char>(array, column) &&
        !take<vtkStringArray, std::string>(array, column))
      throw std::logic_error("an array of another type: " + column.name);
    columns.push_back(std::move(column));
  }
  return columns;
}

CellLists cells_of(vtkCellArray* array) {
  CellLists cells;
  if (array == nullptr) return cells;
  vtkIdType count = 0;
  const vtkIdType* points = nullptr;
  for (vtkIdType c = 0; c < array->GetNumberOfCells(); ++c) {
    array->GetCellAtId(c, count, points);
    cells.connectivity.insert(cells.connectivity.end(), points, points + count);
    cells.offsets.push_back(static_cast<std::int64_t>(cells.connectivity.size()));
  }
  return cells;
}

template <class Array, class Value>
vtkSmartPointer<vtkAbstractArray> array_of(const Column& column, const std::vector<Value>& values) {
  auto array = vtkSmartPointer<Array>::New();
  array->SetNumberOfComponents(static_cast<int>(column.components));
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size() / column.components));
  for (std::size_t i = 0; i < values.size(); ++i)
    array->SetValue(static_cast<vtkIdType>(i), values[i]);
  return array;
}

void add_columns(const std::vector<Column>& columns, vtkFieldData& data) {
  for (const Column& column : columns) {
    const auto array = std::visit(
        [&]<class Value>(const std::vector<Value>& values) {
          using Array = std::conditional_t<
              std::is_same_v<Value, int>, vtkIntArray,
              std::conditional_t<std::is_same_v<Value, double>, vtkDoubleArray,
                                 std::conditional_t<std::is_same_v<Value, unsigned char>,
                                                    vtkUnsignedCharArray, vtkStringArray>>>;
          return array_of<Array>(column, values);
        },
        column.values);
    array->SetName(column.name.c_str());
    data.AddArray(array);
  }
}

vtkSmartPointer<vtkCellArray> array_of(const CellLists& cells) {
  auto array = vtkSmartPointer<vtkCellArray>::New();
  for (std::size_t c = 0; c + 1 < cells.offsets.size(); ++c) {
    const std::int64_t* const first = cells.connectivity.data() + cells.offsets[c];
    const std::vector<vtkIdType> points(first, cells.connectivity.data() + cells.offsets[c + 1]);
    array->InsertNextCell(static_cast<vtkIdType>(points.size()), points.data());
  }
  return array;
}

}  // namespace

Geometry geometry_of(const vtkSmartPointer<vtkPolyData>& data) {
  Geometry g;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {
    const double* const p = data->GetPoint(i);
    g.points.insert(g.points.end(), p, p + 3);
  }
  g.vertices = cells_of(data->GetVerts());
  g.lines = cells_of(data->GetLines());
  g.polygons = cells_of(data->GetPolys());
  g.strips = cells_of(data->GetStrips());
  g.point_data = columns_of(*data->GetPointData());
  g.cell_data = columns_of(*data->GetCellData());
  g.field_data = columns_of(*data->GetFieldData());
  return g;
}

void write_geometry(const std::string& path, const Geometry& geometry) {
  if (lower_extension(path) != ".vtp")
    throw kernel::InputError(path + ": file: has an unknown extension; write .vtp");
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  for (std::size_t i = 0; i + 2 < geometry.points.size(); i += 3)
    points->InsertNextPoint(geometry.points.data() + i);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  const auto has = [](const CellLists& cells) { return cells.offsets.size() > 1; };
  if (has(geometry.vertices)) data->SetVerts(array_of(geometry.vertices));
  if (has(geometry.lines)) data->SetLines(array_of(geometry.lines));
  if (has(geometry.polygons)) data->SetPolys(array_of(geometry.polygons));
  if (has(geometry.strips)) data->SetStrips(array_of(geometry.strips));
  add_columns(geometry.point_data, *data->GetPointData());
  // VTK marks what it takes for normals by this name.
  if (data->GetPointData()->HasArray("Normals")) data->GetPointData()->SetActiveNormals("Normals");
  add_columns(geometry.cell_data, *data->GetCellData());
  add_columns(geometry.field_data, *data->GetFieldData());
  write_vtp(path, *data);
}

}  // namespace crest::io
