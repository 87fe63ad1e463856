// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the readers of VTK's XML formats share.
#include <string>

#include "io/formats/readers.hpp"
#include "io/formats/vtk_cells.hpp"

class vtkCellArray;
class vtkPointSet;
class vtkXMLReader;

namespace crest::io {

/// Before VTK reads VTP or VTU: throws where a header or a block announces more than the bytes may
/// hold, which VTK would allocate.
void check_xml(std::string_view bytes);
/// Likewise before it reads VTI: where an extent announces more.
void check_extents(std::string_view bytes);

/// Checks the bytes, reads them and takes over points and fields: a named field alone if it is a
/// scalar of the points, else, for the message, all fields; any: all. The data set belongs to the
/// reader.
vtkPointSet& read_xml(vtkXMLReader& reader, std::string_view bytes, const char* format,
                      const FieldRequest& request, Soup& soup);

/// Takes over cells; as add_cells: VTK does not check offsets.
void take_cells(vtkCellArray& from, const char* element,
                const std::function<CellType(std::size_t c, std::size_t nodes)>& type_of,
                Cells& cells);

}  // namespace crest::io
