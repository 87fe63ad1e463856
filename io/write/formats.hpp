// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// VTK's data sets as bytes of its XML formats.
#include <set>
#include <string>

class vtkImageData;
class vtkPolyData;
class vtkUnstructuredGrid;

namespace crest::io {

/// A .vtp file's bytes: arrays in their places, in base64, compressed by zlib. They
/// depend on nothing but the data and zlib.
/// Throws: std::runtime_error when a cell has too few points or names one that is not there, when
/// an
///   array has no name or another length than points or cells have, when a number is not finite,
///   and when VTK has any complaint; nothing of it is hidden. Arrays of the names `given`, which
///   are a user's own, may be of floats and hold anything.
std::string vtp_bytes(vtkPolyData& data, const std::set<std::string>& given = {});
/// A .vtu file's, likewise; all cells must be triangles, or all tetrahedra.
std::string vtu_bytes(vtkUnstructuredGrid& data);
/// A .vti file's, likewise, of samples in any type; that they are finite is the caller's care.
std::string vti_bytes(vtkImageData& data);

}  // namespace crest::io
