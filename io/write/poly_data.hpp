// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Points, polylines, polygons and triangle strips, with a row of numbers each, as a .vtp file: the
// one way there from what systems draw.
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <array>
#include <span>
#include <string>
#include <vector>

#include "io/write/vtk_columns.hpp"
#include "kernel/geometry/triangle_mesh.hpp"

namespace crest::io {

/// Cells may come in any order: VTK numbers vertices, then lines, polygons, strips, and so
/// stand their rows. Either every point (cell) has a row or none, with the same columns.
class PolyData {
 public:
  using Id = vtkIdType;

  PolyData();
  Id add_point(const kernel::Vec3& place);
  void add_points(const std::vector<kernel::Vec3>& places);
  Id point_count() const { return points_->GetNumberOfPoints(); }
  /// Where the points' rows go.
  Columns& point_rows() { return point_rows_; }
  /// One value a point that is no number or several; after the rows' columns.
  void add_point_array(vtkDataArray* array) { point_arrays_.emplace_back(array); }

  /// Each returns where the cell's row goes. A polyline of one point becomes a vertex: VTK has no
  /// such line, and fails on one. Requires: at least one point, and points that were added.
  /// Throws: std::logic_error otherwise.
  Columns& add_vertex(Id point);
  Columns& add_line(std::span<const Id> points);
  Columns& add_triangle(Id a, Id b, Id c);
  Columns& add_polygon(std::span<const Id> corners);
  Columns& add_strip(std::span<const Id> points);

  /// Numbers and texts of the whole.
  Columns& fields() { return fields_; }

  /// All of it; the rows are gone then.
  vtkSmartPointer<vtkPolyData> data();

  /// The file, of data(). Throws: std::runtime_error as vtp_bytes() does.
  std::string bytes();

 private:
  enum Kind { kVertex, kLine, kPolygon, kStrip };
  Columns& add_cell(Kind kind, std::span<const Id> points);

  vtkNew<vtkPoints> points_;
  std::array<vtkNew<vtkCellArray>, 4> cells_;
  std::array<Columns, 4> cell_rows_;
  Columns point_rows_, fields_;
  std::vector<vtkSmartPointer<vtkDataArray>> point_arrays_;
};

}  // namespace crest::io
