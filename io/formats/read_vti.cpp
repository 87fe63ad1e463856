// SPDX-License-Identifier: GPL-3.0-or-later
// VTK XML image data.
#include <fmt/format.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkXMLImageDataReader.h>

#include "io/formats/volume_field.hpp"
#include "io/formats/vtk_input.hpp"
#include "io/formats/vtk_quiet.hpp"

namespace crest::io {
namespace {

Samples samples_of(vtkDataArray& array, std::size_t count) {
  const void* from = array.GetVoidPointer(0);
  NumberType type = NumberType::f64;
  switch (array.GetDataType()) {
    vtkTemplateMacro(type = std::is_floating_point_v<VTK_TT>
                                ? (sizeof(VTK_TT) == 4 ? NumberType::f32 : NumberType::f64)
                                : static_cast<NumberType>(2 * std::countr_zero(sizeof(VTK_TT)) +
                                                          (std::is_signed_v<VTK_TT> ? 0 : 1)));
    default:
      fail("samples", "are bits or strings", "save them as numbers");
  }
  return load_samples(type, {static_cast<const char*>(from), count * size_of(type)}, {count},
                      false);
}

}  // namespace

vtkSmartPointer<vtkImageData> read_image_data(std::string_view bytes, const char* remedy) {
  check_xml(bytes);
  check_extents(bytes);
  const VtkQuiet quiet;
  vtkNew<vtkXMLImageDataReader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(std::string(bytes));
  reader->Update();
  vtkImageData* data = reader->GetOutput();
  if (quiet.failed() || reader->GetErrorCode() != 0 || !data || data->GetNumberOfPoints() < 1)
    fail("file", "cannot be read as VTI (wrong format, truncated or damaged)", remedy);
  return data;
}

Volume read_vti(std::string_view bytes, const VolumeRequest& request) {
  return volume_of(*read_image_data(bytes, "export the volume again"), request.field);
}

Volume volume_of(vtkImageData& data, const std::string& field_name) {
  Volume volume;
  int dimensions[3], extent[6];
  data.GetDimensions(dimensions);
  data.GetExtent(extent);
  for (int k = 0; k < 3; ++k) {
    volume.size.push_back(static_cast<std::size_t>(dimensions[k]));
    kernel::Vec3& step = volume.steps.emplace_back();
    for (int r = 0; r < 3; ++r)
      step[static_cast<std::size_t>(r)] =
          data.GetSpacing()[k] * data.GetDirectionMatrix()->GetElement(r, k);
  }
  data.TransformIndexToPhysicalPoint(extent[0], extent[2], extent[4], volume.origin.data());
  vtkPointData& arrays = *data.GetPointData();
  std::vector<Field> fields;
  for (int i = 0; i < arrays.GetNumberOfArrays(); ++i)
    if (vtkDataArray* array = arrays.GetArray(i); array && array->GetName())
      fields.push_back({.name = array->GetName(), .components = array->GetNumberOfComponents()});
  const char* active = arrays.GetScalars() ? arrays.GetScalars()->GetName() : nullptr;
  const Field& field = chosen_field(fields, field_name, active ? active : "");
  vtkDataArray& array = *arrays.GetArray(field.name.c_str());
  if (array.GetNumberOfTuples() != data.GetNumberOfPoints())
    fail("samples", "have not one number a node", "export the volume again");
  volume.samples = samples_of(array, product(volume.size));
  return volume;
}

}  // namespace crest::io
