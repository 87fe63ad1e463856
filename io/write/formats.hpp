// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the writers of several formats share.
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkSmartPointer.h>

#include <string>

class vtkPolyData;
class vtkUnstructuredGrid;

namespace crest::io {

/// A .vtp file's bytes: appended raw binary, not compressed: the bytes depend on the data alone.
/// Throws: std::runtime_error when VTK fails.
std::string vtp_bytes(vtkPolyData& data);
/// A .vtu file's, likewise.
std::string vtu_bytes(vtkUnstructuredGrid& data);

/// Empty arrays with a name.
vtkSmartPointer<vtkIntArray> named_ints(const char* name);
vtkSmartPointer<vtkDoubleArray> named_doubles(const char* name);

/// The extension in lower case, with its dot.
std::string lower_extension(const std::string& path);

}  // namespace crest::io
