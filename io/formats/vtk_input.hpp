// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Data sets of VTK as soups, and what the readers of its XML formats share.
#include <vtkSmartPointer.h>

#include <string>

#include "io/formats/readers.hpp"

class vtkImageData;
class vtkPointSet;
class vtkPolyData;
class vtkUnstructuredGrid;
class vtkXMLReader;

namespace crest::io {

/// VTK's array of cells that belong to another piece or are hidden.
inline constexpr const char* kGhostType = "vtkGhostType";

/// Before VTK reads VTP or VTU: throws where a header or a block announces more than the bytes may
/// hold, which VTK would allocate.
void check_xml(std::string_view bytes);
/// Likewise before it reads VTI: where an extent announces more.
void check_extents(std::string_view bytes);

/// The grid of VTI's bytes, at least one point. Throws with this remedy.
vtkSmartPointer<vtkImageData> read_image_data(std::string_view bytes, const char* remedy);

/// Checks the bytes, reads them and takes over points and fields: a named field alone if it is a
/// scalar of the points, else, for the message, all fields; any: all; kGhostType always. The data
/// set belongs to the reader.
vtkPointSet& read_xml(vtkXMLReader& reader, std::string_view bytes, const char* format,
                      const FieldRequest& request, Soup& soup);

/// Takes over cells. Throws where offsets are wrong, which VTK does not check.
void take_cells(vtkPolyData& data, Cells& cells);
void take_cells(vtkUnstructuredGrid& grid, Cells& cells);

/// The points, cells and fields of polygonal data or of an unstructured grid.
Soup soup_of(vtkPointSet& data);

}  // namespace crest::io
