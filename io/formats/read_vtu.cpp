// SPDX-License-Identifier: GPL-3.0-or-later
// VTK XML unstructured grids.
#include <vtkNew.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include "io/formats/bounded_reader.hpp"
#include "io/formats/files.hpp"
#include "io/formats/join_soups.hpp"
#include "io/formats/vtk_input.hpp"

namespace crest::io {
namespace {

/// Polyhedra come with arrays that VTK follows without a check.
void refuse_polyhedra(std::string_view bytes) {
  for (const char* name :
       {"Name=\"faces\"", "Name=\"faceoffsets\"", "Name='faces'", "Name='faceoffsets'"})
    if (bytes.find(name) != bytes.npos)
      fail("cells", "there are polyhedra", "give a surface of triangles");
}

}  // namespace

Soup read_vtu(std::string_view bytes, const FieldRequest& request) {
  refuse_polyhedra(bytes);
  Soup soup;
  vtkNew<BoundedReader<vtkXMLUnstructuredGridReader>> reader;
  reader->most = kCornersAByte * static_cast<double>(bytes.size());
  auto& grid = static_cast<vtkUnstructuredGrid&>(read_xml(*reader, bytes, "VTU", request, soup));
  take_cells(grid, soup.cells);
  leave_out_ghosts(soup);
  return soup;
}

}  // namespace crest::io
