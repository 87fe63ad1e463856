// SPDX-License-Identifier: GPL-3.0-or-later
// VTK XML unstructured grids: linear (cell type 5) and quadratic (22) triangles.
#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include "io/formats/field_soup.hpp"
#include "io/formats/vtk_quiet.hpp"

namespace crest::io {
namespace {

using kernel::Index;
using kernel::kNone;

/// Polyhedra come with arrays that VTK follows without a check.
void refuse_polyhedra(const std::string& bytes) {
  for (const char* name :
       {"Name=\"faces\"", "Name=\"faceoffsets\"", "Name='faces'", "Name='faceoffsets'"})
    if (bytes.find(name) != std::string::npos)
      fail("cells", "there are polyhedra", "give a surface of triangles");
}

bool is_thin(int type) {
  return type == VTK_EMPTY_CELL || type == VTK_VERTEX || type == VTK_POLY_VERTEX ||
         type == VTK_LINE || type == VTK_POLY_LINE || type == VTK_QUADRATIC_EDGE;
}

void add_triangle(const std::vector<std::int64_t>& nodes, bool quadratic,
                  const std::string& element, FieldSoup& soup) {
  const std::size_t wanted = quadratic ? 6 : 3;
  if (nodes.size() != wanted) {
    const bool bare = quadratic && nodes.size() < 6;
    fail(element, fmt::format("has {} nodes instead of {}", nodes.size(), wanted),
         bare ? "its mid-side nodes are missing, add them or make it linear"
              : "export the mesh again");
  }
  Corners corners;
  corners.resize(3);
  for (std::size_t k = 0; k < 3; ++k) corners[k] = nodes[k];
  std::array<Index, 3> middle = {kNone, kNone, kNone};
  for (std::size_t k = 0; quadratic && k < 3; ++k) {
    const std::int64_t node = nodes[3 + k];
    if (node < 0 || node >= static_cast<std::int64_t>(soup.soup.points.size())) {
      fail(element, fmt::format("mid-side node {} (counted from 0) does not exist", node),
           "add it or make the cell linear");
    }
    middle[k] = static_cast<Index>(node);
  }
  soup.soup.faces.push_back(corners);
  soup.midside.push_back(middle);
}

void read_cells(vtkUnstructuredGrid& grid, FieldSoup& soup) {
  vtkCellArray* cells = grid.GetCells();
  vtkUnsignedCharArray* types = grid.GetCellTypesArray();
  if (!cells || !types) return;
  if (types->GetNumberOfTuples() != cells->GetNumberOfCells())
    fail("cells", "have not one type each", "export the mesh again");
  std::size_t thin = 0, quadratic = 0;
  for (vtkIdType c = 0; c < cells->GetNumberOfCells(); ++c) {
    const int type = types->GetValue(c);
    const std::string element = fmt::format("cell {}", c);
    if (is_thin(type)) {
      ++thin;
    } else if (type == VTK_TRIANGLE || type == VTK_QUADRATIC_TRIANGLE) {
      add_triangle(cell_nodes(*cells, c, element), type == VTK_QUADRATIC_TRIANGLE, element, soup);
      quadratic += type == VTK_QUADRATIC_TRIANGLE;
      soup.soup.face_tags.push_back(c);
    } else {
      fail(element, fmt::format("has type {}", type),
           "give triangles, linear (type 5) or quadratic (22)");
    }
  }
  if (quadratic == 0) soup.midside.clear();
  if (thin == 0) soup.soup.face_tags.clear();
  if (thin > 0) soup.warnings.push_back(fmt::format("left out {} points and lines", thin));
}

}  // namespace

FieldSoup read_vtu(std::string bytes, const FieldRequest& request) {
  check_vtp(bytes);
  refuse_polyhedra(bytes);
  const VtkQuiet quiet;
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(bytes);
  reader->UpdateInformation();
  select_fields(*reader, request);
  reader->Update();
  vtkUnstructuredGrid* grid = reader->GetOutput();
  if (quiet.failed() || reader->GetErrorCode() != 0 || !grid) {
    fail("file", "cannot be read as VTU (wrong format, truncated or damaged)",
         "export the mesh again");
  }
  FieldSoup soup;
  soup.soup.points.reserve(static_cast<std::size_t>(grid->GetNumberOfPoints()));
  for (vtkIdType v = 0; v < grid->GetNumberOfPoints(); ++v) {
    double p[3];
    grid->GetPoint(v, p);
    soup.soup.points.emplace_back(p[0], p[1], p[2]);
  }
  read_cells(*grid, soup);
  take_field(*reader, *grid->GetPointData(), request, soup);
  return soup;
}

}  // namespace crest::io
