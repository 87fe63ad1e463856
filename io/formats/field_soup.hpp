// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the readers of fields hand to read_quadratic_mesh: linear and quadratic triangles with
// values at their nodes, as they stand in the file.
#include <array>
#include <string>
#include <vector>

#include "io/formats/polygon_soup.hpp"

class vtkCellArray;
class vtkPointData;
class vtkCellData;
class vtkXMLReader;

namespace crest::io {

/// The field to read: none, the one named, or (empty name) the only one.
struct FieldRequest {
  bool wanted = false;
  std::string name = {};
};

/// soup.points are all nodes, soup.faces the corners.
struct FieldSoup {
  PolygonSoup soup;
  /// F nodes in the middle of the sides (0 1), (1 2), (2 0), or kNone thrice for a linear face;
  /// empty: all are linear.
  std::vector<std::array<kernel::Index, 3>> midside = {};
  std::vector<double> values = {};  ///< of the nodes, if a field was wanted
  std::vector<bool> missing = {};   ///< nodes without a value; empty: none
  std::string field = {};           ///< its name
  std::vector<std::string> warnings = {};
};

/// Each throws kernel::InputError without the file's name.
FieldSoup read_vtu(std::string bytes, const FieldRequest& request);
FieldSoup read_vtp_field(std::string bytes, const FieldRequest& request);
FieldSoup read_msh(const std::string& bytes, const FieldRequest& request);

/// What a file says about a field before it is read.
struct FieldInfo {
  std::string name;
  int components;  ///< 0: not numbers
};

/// The position of the field that is meant. Throws kernel::InputError with the names there are.
/// `of_cells`: fields that belong to cells, for the message.
std::size_t choose_field(const std::vector<FieldInfo>& fields, const FieldRequest& request,
                         const std::vector<std::string>& of_cells = {});

/// Switches off all arrays but point fields that may be meant.
void select_fields(vtkXMLReader& reader, const FieldRequest& request);

/// The values of the field that is meant, as doubles, without loss.
void take_field(const vtkXMLReader& reader, vtkPointData& data, const FieldRequest& request,
                FieldSoup& soup);

/// The nodes of cell c. Throws when the file's offsets are wrong.
std::vector<std::int64_t> cell_nodes(vtkCellArray& cells, std::int64_t c,
                                     const std::string& element);

}  // namespace crest::io
