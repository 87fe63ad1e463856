// SPDX-License-Identifier: GPL-3.0-or-later
// VTK's grids: image data, rectilinear and structured grids, XML and legacy.
#include <fmt/format.h>
#include <vtkDataArray.h>
#include <vtkDataSetReader.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLRectilinearGridReader.h>
#include <vtkXMLStructuredGridReader.h>

#include <cmath>

#include "io/formats/files.hpp"
#include "io/formats/vtk_quiet.hpp"
#include "io/read/plane_grid.hpp"

namespace crest::io {
namespace {

std::string known_vectors(vtkPointData& data) {
  std::string names;
  for (int i = 0; i < data.GetNumberOfArrays(); ++i)
    if (data.GetArray(i) && (data.GetArray(i)->GetNumberOfComponents() == 2 ||
                             data.GetArray(i)->GetNumberOfComponents() == 3))
      names += fmt::format("{}'{}'", names.empty() ? "" : ", ",
                           data.GetArrayName(i) ? data.GetArrayName(i) : "");
  return names.empty() ? "the file has no vectors of points" : "the vectors of points are " + names;
}

vtkDataArray& vectors_of(vtkPointData& data, const std::string& wanted) {
  vtkDataArray* found = nullptr;
  for (int i = 0; i < data.GetNumberOfArrays(); ++i) {
    vtkDataArray* a = data.GetArray(i);
    if (!a) continue;
    const int n = a->GetNumberOfComponents();
    const std::string name = a->GetName() ? a->GetName() : "";
    if (wanted.empty() ? n != 2 && n != 3 : name != wanted) continue;
    if (found)
      fail("vectors", "there are several", known_vectors(data) + "; choose one with --vectors");
    found = a;
  }
  const std::string element = wanted.empty() ? "vectors" : fmt::format("array '{}'", wanted);
  if (!found) fail(element, "do not exist", known_vectors(data));
  if (found->GetNumberOfComponents() != 2 && found->GetNumberOfComponents() != 3)
    fail(element, fmt::format("has {} components", found->GetNumberOfComponents()),
         known_vectors(data));
  return *found;
}

PlaneGrid take(vtkDataSet& data, const VectorRequest& request, PlanarFieldFile& file) {
  int n[3] = {0, 0, 0};
  if (auto* image = vtkImageData::SafeDownCast(&data)) image->GetDimensions(n);
  if (auto* lines = vtkRectilinearGrid::SafeDownCast(&data)) lines->GetDimensions(n);
  if (auto* bent = vtkStructuredGrid::SafeDownCast(&data)) bent->GetDimensions(n);
  if (n[0] < 2 || n[1] < 2) fail("grid", "is not two-dimensional in x and y", "turn it");
  if (n[2] > 1 && !request.slice)
    fail("grid", fmt::format("has {} layers", n[2]), "choose one with --slice K, from 0");
  const int k = request.slice.value_or(0);
  if (k >= n[2]) fail("slice", fmt::format("{} does not exist", k), "layers count from 0");
  vtkDataArray& a = vectors_of(*data.GetPointData(), request.field);
  if (a.GetNumberOfTuples() != data.GetNumberOfPoints())
    fail("vectors", "are not one a point", "export the file again");
  file.field = a.GetName() ? a.GetName() : "";
  PlaneGrid grid{static_cast<std::size_t>(n[0]), static_cast<std::size_t>(n[1]), {}, {}};
  double height = 0;
  for (int j = 0; j < n[1]; ++j)
    for (int i = 0; i < n[0]; ++i) {
      const vtkIdType id =
          (static_cast<vtkIdType>(k) * n[1] + j) * static_cast<vtkIdType>(n[0]) + i;
      double p[3];
      data.GetPoint(id, p);
      if (i == 0 && j == 0) height = p[2];
      if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || p[2] != height)
        fail(fmt::format("point {}", id), "is not finite or not in one plane with the first",
             "give a plane grid");
      grid.points.push_back({p[0], p[1]});
      grid.vectors.push_back({a.GetComponent(id, 0), a.GetComponent(id, 1)});
    }
  return grid;
}

template <class Reader>
PlaneGrid read(const std::string& path, const VectorRequest& request, PlanarFieldFile& file) {
  load(path);  // says what is wrong with the file itself
  VtkQuiet quiet;
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  if constexpr (std::is_same_v<Reader, vtkDataSetReader>) {
    reader->ReadAllVectorsOn();
    reader->ReadAllFieldsOn();
  }
  reader->Update();
  vtkDataSet* data = vtkDataSet::SafeDownCast(reader->GetOutputDataObject(0));
  if (quiet.failed() || !data || data->GetNumberOfPoints() == 0)
    fail("file", "VTK cannot read it: " + quiet.complaint(), "export it again");
  return take(*data, request, file);
}

}  // namespace

PlanarFieldFile planar_field_of_grid(vtkDataSet& grid, const VectorRequest& request) {
  PlanarFieldFile file;
  add_triangles(take(grid, request, file), request.diagonal, file);
  return file;
}

bool is_legacy_grid(const std::string& path) {
  const FileBytes bytes = load(path);
  const std::string_view head = std::string_view(bytes).substr(0, 1000);
  return head.find("DATASET STRUCTURED_POINTS") != head.npos ||
         head.find("DATASET RECTILINEAR_GRID") != head.npos ||
         head.find("DATASET STRUCTURED_GRID") != head.npos;
}

PlaneGrid read_vtk_grid(const std::string& path, const VectorRequest& request,
                        PlanarFieldFile& file) {
  const std::string end = lower_extension(path);
  if (end == ".vti") return read<vtkXMLImageDataReader>(path, request, file);
  if (end == ".vtr") return read<vtkXMLRectilinearGridReader>(path, request, file);
  if (end == ".vts") return read<vtkXMLStructuredGridReader>(path, request, file);
  return read<vtkDataSetReader>(path, request, file);
}

}  // namespace crest::io
