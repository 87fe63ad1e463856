// SPDX-License-Identifier: GPL-3.0-or-later
// Arrays in VTK's XML formats, as this library compresses them: VTK's own readers give them back.
#include "io/write/inline_array.hpp"

#include <tbb/global_control.h>
#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSOADataArrayTemplate.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>

#include "io/write/formats.hpp"
#include "tests/support/random.hpp"
#include "tests/support/temporary_folder.hpp"

namespace {

using crest::tests::Random;
using crest::tests::TemporaryFolder;

constexpr std::size_t kBlock = 32768, kRun = 16 * kBlock;

std::string inline_array(const std::string& bytes) {
  std::string text;
  crest::io::write_inline_array(bytes, kBlock, [&](std::string_view piece) { text += piece; });
  return text;
}

std::string noise(std::size_t size) {
  Random random(5);
  std::string bytes(size, '\0');
  for (char& c : bytes) c = static_cast<char>(random() & 255u);
  return bytes;
}

bool same(vtkAbstractArray* a, vtkAbstractArray* b) {
  if (!a || !b || a->GetDataType() != b->GetDataType() ||
      a->GetNumberOfComponents() != b->GetNumberOfComponents() ||
      a->GetNumberOfTuples() != b->GetNumberOfTuples())
    return false;
  const auto size = static_cast<std::size_t>(a->GetNumberOfValues() * a->GetDataTypeSize());
  return size == 0 || std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0), size) == 0;
}

/// A strip of triangles of so many points, numbers of several types, some of which can be
/// compressed and some cannot, both beyond a run.
vtkSmartPointer<vtkPolyData> strip(int points) {
  Random random(7);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  vtkNew<vtkIntArray> labels;
  labels->SetName("labels");
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetName("colours");
  colours->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> given;
  given->SetName("given");
  for (int i = 0; i < points; ++i) {
    places->InsertNextPoint(i, static_cast<double>(random()) * 0x1p-64,
                            static_cast<double>(random()) * 0x1p-64);
    labels->InsertNextValue(i / 1000);
    const unsigned char colour[] = {1, static_cast<unsigned char>(i), 3};
    colours->InsertNextTypedTuple(colour);
    given->InsertNextValue(i == 3 ? std::nanf("") : static_cast<float>(i));
  }
  vtkNew<vtkCellArray> cells;
  for (int i = 0; i + 2 < points; ++i) cells->InsertNextCell({i, i + 1, i + 2});
  vtkNew<vtkStringArray> texts;
  texts->SetName("texts");
  for (const char* text : {"", "a", "two words"}) texts->InsertNextValue(text);
  data->SetPoints(places);
  data->SetPolys(cells);
  for (vtkDataArray* array :
       {vtkDataArray::SafeDownCast(labels), vtkDataArray::SafeDownCast(colours),
        vtkDataArray::SafeDownCast(given)})
    data->GetPointData()->AddArray(array);
  data->GetFieldData()->AddArray(texts);
  return data;
}

void require_same(vtkPointSet& written, vtkPointSet& read) {
  REQUIRE(same(written.GetPoints()->GetData(), read.GetPoints()->GetData()));
  vtkPointData& rows = *written.GetPointData();
  REQUIRE(read.GetPointData()->GetNumberOfArrays() == rows.GetNumberOfArrays());
  for (int i = 0; i < rows.GetNumberOfArrays(); ++i) {
    INFO(rows.GetArrayName(i));
    CHECK(same(rows.GetArray(i), read.GetPointData()->GetAbstractArray(rows.GetArrayName(i))));
  }
}

void require_same(vtkCellArray& written, vtkCellArray& read) {
  REQUIRE(read.GetNumberOfCells() == written.GetNumberOfCells());
  REQUIRE(same(written.GetConnectivityArray(), read.GetConnectivityArray()));
  CHECK(same(written.GetOffsetsArray(), read.GetOffsetsArray()));
}

template <class Reader>
vtkSmartPointer<Reader> read(const std::string& path) {
  auto reader = vtkSmartPointer<Reader>::New();
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader;
}

}  // namespace

TEST_CASE("what VTP files hold is what VTK reads, bit by bit", "[io]") {
  const TemporaryFolder folder;
  for (const int points : {3, 1365, 1366, 60000}) {  // 24 bytes each: a block, one more, runs
    INFO(points << " points");
    const auto data = strip(points);
    crest::io::write_vtp(folder / "a.vtp", *data, {"given"});
    const auto reader = read<vtkXMLPolyDataReader>(folder / "a.vtp");
    vtkPolyData& again = *reader->GetOutput();
    require_same(*data, again);
    require_same(*data->GetPolys(), *again.GetPolys());
    auto* texts = vtkStringArray::SafeDownCast(again.GetFieldData()->GetAbstractArray("texts"));
    REQUIRE(texts);
    REQUIRE(texts->GetNumberOfValues() == 3);
    CHECK(texts->GetValue(0).empty());
    CHECK(texts->GetValue(2) == "two words");
  }
}

TEST_CASE("what VTU and VTI files hold is what VTK reads, bit by bit", "[io]") {
  const TemporaryFolder folder;
  const auto data = strip(30000);
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(data->GetPoints());
  grid->SetCells(VTK_TRIANGLE, data->GetPolys());
  grid->GetPointData()->AddArray(data->GetPointData()->GetArray("labels"));
  crest::io::write_vtu(folder / "a.vtu", *grid);
  const auto grids = read<vtkXMLUnstructuredGridReader>(folder / "a.vtu");
  require_same(*grid, *grids->GetOutput());
  require_same(*grid->GetCells(), *grids->GetOutput()->GetCells());

  vtkNew<vtkImageData> image;
  image->SetDimensions(40, 30, 20);
  image->AllocateScalars(VTK_SHORT, 1);
  auto* samples = static_cast<short*>(image->GetScalarPointer());
  for (int i = 0; i < 40 * 30 * 20; ++i) samples[i] = static_cast<short>(i * i);
  image->GetPointData()->GetScalars()->SetName("value");
  crest::io::write_vti(folder / "a.vti", *image);
  const auto images = read<vtkXMLImageDataReader>(folder / "a.vti");
  CHECK(
      same(image->GetPointData()->GetScalars(), images->GetOutput()->GetPointData()->GetScalars()));
}

TEST_CASE("a file is the bytes, the same in one thread and in two", "[io]") {
  const TemporaryFolder folder;
  const auto data = strip(60000);
  const auto bytes = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return crest::io::vtp_bytes(*data, {"given"});
  };
  const std::string one = bytes(1);
  CHECK(one == bytes(2));
  crest::io::write_vtp(folder / "a.vtp", *data, {"given"});
  std::ifstream file(folder / "a.vtp", std::ios::binary);
  CHECK(one == std::string(std::istreambuf_iterator<char>(file), {}));
  CHECK(one.find("header_type=\"UInt32\"") != one.npos);
  CHECK(one.find("AppendedData") == one.npos);
}

TEST_CASE("runs that cannot be compressed are stored, the others compressed", "[io]") {
  const std::string wild = noise(kRun), flat(kRun, 'a');
  const std::size_t of_wild = inline_array(wild).size(), of_flat = inline_array(flat).size();
  CHECK(of_wild >= 4 * kRun / 3);
  CHECK(static_cast<double>(of_wild) < 1.001 * 4 / 3 * static_cast<double>(kRun));
  CHECK(of_flat < kRun / 100);
  // Each run for itself, whatever stood before it.
  CHECK(inline_array(wild + flat).size() < of_wild + of_flat + 4);
  CHECK(inline_array(flat + wild).size() < of_wild + of_flat + 4);
  CHECK(inline_array("") == "AAAAAACAAAAAAAAA");  // no block, of 2^15 bytes, none smaller
}

TEST_CASE("an array that is made block by block is that of its bytes", "[io]") {
  for (const std::size_t size : {std::size_t{0}, std::size_t{5}, kBlock, kRun + 3, 3 * kRun}) {
    const std::string bytes = noise(size / 2) + std::string(size - size / 2, 'b');
    std::string text;
    const auto made = [&](std::size_t at, std::size_t length, std::vector<char>& room) {
      room.assign(bytes.begin() + static_cast<std::ptrdiff_t>(at),
                  bytes.begin() + static_cast<std::ptrdiff_t>(at + length));
      return std::string_view(room.data(), room.size());
    };
    crest::io::write_inline_array(size, made, kBlock,
                                  [&](std::string_view piece) { text += piece; });
    CHECK(text == inline_array(bytes));
  }
}

TEST_CASE("arrays of which VTK has no bytes in order are refused", "[io]") {
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(0, 0, 0);
  data->SetPoints(points);
  vtkNew<vtkSOADataArrayTemplate<int>> columns;
  columns->SetName("columns");
  columns->SetNumberOfComponents(2);
  columns->SetNumberOfTuples(1);
  columns->Fill(1);
  data->GetPointData()->AddArray(columns);
  CHECK_THROWS_AS(crest::io::vtp_bytes(*data), std::logic_error);
}
