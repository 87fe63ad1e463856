// SPDX-License-Identifier: GPL-3.0-or-later
// VTK XML polygonal data.
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include "io/formats/bounded_reader.hpp"
#include "io/formats/join_soups.hpp"
#include "io/formats/vtk_input.hpp"

namespace crest::io {

Soup read_vtp(std::string_view bytes, const FieldRequest& request) {
  Soup soup;
  vtkNew<BoundedReader<vtkXMLPolyDataReader>> reader;
  reader->most = kCornersAByte * static_cast<double>(bytes.size());
  auto& data = static_cast<vtkPolyData&>(read_xml(*reader, bytes, "VTP", request, soup));
  take_cells(data, soup.cells);
  leave_out_ghosts(soup);
  return soup;
}

}  // namespace crest::io
