// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write/formats.hpp"

// vtkSMPTools.h of VTK 9.1 is no C++20.
#include <SMP/Common/vtkSMPToolsAPI.h>
#include <fmt/format.h>
#include <vtkAOSDataArrayTemplate.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLImageDataWriter.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "io/formats/vtk_quiet.hpp"
#include "io/write/atomic_file.hpp"
#include "io/write/inline_array.hpp"
#include "io/write/late_array.hpp"

namespace crest::io {

vtkStandardNewMacro(LateArray);

namespace {

[[noreturn]] void refuse(const std::string& what) {
  throw std::runtime_error("the output's " + what);
}

void require_finite(vtkDataArray& array, const std::string& name) {
  if (array.GetDataType() == VTK_FLOAT) refuse("array '" + name + "' is narrowed to float");
  auto* doubles = vtkDoubleArray::SafeDownCast(&array);
  if (!doubles) return;
  const double* values = doubles->GetPointer(0);
  for (vtkIdType i = 0; i < doubles->GetNumberOfValues(); ++i)
    if (!std::isfinite(values[i]))
      refuse(
          fmt::format("array '{}' is not finite at {}", name, i / array.GetNumberOfComponents()));
}

/// Requires of each array a name, its numbers in order and finite, and `tuples` rows (-1: as many
/// as it has).
void require_arrays(vtkFieldData& data, vtkIdType tuples, const std::set<std::string>& given) {
  for (int i = 0; i < data.GetNumberOfArrays(); ++i) {
    vtkAbstractArray& array = *data.GetAbstractArray(i);
    // VTK would name it by its address.
    if (array.GetName() == nullptr) refuse("array without a name");
    const std::string name = array.GetName();
    const auto* const late = dynamic_cast<const LateArray*>(&array);
    const vtkIdType rows = late ? late->rows : array.GetNumberOfTuples();
    if (tuples >= 0 && rows != tuples)
      refuse(fmt::format("array '{}' has {} rows for {}", name, rows, tuples));
    if (!vtkStringArray::SafeDownCast(&array) && !array.HasStandardMemoryLayout())
      throw std::logic_error("an array that is not in order: " + name);
    if (given.contains(name)) continue;
    if (auto* numbers = vtkDataArray::SafeDownCast(&array)) require_finite(*numbers, name);
  }
}

/// Requires of each cell `least` to `most` points, all of them among `points`.
void require_cells(vtkCellArray* cells, const char* kind, vtkIdType least, vtkIdType most,
                   vtkIdType points) {
  if (!cells) return;
  const auto at = vtk::TakeSmartPointer(cells->NewIterator());
  for (at->GoToFirstCell(); !at->IsDoneWithTraversal(); at->GoToNextCell()) {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    at->GetCurrentCell(size, ids);
    if (size < least || size > most)
      refuse(fmt::format("{} {} has {} points", kind, at->GetCurrentCellId(), size));
    for (vtkIdType i = 0; i < size; ++i)
      if (ids[i] < 0 || ids[i] >= points)
        refuse(fmt::format("{} {} names point {} of {}", kind, at->GetCurrentCellId(), ids[i],
                           points));
  }
}

void require_common(vtkPointSet& data, const std::set<std::string>& given = {}) {
  if (vtkPoints* points = data.GetPoints()) require_finite(*points->GetData(), "Points");
  require_arrays(*data.GetPointData(), data.GetNumberOfPoints(), given);
  require_arrays(*data.GetCellData(), data.GetNumberOfCells(), given);
  require_arrays(*data.GetFieldData(), -1, {});
}

void require_sound(vtkPolyData& data, const std::set<std::string>& given) {
  const vtkIdType points = data.GetNumberOfPoints();
  require_cells(data.GetVerts(), "vertex", 1, 1, points);
  require_cells(data.GetLines(), "line", 2, VTK_ID_MAX, points);
  require_cells(data.GetPolys(), "polygon", 3, VTK_ID_MAX, points);
  require_cells(data.GetStrips(), "strip", 3, VTK_ID_MAX, points);
  require_common(data, given);
}

/// Of triangles or of tetrahedra: no system has other cells.
void require_sound(vtkUnstructuredGrid& data) {
  const int type =
      data.GetNumberOfCells() > 0 && data.GetCellType(0) == VTK_TETRA ? VTK_TETRA : VTK_TRIANGLE;
  const char* name = type == VTK_TETRA ? "tetrahedron" : "triangle";
  const vtkIdType corners = type == VTK_TETRA ? 4 : 3;
  for (vtkIdType c = 0; c < data.GetNumberOfCells(); ++c)
    if (data.GetCellType(c) != type) refuse(fmt::format("cell {} is no {}", c, name));
  require_cells(data.GetCells(), name, corners, corners, data.GetNumberOfPoints());
  require_common(data);
}

void require_sound(vtkImageData& data) {
  vtkDataArray* array = data.GetPointData()->GetScalars();
  if (!array || array->GetNumberOfTuples() != data.GetNumberOfPoints())
    refuse("volume has not one sample a node");
}

/// VTK notes the range of points' norms, which is infinite for coordinates from about 1e154 on, and
/// then cannot read its own note: such ranges end with the largest double, the note is left out.
std::string with_finite_ranges(std::string xml) {
  for (const std::string name : {"RangeMin=", "RangeMax="}) {
    const std::string infinite = name + "\"Infinity\"",
                      largest = name + "\"1.7976931348623157e+308\"";
    for (std::size_t at = xml.find(infinite); at != xml.npos; at = xml.find(infinite, at))
      xml.replace(at, infinite.size(), largest);
  }
  const std::string begin = "<InformationKey ", end = "</InformationKey>";
  for (std::size_t at = xml.find(begin); at != xml.npos; at = xml.find(begin, at + 1)) {
    const std::size_t close = xml.find(end, at);
    if (close == xml.npos) break;
    if (xml.substr(at, close - at).find("inf\n") != std::string::npos)
      xml.erase(at, close + end.size() - at);
  }
  return xml;
}

using Narrow = vtkAOSDataArrayTemplate<std::int32_t>;

/// With the same range, in 64 bits.
vtkSmartPointer<vtkTypeInt64Array> range_of(Narrow& numbers) {
  auto range = vtkSmartPointer<vtkTypeInt64Array>::New();
  range->SetName(numbers.GetName());
  if (numbers.GetNumberOfValues() == 0) return range;
  const std::int32_t* const first = numbers.GetPointer(0);
  const auto [least, most] = std::minmax_element(first, first + numbers.GetNumberOfValues());
  range->InsertNextValue(*least);
  range->InsertNextValue(*most);
  return range;
}

/// The bytes from a place on that the numbers have in 64 bits; both are whole numbers of them.
std::string_view widened(const std::int32_t* numbers, std::size_t at, std::size_t size,
                         std::vector<char>& room) {
  constexpr std::size_t width = sizeof(std::int64_t);
  room.resize(size);
  for (std::size_t i = 0; i < size / width; ++i) {
    const std::int64_t number = numbers[at / width + i];
    std::memcpy(room.data() + i * width, &number, width);
  }
  return {room.data(), size};
}

/// VTK's writer, which hands on the file in pieces: what it says between arrays, and the arrays.
template <class Writer>
class Streaming : public Writer {
 public:
  static Streaming* New() { VTK_STANDARD_NEW_BODY(Streaming); }
  const Sink* sink = nullptr;
  /// Hands on what was said since the last array, with all that is left after Write().
  void hand_on_text() {
    const bool open = this->OutStringStream != nullptr;
    (*sink)(with_finite_ranges(open ? this->OutStringStream->str() : this->OutputString));
    if (open) this->OutStringStream->str({});
  }

 protected:
  void WriteArrayInline(vtkAbstractArray* array, vtkIndent indent, const char* name,
                        int rows_told) override {
    if (auto* const late = dynamic_cast<LateArray*>(array)) {
      late->make();
      require_finite(*late, late->GetName());
      Writer::WriteArrayInline(array, indent, name, rows_told);
      late->drop();
    } else if (auto* const small = narrow_cells(array)) {
      // Cells in half the memory: in files they have 64 bits. VTK is told the range and no more.
      const auto told = range_of(*small);
      narrow_ = small;
      Writer::WriteArrayInline(told, indent, name, rows_told);
      narrow_ = nullptr;
    } else {
      Writer::WriteArrayInline(array, indent, name, rows_told);
    }
  }
  void WriteInlineData(vtkAbstractArray* array, vtkIndent indent) override {
    *this->OutStringStream << indent.GetNextIndent();
    hand_on_text();
    if (narrow_) {
      write_inline_array(
          static_cast<std::size_t>(narrow_->GetNumberOfValues()) * sizeof(std::int64_t),
          [this](std::size_t at, std::size_t size, std::vector<char>& room) {
            return widened(narrow_->GetPointer(0), at, size, room);
          },
          this->GetBlockSize(), *sink);
    } else if (auto* texts = vtkStringArray::SafeDownCast(array)) {
      std::string bytes;  // each with a zero behind it
      for (vtkIdType i = 0; i < texts->GetNumberOfValues(); ++i)
        bytes.append(texts->GetValue(i)).push_back('\0');
      write_inline_array(bytes, this->GetBlockSize(), *sink);
    } else {
      const auto size = array->GetNumberOfValues() * array->GetDataTypeSize();
      write_inline_array(
          {static_cast<const char*>(array->GetVoidPointer(0)), static_cast<std::size_t>(size)},
          this->GetBlockSize(), *sink);
    }
    *this->OutStringStream << "\n";
  }

 private:
  /// The array, if it is of cells and in 32 bits.
  Narrow* narrow_cells(vtkAbstractArray* array) {
    if constexpr (requires { this->CellPoints; })
      if (array == this->CellPoints || array == this->CellOffsets)
        return dynamic_cast<Narrow*>(array);
    return nullptr;
  }

  Narrow* narrow_ = nullptr;  ///< in hand
};

template <class Writer, class Data>
void hand_on(Data& data, const Sink& sink) {
  const VtkQuiet quiet;
  // In several threads it depends on them which of 0 and -0 is the least number of an array.
  vtk::detail::smp::vtkSMPToolsAPI::GetInstance().SetBackend("Sequential");
  vtkNew<Streaming<Writer>> writer;
  writer->sink = &sink;
  writer->SetInputData(&data);
  writer->WriteToOutputStringOn();
  // Never appended data: ParaView 5.11 with Debian 12's libexpat 2.5.0-1+deb12u5 reads none of it.
  writer->SetDataModeToBinary();
  writer->SetCompressorTypeToZLib();
  writer->SetHeaderTypeToUInt32();
  writer->SetByteOrderToLittleEndian();
  if (writer->Write() != 1 || !quiet.complaint().empty())
    throw std::runtime_error("VTK cannot write the data: " + quiet.complaint());
  writer->hand_on_text();
}

/// First what is sound: VTK crashes on some of what is not, and no file is begun. LateArrays are
/// looked at when they are made.
template <class Writer, class Data, class... Given>
std::string bytes_of(Data& data, const Given&... given) {
  require_sound(data, given...);
  std::string bytes;
  hand_on<Writer>(data, [&](std::string_view piece) { bytes += piece; });
  return bytes;
}

template <class Writer, class Data, class... Given>
void write_file(const std::string& path, Data& data, const Given&... given) {
  require_sound(data, given...);
  write_atomically(path, [&](const Sink& sink) { hand_on<Writer>(data, sink); });
}

}  // namespace

std::string vtp_bytes(vtkPolyData& data, const std::set<std::string>& given) {
  return bytes_of<vtkXMLPolyDataWriter>(data, given);
}

std::string vtu_bytes(vtkUnstructuredGrid& data) {
  return bytes_of<vtkXMLUnstructuredGridWriter>(data);
}

std::string vti_bytes(vtkImageData& data) {
  return bytes_of<vtkXMLImageDataWriter>(data);
}

void write_vtp(const std::string& path, vtkPolyData& data, const std::set<std::string>& given) {
  write_file<vtkXMLPolyDataWriter>(path, data, given);
}

void write_vtu(const std::string& path, vtkUnstructuredGrid& data) {
  write_file<vtkXMLUnstructuredGridWriter>(path, data);
}

void write_vti(const std::string& path, vtkImageData& data) {
  write_file<vtkXMLImageDataWriter>(path, data);
}

}  // namespace crest::io
