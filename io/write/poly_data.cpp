// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write/poly_data.hpp"

#include <vtkCellData.h>
#include <vtkPointData.h>

#include <stdexcept>

#include "io/write/formats.hpp"

namespace crest::io {

PolyData::PolyData() {
  points_->SetDataTypeToDouble();
}

PolyData::Id PolyData::add_point(const kernel::Vec3& place) {
  return points_->InsertNextPoint(place.data());
}

void PolyData::add_points(const std::vector<kernel::Vec3>& places) {
  for (const kernel::Vec3& place : places) add_point(place);
}

Columns& PolyData::add_vertex(Id point) {
  return add_cell(kVertex, {&point, 1});
}

Columns& PolyData::add_line(std::span<const Id> points) {
  return add_cell(points.size() == 1 ? kVertex : kLine, points);
}

Columns& PolyData::add_triangle(Id a, Id b, Id c) {
  return add_cell(kPolygon, std::array{a, b, c});
}

Columns& PolyData::add_polygon(std::span<const Id> corners) {
  return add_cell(kPolygon, corners);
}

Columns& PolyData::add_strip(std::span<const Id> points) {
  return add_cell(kStrip, points);
}

Columns& PolyData::add_cell(Kind kind, std::span<const Id> points) {
  if (points.empty()) throw std::logic_error("a cell without points");
  for (const Id p : points)
    if (p < 0 || p >= point_count())
      throw std::logic_error("a cell with a point that is not there");
  cells_[kind]->InsertNextCell(static_cast<Id>(points.size()), points.data());
  return cell_rows_[kind];
}

vtkSmartPointer<vtkPolyData> PolyData::data() {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points_);
  if (cells_[kVertex]->GetNumberOfCells() > 0) data->SetVerts(cells_[kVertex]);
  if (cells_[kLine]->GetNumberOfCells() > 0) data->SetLines(cells_[kLine]);
  if (cells_[kPolygon]->GetNumberOfCells() > 0) data->SetPolys(cells_[kPolygon]);
  if (cells_[kStrip]->GetNumberOfCells() > 0) data->SetStrips(cells_[kStrip]);
  point_rows_.move_to(*data->GetPointData());
  for (const auto& array : point_arrays_) data->GetPointData()->AddArray(array);
  Columns cell_rows;
  for (const Columns& rows : cell_rows_) cell_rows.append(rows);
  cell_rows.move_to(*data->GetCellData());
  fields_.move_to(*data->GetFieldData());
  return data;
}

std::string PolyData::bytes() {
  return vtp_bytes(*data());
}

}  // namespace crest::io
