// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/splines/quadratic_model_file.hpp"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>

#include <cmath>
#include <filesystem>

#include "io/formats/files.hpp"
#include "io/formats/vtk_input.hpp"
#include "io/splines/model_fields.hpp"
#include "io/write/formats.hpp"
#include "io/write/image_data.hpp"

namespace crest::io {
namespace {

[[noreturn]] void refuse(const char* element, const char* problem) {
  fail(element, problem, kModelRemedy);
}

std::optional<QuadraticHeader> parse(std::string_view bytes) {
  const vtkSmartPointer<vtkImageData> data = read_image_data(bytes, kModelRemedy);
  vtkFieldData& fields = *data->GetFieldData();
  if (text_of(fields, "type") != "quadratic") return std::nullopt;
  QuadraticHeader header;
  const std::string border = text_of(fields, "border");
  if (border != "none" && border != "extend") refuse("field 'border'", "is not none or extend");
  header.border = border == "none" ? splines::Border::none : splines::Border::extend;
  auto* frame = vtkDoubleArray::SafeDownCast(fields.GetAbstractArray("frame"));
  if (!frame || frame->GetNumberOfValues() != 15) refuse("field 'frame'", "is not 15 numbers");
  const double* x = frame->GetPointer(0);
  for (int i = 0; i < 15; ++i)
    if (!std::isfinite(x[i])) refuse("field 'frame'", "is not finite");
  std::copy_n(x, 3, header.origin.begin());
  std::copy_n(x + 3, 3, header.spacing.begin());
  for (const double s : header.spacing)
    if (!(s > 0)) refuse("field 'frame'", "has a spacing that is not positive");
  for (std::size_t k = 0; k < 3; ++k) std::copy_n(x + 6 + 3 * k, 3, header.directions[k].begin());
  return header;
}

}  // namespace

void QuadraticHeader::restore(kernel::SampledGrid& grid) const {
  grid.origin = origin;
  grid.spacing = spacing;
  grid.directions = directions;
}

void write_quadratic_model(const std::string& path, const splines::QuadraticSpline& spline) {
  const kernel::SampledGrid& grid = spline.grid();
  const auto data = image_data(grid);
  vtkFieldData& fields = *data->GetFieldData();
  add_text(fields, "type", "quadratic");
  add_text(fields, "border", spline.border() == splines::Border::none ? "none" : "extend");
  vtkNew<vtkDoubleArray> frame;
  frame->SetName("frame");
  for (const auto& row :
       {grid.origin, grid.spacing, grid.directions[0], grid.directions[1], grid.directions[2]})
    for (const double x : row) frame->InsertNextValue(x);
  fields.AddArray(frame);
  write_vti(path, *data);
}

std::optional<QuadraticHeader> read_quadratic_header(const std::string& path) {
  std::optional<QuadraticHeader> header;
  std::error_code error;
  if (lower_extension(path) != ".vti" || !std::filesystem::is_regular_file(path, error))
    return header;
  read_named(path, [&] {
    const FileBytes bytes = load(path);
    if (std::string_view(bytes).find("Name=\"frame\"") != std::string_view::npos)
      header = parse(bytes);
  });
  return header;
}

}  // namespace crest::io
