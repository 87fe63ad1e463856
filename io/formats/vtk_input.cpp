// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/vtk_input.hpp"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataArraySelection.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLReader.h>

#include <bit>
#include <functional>
#include <optional>
#include <type_traits>

#include "io/formats/files.hpp"
#include "io/formats/vtk_cells.hpp"
#include "io/formats/vtk_quiet.hpp"

namespace crest::io {
namespace {

template <class Native>
Field::Numbers copied(const Native* first, std::size_t count) {
  using Wide = std::conditional_t<std::is_floating_point_v<Native>, double,
                                  std::conditional_t<std::is_signed_v<Native> || sizeof(Native) < 8,
                                                     std::int64_t, std::uint64_t>>;
  return std::vector<Wide>(first, first + count);
}

template <class Native>
constexpr kernel::NumberType type_of() {
  using kernel::NumberType;
  if constexpr (std::is_floating_point_v<Native>)
    return sizeof(Native) == 4 ? NumberType::f32 : NumberType::f64;
  constexpr int size = std::bit_width(sizeof(Native)) - 1,
                unsigned_one = std::is_unsigned_v<Native>;
  return static_cast<NumberType>(2 * size + unsigned_one);
}

std::optional<kernel::NumberType> type_of(vtkDataArray& array) {
  switch (array.GetDataType()) {
    vtkTemplateMacro(return type_of<VTK_TT>());
    default:
      return std::nullopt;
  }
}

Field::Numbers numbers_of(vtkDataArray& array) {
  const auto count = static_cast<std::size_t>(array.GetNumberOfValues());
  if (count == 0) return {};
  switch (array.GetDataType()) {
    vtkTemplateMacro(return copied(static_cast<const VTK_TT*>(array.GetVoidPointer(0)), count));
    default: {
      std::vector<double> numbers;  // bits
      for (vtkIdType i = 0; i < array.GetNumberOfTuples(); ++i)
        for (int k = 0; k < array.GetNumberOfComponents(); ++k)
          numbers.push_back(array.GetComponent(i, k));
      return numbers;
    }
  }
}

/// Of a cell array, which has 32 or 64 bits.
std::vector<std::int64_t> integers_of(vtkDataArray& array) {
  Field::Numbers numbers = numbers_of(array);
  auto* integers = std::get_if<std::vector<std::int64_t>>(&numbers);
  return integers ? std::move(*integers) : std::vector<std::int64_t>();
}

void take_field(const char* name, vtkDataArray* array, const vtkDataArray* normals,
                std::vector<Field>& fields) {
  Field& field = fields.emplace_back(Field{.name = name, .components = 0});
  if (!array) return;
  field.components = array->GetNumberOfComponents();
  field.numbers = numbers_of(*array);
  field.normals = array == normals;
  field.type = type_of(*array);
}

/// Those that were loaded.
void take_fields(vtkDataArraySelection& names, vtkDataSetAttributes& data,
                 std::vector<Field>& fields) {
  for (int i = 0; i < names.GetNumberOfArrays(); ++i) {
    const char* name = names.GetArrayName(i);
    if (names.ArrayIsEnabled(name) != 0)
      take_field(name, data.GetArray(name), data.GetNormals(), fields);
  }
}

/// All: messages name those that could have been meant.
void take_fields(vtkDataSetAttributes& data, std::vector<Field>& fields) {
  for (int i = 0; i < data.GetNumberOfArrays(); ++i)
    if (const char* name = data.GetArrayName(i))
      take_field(name, data.GetArray(i), data.GetNormals(), fields);
}

void take_points(vtkPointSet& data, std::vector<kernel::Vec3>& points) {
  points.resize(static_cast<std::size_t>(data.GetNumberOfPoints()));
  for (std::size_t v = 0; v < points.size(); ++v)
    data.GetPoint(static_cast<vtkIdType>(v), points[v].data());
}

using TypeOf = std::function<CellType(std::size_t c, std::size_t nodes)>;

void take_cells(vtkCellArray& from, const char* element, const TypeOf& type_of, Cells& cells) {
  vtkDataArray* offsets = from.GetOffsetsArray();
  vtkDataArray* connectivity = from.GetConnectivityArray();
  if (!offsets || !connectivity)
    fail(fmt::format("{}s", element), "cannot be read", "export the mesh again");
  const std::vector<std::int64_t> begins = integers_of(*offsets),
                                  nodes = integers_of(*connectivity);
  add_cells(begins, nodes, element, type_of, cells);
}

bool is_scalar(vtkDataSet& data, const std::string& name) {
  const vtkDataArray* array = data.GetPointData()->GetArray(name.c_str());
  return array && array->GetNumberOfComponents() == 1;
}

void select(const FieldRequest& request, bool all, vtkDataArraySelection& names) {
  names.DisableAllArrays();
  for (int i = 0; i < names.GetNumberOfArrays(); ++i) {
    const char* name = names.GetArrayName(i);
    if (all || request.asks_for(name)) names.EnableArray(name);
  }
}

}  // namespace

vtkPointSet& read_xml(vtkXMLReader& reader, std::string_view bytes, const char* format,
                      const FieldRequest& request, Soup& soup) {
  check_xml(bytes);
  const VtkQuiet quiet;
  reader.ReadFromInputStringOn();
  reader.SetInputString(std::string(bytes));
  reader.UpdateInformation();
  vtkDataArraySelection& of_points = *reader.GetPointDataArraySelection();
  vtkDataArraySelection& of_cells = *reader.GetCellDataArraySelection();
  select(request, request.normals, of_points);  // which are normals is known once they are read
  select(request, false, of_cells);
  if (of_cells.ArrayExists(kGhostType) != 0) of_cells.EnableArray(kGhostType);
  const auto update = [&]() -> vtkPointSet& {
    reader.Update();
    auto* data = vtkPointSet::SafeDownCast(reader.GetOutputAsDataSet());
    if (quiet.failed() || reader.GetErrorCode() != 0 || !data)
      fail("file", fmt::format("cannot be read as {} (wrong format, truncated or damaged)", format),
           "export the mesh again");
    return *data;
  };
  vtkPointSet* data = &update();
  if (request.wanted && !request.name.empty() && !is_scalar(*data, request.name)) {
    of_points.EnableAllArrays();
    of_cells.EnableAllArrays();
    data = &update();
  }
  take_points(*data, soup.points);
  take_fields(of_points, *data->GetPointData(), soup.point_fields);
  take_fields(of_cells, *data->GetCellData(), soup.cell_fields);
  return *data;
}

void take_cells(vtkPolyData& data, Cells& cells) {
  const auto take = [&](vtkCellArray* from, const char* element, PolyKind kind) {
    const auto type_of = [kind](std::size_t, std::size_t nodes) { return poly_type(kind, nodes); };
    if (from && from->GetNumberOfCells() > 0) take_cells(*from, element, type_of, cells);
  };
  take(data.GetVerts(), "vertex cell", PolyKind::vertices);
  take(data.GetLines(), "line", PolyKind::lines);
  take(data.GetPolys(), "face", PolyKind::polygons);
  take(data.GetStrips(), "strip", PolyKind::strips);
}

void take_cells(vtkUnstructuredGrid& grid, Cells& cells) {
  vtkCellArray* from = grid.GetCells();
  vtkUnsignedCharArray* types = grid.GetCellTypesArray();
  if (!from || !types) return;
  if (types->GetNumberOfTuples() != from->GetNumberOfCells())
    fail("cells", "have not one type each", "export the mesh again");
  const auto type_of = [&](std::size_t c, std::size_t) {
    return static_cast<CellType>(types->GetValue(static_cast<vtkIdType>(c)));
  };
  take_cells(*from, "cell", type_of, cells);
}

Soup soup_of(vtkPointSet& data) {
  Soup soup;
  take_points(data, soup.points);
  take_fields(*data.GetPointData(), soup.point_fields);
  take_fields(*data.GetCellData(), soup.cell_fields);
  if (auto* faces = vtkPolyData::SafeDownCast(&data)) take_cells(*faces, soup.cells);
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(&data)) take_cells(*grid, soup.cells);
  return soup;
}

}  // namespace crest::io
