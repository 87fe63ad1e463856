// SPDX-License-Identifier: GPL-3.0-or-later
// VTK XML polygonal data.
#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkDataArraySelection.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <charconv>

#include "io/polygon_soup.hpp"
#include "io/text_scan.hpp"
#include "io/vtk_quiet.hpp"

namespace crest::io {
namespace {

/// Sum of the values of an XML attribute over all its occurrences, capped.
std::uint64_t attribute_sum(std::string_view bytes, std::string_view name) {
  constexpr std::uint64_t cap = std::uint64_t{1} << 62;
  std::uint64_t sum = 0;
  for (std::size_t at = bytes.find(name); at != std::string_view::npos;
       at = bytes.find(name, at + 1)) {
    std::size_t i = at + name.size();
    while (i < bytes.size() && (bytes[i] == ' ' || bytes[i] == '=' || bytes[i] == '"' ||
                                bytes[i] == '\'' || bytes[i] == '\t' || bytes[i] == '\n')) {
      ++i;
    }
    std::uint64_t value = 0;
    const auto result = std::from_chars(bytes.data() + i, bytes.data() + bytes.size(), value);
    if (result.ec == std::errc::result_out_of_range) value = cap;
    sum = std::min(cap, sum + std::min(value, cap));
  }
  return sum;
}

/// VTK allocates what the header announces; a file compressed with zlib holds at most some 100
/// points a byte.
void check_announced(const std::string& bytes) {
  const bool compressed = bytes.find("compressor") != std::string::npos;
  const std::uint64_t room = bytes.size() * (compressed ? 100 : 1);
  for (const char* name : {"NumberOfPoints", "NumberOfVerts", "NumberOfLines", "NumberOfStrips",
                           "NumberOfPolys", "NumberOfTuples"}) {
    const std::uint64_t count = attribute_sum(bytes, name);
    if (count > room) {
      fail("header", fmt::format("{} is {}, more than the file holds", name, count),
           "the file is truncated or its header wrong; export the mesh again");
    }
  }
  if (attribute_sum(bytes, "NumberOfComponents") > room) {
    fail("header", "NumberOfComponents is more than the file holds", "export the mesh again");
  }
}

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
    if (begin < 0 || end < begin || end > size) {
      fail(element, "its offsets are wrong", "export the mesh again");
    }
    check_corner_count(end - begin, element);
    faces.push_back(corners_of(*connectivity, begin));
  }
}

}  // namespace

PolygonSoup read_vtp(std::string bytes) {
  check_announced(bytes);
  const VtkQuiet quiet;
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(bytes);
  reader->UpdateInformation();
  reader->GetPointDataArraySelection()->DisableAllArrays();
  reader->GetCellDataArraySelection()->DisableAllArrays();
  reader->Update();
  vtkPolyData* data = reader->GetOutput();
  if (quiet.failed() || reader->GetErrorCode() != 0 || !data) {
    fail("file", "cannot be read as VTP (wrong format, truncated or damaged)",
         "export the mesh again");
  }
  if (data->GetNumberOfStrips() > 0) {
    fail("faces", "there are triangle strips", "convert these to triangles");
  }
  PolygonSoup soup;
  if (data->GetNumberOfPolys() > 0) read_faces(*data->GetPolys(), soup.faces);
  soup.points.reserve(static_cast<std::size_t>(data->GetNumberOfPoints()));
  for (vtkIdType v = 0; v < data->GetNumberOfPoints(); ++v) {
    double p[3];
    data->GetPoint(v, p);
    soup.points.emplace_back(p[0], p[1], p[2]);
  }
  return soup;
}

}  // namespace crest::io
