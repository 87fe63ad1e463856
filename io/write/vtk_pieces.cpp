// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write/vtk_pieces.hpp"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <vector>

#include "io/write/atomic_file.hpp"
#include "io/write/formats.hpp"

namespace crest::io {
namespace {

constexpr const char* kNumbers = "GlobalPointIds";

/// In the order in which VTK numbers cells; some may be null.
std::vector<vtkCellArray*> cells_of(vtkPolyData& data) {
  return {data.GetVerts(), data.GetLines(), data.GetPolys(), data.GetStrips()};
}
std::vector<vtkCellArray*> cells_of(vtkUnstructuredGrid& data) {
  return {data.GetCells()};
}
void set_cells(vtkPolyData& data, const std::vector<vtkSmartPointer<vtkCellArray>>& cells,
               vtkPolyData&) {
  if (cells[0]->GetNumberOfCells() > 0) data.SetVerts(cells[0]);
  if (cells[1]->GetNumberOfCells() > 0) data.SetLines(cells[1]);
  if (cells[2]->GetNumberOfCells() > 0) data.SetPolys(cells[2]);
  if (cells[3]->GetNumberOfCells() > 0) data.SetStrips(cells[3]);
}
void set_cells(vtkUnstructuredGrid& data, const std::vector<vtkSmartPointer<vtkCellArray>>& cells,
               vtkUnstructuredGrid& whole) {
  if (cells[0]->GetNumberOfCells() > 0) data.SetCells(whole.GetCellType(0), cells[0]);
}

/// Calls use(kind, points) for the cells first .. last - 1.
template <class Use>
void for_cells(const std::vector<vtkCellArray*>& cells, vtkIdType first, vtkIdType last,
               const Use& use) {
  vtkNew<vtkIdList> points;
  vtkIdType base = 0;
  for (std::size_t kind = 0; kind < cells.size(); ++kind) {
    const vtkIdType count = cells[kind] ? cells[kind]->GetNumberOfCells() : 0;
    for (vtkIdType c = std::max(first, base); c < std::min(last, base + count); ++c) {
      cells[kind]->GetCellAtId(c - base, points);
      use(kind, *points);
    }
    base += count;
  }
}

/// The rows of which `ids` are the numbers; of numbers alone: VTK 9.1's readers of pieces copy
/// texts byte by byte and free them twice.
void copy_rows(vtkDataSetAttributes& from, const std::vector<vtkIdType>& ids,
               vtkDataSetAttributes& to) {
  to.CopyAllOn();
  to.CopyAllocate(&from, static_cast<vtkIdType>(ids.size()));
  for (std::size_t i = 0; i < ids.size(); ++i)
    to.CopyData(&from, ids[i], static_cast<vtkIdType>(i));
  for (int i = to.GetNumberOfArrays() - 1; i >= 0; --i)
    if (vtkDataArray::SafeDownCast(to.GetAbstractArray(i)) == nullptr) to.RemoveArray(i);
}

template <class Data>
class Pieces {
 public:
  Pieces(Data& data, long long most)
      : data_(data), cells_(cells_of(data)), most_(most), number_(points(), -1), used_(points()) {
    for_cells(cells_, 0, data.GetNumberOfCells(), [&](std::size_t, vtkIdList& cell) {
      for (const vtkIdType v : cell) used_[static_cast<std::size_t>(v)] = true;
    });
  }
  vtkIdType count() const {
    return std::max<vtkIdType>(1, (data_.GetNumberOfCells() + most_ - 1) / most_);
  }

  vtkSmartPointer<Data> piece(vtkIdType k) {
    const vtkIdType first = k * most_, last = std::min(first + most_, data_.GetNumberOfCells());
    const std::vector<vtkIdType> ids = points_of(k, first, last);
    for (std::size_t i = 0; i < ids.size(); ++i)
      number_[static_cast<std::size_t>(ids[i])] = static_cast<vtkIdType>(i);
    auto r = vtkSmartPointer<Data>::New();
    set_points(ids, *r);
    std::vector<vtkSmartPointer<vtkCellArray>> cells(cells_.size());
    for (auto& one : cells) one = vtkSmartPointer<vtkCellArray>::New();
    for_cells(cells_, first, last, [&](std::size_t kind, vtkIdList& cell) {
      for (vtkIdType& v : cell) v = number_[static_cast<std::size_t>(v)];
      cells[kind]->InsertNextCell(&cell);
    });
    set_cells(*r, cells, data_);
    std::vector<vtkIdType> rows;
    for (vtkIdType c = first; c < last; ++c) rows.push_back(c);
    copy_rows(*data_.GetCellData(), rows, *r->GetCellData());
    r->SetFieldData(data_.GetFieldData());
    return r;
  }

 private:
  std::size_t points() const { return static_cast<std::size_t>(data_.GetNumberOfPoints()); }

  /// Ascending.
  std::vector<vtkIdType> points_of(vtkIdType k, vtkIdType first, vtkIdType last) const {
    std::vector<vtkIdType> ids;
    for (vtkIdType v = 0; k == 0 && v < data_.GetNumberOfPoints(); ++v)
      if (!used_[static_cast<std::size_t>(v)]) ids.push_back(v);
    for_cells(cells_, first, last, [&](std::size_t, vtkIdList& cell) {
      ids.insert(ids.end(), cell.begin(), cell.end());
    });
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    return ids;
  }

  void set_points(const std::vector<vtkIdType>& ids, Data& to) const {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkIdTypeArray> numbers;
    numbers->SetName(kNumbers);
    for (const vtkIdType v : ids) {
      points->InsertNextPoint(data_.GetPoint(v));
      numbers->InsertNextValue(v);
    }
    to.SetPoints(points);
    copy_rows(*data_.GetPointData(), ids, *to.GetPointData());
    to.GetPointData()->SetGlobalIds(numbers);
  }

  Data& data_;
  const std::vector<vtkCellArray*> cells_;
  const vtkIdType most_;
  std::vector<vtkIdType> number_;  ///< of a point in the piece at hand
  std::vector<bool> used_;         ///< a point
};

std::string escaped(const std::string& name) {
  std::string r;
  for (const char c : name)
    r += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '"' ? "&quot;" : std::string(1, c);
  return r;
}

std::string type_of(vtkAbstractArray& array) {
  const int type = array.GetDataType();
  const bool real = type == VTK_DOUBLE || type == VTK_FLOAT;
  const bool natural = type == VTK_UNSIGNED_CHAR || type == VTK_UNSIGNED_SHORT ||
                       type == VTK_UNSIGNED_INT || type == VTK_UNSIGNED_LONG ||
                       type == VTK_UNSIGNED_LONG_LONG;
  return fmt::format("{}{}",
                     real      ? "Float"
                     : natural ? "UInt"
                               : "Int",
                     8 * array.GetDataTypeSize());
}

std::string array_line(vtkAbstractArray& array) {
  return fmt::format("      <PDataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\"/>\n",
                     type_of(array), escaped(array.GetName()), array.GetNumberOfComponents());
}

std::string rows_text(const char* name, vtkDataSetAttributes& rows) {
  std::string text = fmt::format("    <{}", name);
  for (int k = 0; k < vtkDataSetAttributes::NUM_ATTRIBUTES; ++k)
    if (vtkAbstractArray* array = rows.GetAbstractAttribute(k))
      text += fmt::format(" {}=\"{}\"", vtkDataSetAttributes::GetAttributeTypeAsString(k),
                          escaped(array->GetName()));
  text += ">\n";
  for (int i = 0; i < rows.GetNumberOfArrays(); ++i) text += array_line(*rows.GetAbstractArray(i));
  return text + fmt::format("    </{}>\n", name);
}

/// The file that names the pieces, all of which have the arrays of `piece`.
template <class Data>
std::string index_text(const std::string& type, Data& piece,
                       const std::vector<std::string>& names) {
  std::string text = fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"{0}\" version=\"0.1\" byte_order=\"LittleEndian\" header_type=\"UInt32\" "
      "compressor=\"vtkZLibDataCompressor\">\n  <{0} GhostLevel=\"0\">\n",
      type);
  text += rows_text("PPointData", *piece.GetPointData());
  text += rows_text("PCellData", *piece.GetCellData());
  text += "    <PPoints>\n";
  text += "      <PDataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"/>\n";
  text += "    </PPoints>\n";
  for (const std::string& name : names)
    text += fmt::format("    <Piece Source=\"{}\"/>\n", escaped(name));
  return text + fmt::format("  </{}>\n</VTKFile>\n", type);
}

template <class Data, class Write>
void write_pieces(const std::string& path, Data& data, long long most, const std::string& type,
                  const std::string& extension, const Write& write) {
  Pieces<Data> pieces(data, most > 0 ? most : cells_a_piece(data.GetNumberOfCells()));
  const std::filesystem::path place(path);
  std::vector<std::string> names;
  vtkSmartPointer<Data> piece;
  std::optional<PendingFiles> together;  // unless a caller holds them back anyway
  if (!PendingFiles::any()) together.emplace();
  for (vtkIdType k = 0; k < pieces.count(); ++k) {
    names.push_back(fmt::format("{}_{}{}", place.stem().string(), k, extension));
    piece = pieces.piece(k);
    write((place.parent_path() / names.back()).string(), *piece);
  }
  write_atomically(path, index_text(type, *piece, names));
  if (together) together->commit();
}

}  // namespace

long long cells_a_piece(long long cells) {
  constexpr long long least = 50000, pieces = 256;
  return std::max(least, (cells + pieces - 1) / pieces);
}

void write_pvtp(const std::string& path, vtkPolyData& data, long long most) {
  write_pieces(path, data, most, "PPolyData", ".vtp",
               [](const std::string& name, vtkPolyData& piece) { write_vtp(name, piece); });
}

void write_pvtu(const std::string& path, vtkUnstructuredGrid& data, long long most) {
  write_pieces(path, data, most, "PUnstructuredGrid", ".vtu",
               [](const std::string& name, vtkUnstructuredGrid& piece) { write_vtu(name, piece); });
}

}  // namespace crest::io
