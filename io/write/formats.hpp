// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// VTK's data sets in its XML formats, as bytes or as files.
#include <set>
#include <string>

class vtkImageData;
class vtkPolyData;
class vtkUnstructuredGrid;

namespace crest::io {

/// A .vtp file's bytes: arrays in their places, in base64, compressed
/// (io/write/inline_array.hpp). They depend on nothing but the data and libdeflate.
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

/// The same as files that appear whole (io/write/atomic_file.hpp), written array by array: no more
/// of them than an array is in memory, of a LateArray (io/write/late_array.hpp) nothing before or
/// after. Throw: kernel::InputError, too, for a place that cannot be
/// written.
void write_vtp(const std::string& path, vtkPolyData& data, const std::set<std::string>& given = {});
void write_vtu(const std::string& path, vtkUnstructuredGrid& data);
void write_vti(const std::string& path, vtkImageData& data);

}  // namespace crest::io
