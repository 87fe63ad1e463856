// SPDX-License-Identifier: GPL-3.0-or-later
// Fields of VTK XML files: which one is meant, and its values.
#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkDataArraySelection.h>
#include <vtkPointData.h>
#include <vtkXMLReader.h>

#include <algorithm>
#include <cmath>

#include "io/formats/field_soup.hpp"

namespace crest::io {
namespace {

std::string quoted_list(const std::vector<std::string>& names) {
  std::string list;
  constexpr std::size_t most = 20;
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i)
    list += fmt::format("{}'{}'", i == 0 ? "" : ", ", names[i].substr(0, 60));
  return names.size() > most ? list + ", .." : list;
}

std::vector<std::string> scalar_names(const std::vector<FieldInfo>& fields) {
  std::vector<std::string> names;
  for (const FieldInfo& field : fields)
    if (field.components == 1) names.push_back(field.name);
  return names;
}

/// 64-bit integers beyond 2^53 would be rounded, and ties appear.
void require_exact(vtkDataArray& array, const std::string& name) {
  const int type = array.GetDataType();
  if (type == VTK_FLOAT || type == VTK_DOUBLE || array.GetDataTypeSize() < 8) return;
  for (vtkIdType v = 0; v < array.GetNumberOfTuples(); ++v) {
    if (std::fabs(array.GetTuple1(v)) > 0x1p53) {
      fail(fmt::format("node {}", v), fmt::format("its value of '{}' exceeds 2^53", name),
           "store the field as doubles");
    }
  }
}

}  // namespace

std::size_t choose_field(const std::vector<FieldInfo>& fields, const FieldRequest& request,
                         const std::vector<std::string>& of_cells) {
  const std::vector<std::string> scalars = scalar_names(fields);
  const std::string known =
      scalars.empty() ? "there is no scalar point field, use --expression"
                      : fmt::format("the scalar point fields are {}", quoted_list(scalars));
  if (request.name.empty()) {
    if (scalars.size() > 1)
      fail("fields", "there are several", known + "; choose one with --field");
    if (scalars.empty()) fail("fields", "none is given", known);
  }
  const std::string& name = request.name.empty() ? scalars[0] : request.name;
  const auto is_meant = [&](const FieldInfo& field) { return field.name == name; };
  const auto found = std::find_if(fields.begin(), fields.end(), is_meant);
  const std::string element = fmt::format("field '{}'", name);
  if (found == fields.end()) {
    const bool cells = std::find(of_cells.begin(), of_cells.end(), name) != of_cells.end();
    fail(element, cells ? "belongs to the cells" : "does not exist", known);
  }
  if (found->components != 1) {
    const std::string what = found->components == 0
                                 ? std::string("does not hold numbers")
                                 : fmt::format("has {} components", found->components);
    fail(element, what, known);
  }
  if (std::count_if(fields.begin(), fields.end(), is_meant) > 1)
    fail(element, "is there several times", "keep one time step");
  return static_cast<std::size_t>(found - fields.begin());
}

void select_fields(vtkXMLReader& reader, const FieldRequest& request) {
  reader.GetCellDataArraySelection()->DisableAllArrays();
  vtkDataArraySelection* points = reader.GetPointDataArraySelection();
  points->DisableAllArrays();
  if (!request.wanted) return;
  if (request.name.empty())
    points->EnableAllArrays();
  else if (points->ArrayExists(request.name.c_str()) != 0)
    points->EnableArray(request.name.c_str());
}

void take_field(const vtkXMLReader& reader, vtkPointData& data, const FieldRequest& request,
                FieldSoup& soup) {
  if (!request.wanted) return;
  auto& source = const_cast<vtkXMLReader&>(reader);  // VTK's getters are not const
  vtkDataArraySelection* names = source.GetPointDataArraySelection();
  std::vector<FieldInfo> fields;
  for (int i = 0; i < names->GetNumberOfArrays(); ++i) {
    const char* name = names->GetArrayName(i);
    // One that was not loaded could not be meant: only its name is needed.
    vtkDataArray* array = data.GetArray(name);
    const bool loaded = names->ArrayIsEnabled(name) != 0;
    fields.push_back({name, array ? array->GetNumberOfComponents() : loaded ? 0 : 1});
  }
  std::vector<std::string> of_cells;
  vtkDataArraySelection* cells = source.GetCellDataArraySelection();
  for (int i = 0; i < cells->GetNumberOfArrays(); ++i)
    of_cells.emplace_back(cells->GetArrayName(i));
  soup.field = fields[choose_field(fields, request, of_cells)].name;
  vtkDataArray* array = data.GetArray(soup.field.c_str());
  const auto nodes = static_cast<vtkIdType>(soup.soup.points.size());
  if (!array || array->GetNumberOfTuples() != nodes)
    fail(fmt::format("field '{}'", soup.field), "has not one value a node", "export it again");
  require_exact(*array, soup.field);
  soup.values.resize(static_cast<std::size_t>(nodes));
  for (vtkIdType v = 0; v < nodes; ++v)
    soup.values[static_cast<std::size_t>(v)] = array->GetTuple1(v);
}

std::vector<std::int64_t> cell_nodes(vtkCellArray& cells, std::int64_t c,
                                     const std::string& element) {
  vtkDataArray* offsets = cells.GetOffsetsArray();
  vtkDataArray* connectivity = cells.GetConnectivityArray();
  if (!offsets || !connectivity) fail("cells", "cannot be read", "export the mesh again");
  const auto begin = static_cast<vtkIdType>(offsets->GetTuple1(c));
  const auto end = static_cast<vtkIdType>(offsets->GetTuple1(c + 1));
  if (begin < 0 || end < begin || end > connectivity->GetNumberOfTuples())
    fail(element, "its offsets are wrong", "export the mesh again");
  std::vector<std::int64_t> nodes;
  // A damaged file may announce a cell of any length.
  for (vtkIdType i = begin; i < std::min(end, begin + 8); ++i)
    nodes.push_back(static_cast<std::int64_t>(connectivity->GetTuple1(i)));
  return nodes;
}

}  // namespace crest::io
