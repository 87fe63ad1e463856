// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/splines/cubic_model_file.hpp"

#include <fmt/format.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <tuple>

#include "io/formats/files.hpp"
#include "io/formats/vtk_input.hpp"
#include "io/splines/model_fields.hpp"
#include "io/write/formats.hpp"

namespace crest::io {
namespace {

using splines::CubicModel;
using splines::Domain;
using splines::Smoothness;

constexpr const char* kSmoothness[] = {"c1", "local", "sequential"};

template <class Row>
void add_rows(vtkFieldData& to, const char* name, const std::vector<Row>& rows) {
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(std::tuple_size_v<Row>);
  array->SetNumberOfTuples(static_cast<vtkIdType>(rows.size()));
  std::memcpy(array->GetPointer(0), rows.data(), rows.size() * sizeof(Row));
  to.AddArray(array);
}

/// Throws unless the array has these rows of finite doubles.
template <class Row>
std::vector<Row> rows_of(vtkFieldData& from, const char* name, std::size_t count) {
  auto* array = vtkDoubleArray::SafeDownCast(from.GetAbstractArray(name));
  const std::string element = fmt::format("array '{}'", name);
  if (!array) fail(element, "is missing or not of doubles", kModelRemedy);
  if (array->GetNumberOfComponents() != static_cast<int>(std::tuple_size_v<Row>) ||
      array->GetNumberOfTuples() != static_cast<vtkIdType>(count))
    fail(element, fmt::format("has not {} rows of {} numbers", count, std::tuple_size_v<Row>),
         kModelRemedy);
  std::vector<Row> rows(count);
  std::memcpy(rows.data(), array->GetPointer(0), count * sizeof(Row));
  for (std::size_t i = 0; i < count; ++i)
    for (const double x : rows[i])
      if (!std::isfinite(x)) fail(element, fmt::format("row {} is not finite", i), kModelRemedy);
  return rows;
}

Domain domain_of(vtkImageData& data) {
  Domain domain;
  int size[3];
  data.GetDimensions(size);
  const auto box = rows_of<std::array<double, 6>>(*data.GetFieldData(), "box", 1)[0];
  for (std::size_t d = 0; d < 3; ++d) {
    domain.low[d] = box[2 * d];
    domain.high[d] = box[2 * d + 1];
    if (!(domain.low[d] < domain.high[d]) || !std::isfinite(domain.high[d] - domain.low[d]))
      fail("array 'box'", "is empty", kModelRemedy);
    if (size[d] < 2) fail("file", "has no cubes", kModelRemedy);
    domain.cubes[d] = static_cast<kernel::Index>(size[d] - 1);
  }
  return domain;
}

CubicModel model_of(vtkImageData& data) {
  vtkFieldData& fields = *data.GetFieldData();
  if (text_of(fields, "type") != "cubic") fail("field 'type'", "is not 'cubic'", kModelRemedy);
  CubicModel model;
  model.domain = domain_of(data);
  const auto smoothness =
      std::find(std::begin(kSmoothness), std::end(kSmoothness), text_of(fields, "smoothness"));
  if (smoothness == std::end(kSmoothness)) fail("field 'smoothness'", "is unknown", kModelRemedy);
  model.smoothness = static_cast<Smoothness>(smoothness - std::begin(kSmoothness));
  model.unit = rows_of<std::array<double, 1>>(fields, "unit", 1)[0][0];
  const std::size_t vertices = model.domain.vertex_count();
  model.vertices = rows_of<splines::ValueAndSlope>(*data.GetPointData(), "vertex", vertices);
  model.slopes = rows_of<splines::EdgeSlopes>(*data.GetPointData(), "slopes", vertices);
  model.centres =
      rows_of<splines::ValueAndSlope>(*data.GetCellData(), "centre", model.domain.cube_count());
  return model;
}

}  // namespace

void write_cubic_model(const std::string& path, const CubicModel& model) {
  vtkNew<vtkImageData> data;
  const Domain& domain = model.domain;
  const auto [nx, ny, nz] = domain.cubes;
  data->SetDimensions(static_cast<int>(nx) + 1, static_cast<int>(ny) + 1, static_cast<int>(nz) + 1);
  data->SetOrigin(domain.low.data());
  std::array<double, 6> box;
  std::array<double, 3> spacing;
  for (std::size_t d = 0; d < 3; ++d) {
    box[2 * d] = domain.low[d];
    box[2 * d + 1] = domain.high[d];
    spacing[d] = (domain.high[d] - domain.low[d]) / domain.cubes[d];
  }
  data->SetSpacing(spacing.data());
  add_rows(*data->GetPointData(), "vertex", model.vertices);
  data->GetPointData()->SetActiveScalars("vertex");
  add_rows(*data->GetPointData(), "slopes", model.slopes);
  add_rows(*data->GetCellData(), "centre", model.centres);
  vtkFieldData& fields = *data->GetFieldData();
  add_text(fields, "type", "cubic");
  add_text(fields, "smoothness", kSmoothness[static_cast<std::size_t>(model.smoothness)]);
  add_rows(fields, "box", std::vector{box});
  add_rows(fields, "unit", std::vector{std::array{model.unit}});
  write_vti(path, *data);
}

bool is_cubic_model(const std::string& path) {
  std::error_code error;
  if (lower_extension(path) != ".vti" || !std::filesystem::is_regular_file(path, error))
    return false;
  const FileBytes bytes = load(path);
  const std::string_view text = bytes;
  return text.find("Name=\"slopes\"") != text.npos && text.find("Name=\"centre\"") != text.npos;
}

CubicModel read_cubic_model_bytes(const std::string& name, std::string_view bytes) {
  CubicModel model;
  read_named(name, [&] { model = model_of(*read_image_data(bytes, kModelRemedy)); });
  return model;
}

CubicModel read_cubic_model(const std::string& path) {
  CubicModel model;
  read_named(path, [&] { model = model_of(*read_image_data(load(path), kModelRemedy)); });
  return model;
}

}  // namespace crest::io
