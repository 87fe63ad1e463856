// SPDX-License-Identifier: GPL-3.0-or-later
// VTK XML polygonal data.
#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include "io/formats/field_soup.hpp"
#include "io/formats/text_scan.hpp"
#include "io/formats/vtk_quiet.hpp"

namespace crest::io {
namespace {

Corners corners_of(const vtkDataArray& connectivity, std::int64_t begin) {
  Corners corners;
  corners.resize(3);
  for (std::size_t k = 0; k < 3; ++k) {
    // GetTuple1 is not const in VTK 9.1.
    corners[k] = static_cast<std::int64_t>(
        const_cast<vtkDataArray&>(connectivity).GetTuple1(begin + static_cast<vtkIdType>(k)));
  }
  return corners;
}

/// Offsets as the file gives them: VTK does not check them.
void read_faces(vtkCellArray& cells, std::vector<Corners>& faces) {
  vtkDataArray* offsets = cells.GetOffsetsArray();
  vtkDataArray* connectivity = cells.GetConnectivityArray();
  if (!offsets || !connectivity) fail("faces", "cannot be read", "export the mesh again");
  const vtkIdType size = connectivity->GetNumberOfTuples();
  faces.reserve(static_cast<std::size_t>(cells.GetNumberOfCells()));
  for (vtkIdType f = 0; f < cells.GetNumberOfCells(); ++f) {
    const auto begin = static_cast<vtkIdType>(offsets->GetTuple1(f));
    const auto end = static_cast<vtkIdType>(offsets->GetTuple1(f + 1));
    const std::string element = fmt::format("face {}", f);
    if (begin < 0 || end < begin || end > size)
      fail(element, "its offsets are wrong", "export the mesh again");
    check_corner_count(end - begin, element);
    faces.push_back(corners_of(*connectivity, begin));
  }
}

}  // namespace

FieldSoup read_vtp_field(std::string bytes, const FieldRequest& request) {
  check_vtp(bytes);
  const VtkQuiet quiet;
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(bytes);
  reader->UpdateInformation();
  select_fields(*reader, request);
  reader->Update();
  vtkPolyData* data = reader->GetOutput();
  if (quiet.failed() || reader->GetErrorCode() != 0 || !data) {
    fail("file", "cannot be read as VTP (wrong format, truncated or damaged)",
         "export the mesh again");
  }
  if (data->GetNumberOfStrips() > 0)
    fail("faces", "there are triangle strips", "convert these to triangles");
  FieldSoup result;
  PolygonSoup& soup = result.soup;
  if (data->GetNumberOfPolys() > 0) read_faces(*data->GetPolys(), soup.faces);
  soup.points.reserve(static_cast<std::size_t>(data->GetNumberOfPoints()));
  for (vtkIdType v = 0; v < data->GetNumberOfPoints(); ++v) {
    double p[3];
    data->GetPoint(v, p);
    soup.points.emplace_back(p[0], p[1], p[2]);
  }
  take_field(*reader, *data->GetPointData(), request, result);
  return result;
}

PolygonSoup read_vtp(std::string bytes) {
  return read_vtp_field(std::move(bytes), {}).soup;
}

}  // namespace crest::io
