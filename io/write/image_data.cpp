// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write/image_data.hpp"

#include <vtkDataArray.h>
#include <vtkMatrix3x3.h>
#include <vtkPointData.h>

#include <bit>
#include <cstring>

namespace crest::io {

using kernel::SampledGrid;

static_assert(std::endian::native == std::endian::little);

std::string sample_bytes(const SampledGrid& grid) {
  return std::visit(
      [](const auto& x) {
        std::string bytes(x.size() * sizeof x[0], '\0');
        std::memcpy(bytes.data(), x.data(), bytes.size());
        return bytes;
      },
      grid.samples);
}

vtkSmartPointer<vtkImageData> image_data(const SampledGrid& grid) {
  constexpr int types[] = {
      VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,     VTK_UNSIGNED_SHORT,
      VTK_INT,         VTK_UNSIGNED_INT,  VTK_LONG_LONG, VTK_UNSIGNED_LONG_LONG,
      VTK_FLOAT,       VTK_DOUBLE};
  auto data = vtkSmartPointer<vtkImageData>::New();
  data->SetDimensions(static_cast<int>(grid.size[0]), static_cast<int>(grid.size[1]),
                      static_cast<int>(grid.size[2]));
  data->SetOrigin(grid.origin.data());
  data->SetSpacing(grid.spacing.data());
  for (int k = 0; k < 3; ++k)
    for (int r = 0; r < 3; ++r)
      data->GetDirectionMatrix()->SetElement(
          r, k, grid.directions[static_cast<std::size_t>(k)][static_cast<std::size_t>(r)]);
  const auto array = vtk::TakeSmartPointer(
      vtkDataArray::CreateDataArray(types[static_cast<std::size_t>(grid.type())]));
  array->SetName("value");
  array->SetNumberOfTuples(static_cast<vtkIdType>(grid.count()));
  const std::string samples = sample_bytes(grid);
  std::memcpy(array->GetVoidPointer(0), samples.data(), samples.size());
  data->GetPointData()->SetScalars(array);
  return data;
}

}  // namespace crest::io
