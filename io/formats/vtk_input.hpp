// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the readers of VTK's XML formats share.
#include <functional>
#include <string>

#include "io/formats/readers.hpp"

class vtkCellArray;
class vtkPointSet;
class vtkXMLReader;

namespace crest::io {

/// Checks the bytes, reads them and takes over points and fields: a named field alone if it is a
/// scalar of the points, else, for the message, all fields; any: all of the points.
/// The data set belongs to the reader.
vtkPointSet& read_vtk(vtkXMLReader& reader, const std::string& bytes, const char* format,
                      const FieldRequest& request, Soup& soup);

/// Takes over cells; `type_of` cell c with so many nodes. Throws, naming `element` c, when the
/// file's offsets are wrong: VTK does not check them.
void take_cells(vtkCellArray& from, const char* element,
                const std::function<CellType(std::size_t c, std::size_t nodes)>& type_of,
                Cells& cells);

}  // namespace crest::io
