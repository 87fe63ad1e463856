// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read/point_field.hpp"

#include <fmt/format.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include "io/formats/vtk_quiet.hpp"
#include "io/write/formats.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::io {
namespace {

using kernel::InputError;

/// Of the arrays with one number a point.
std::string available(vtkPointData& data) {
  std::string names;
  for (int i = 0; i < data.GetNumberOfArrays(); ++i) {
    const vtkDataArray* array = data.GetArray(i);
    const char* name = data.GetArrayName(i);
    if (!array || !name || array->GetNumberOfComponents() != 1) continue;
    names += fmt::format("{}'{}'", names.empty() ? "" : ", ", std::string(name).substr(0, 60));
  }
  return names.empty() ? "the file has no field of one number a point"
                       : "its fields of one number a point are " + names;
}

std::vector<double> read(const std::string& path, const std::string& name) {
  const std::string element = fmt::format("field '{}': ", name.substr(0, 60));
  if (lower_extension(path) != ".vtp")
    throw InputError(element + "only .vtp files give fields; convert the mesh");
  const VtkQuiet quiet;
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkPolyData* data = reader->GetOutput();
  if (quiet.failed() || !data) throw InputError("file: cannot be read as VTP; export it again");
  vtkPointData& points = *data->GetPointData();
  vtkDataArray* array = points.GetArray(name.c_str());
  if (!array) throw InputError(element + "does not exist; " + available(points));
  if (array->GetNumberOfComponents() != 1) {
    throw InputError(fmt::format("{}has {} numbers a point; {}", element,
                                 array->GetNumberOfComponents(), available(points)));
  }
  if (array->GetNumberOfTuples() != data->GetNumberOfPoints())
    throw InputError(element + "has not one value a point; export the file again");
  std::vector<double> values;
  values.reserve(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (vtkIdType v = 0; v < array->GetNumberOfTuples(); ++v) values.push_back(array->GetTuple1(v));
  return values;
}

}  // namespace

std::vector<double> read_point_field(const std::string& path, const std::string& name) {
  try {
    return read(path, name);
  } catch (const InputError& error) {
    throw error.with_file(path);
  }
}

}  // namespace crest::io
