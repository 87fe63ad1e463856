// SPDX-License-Identifier: GPL-3.0-or-later
// Data sets in pieces: VTK's readers of pieces put them together to what the one file holds.
#include "io/write/vtk_pieces.hpp"

#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPPolyDataReader.h>
#include <vtkXMLPUnstructuredGridReader.h>

#include <catch2/catch.hpp>
#include <filesystem>

#include "io/curvature/curvature_writer.hpp"
#include "io/write/formats.hpp"
#include "io/write/poly_data.hpp"
#include "tests/support/closed_surfaces.hpp"
#include "tests/support/random.hpp"
#include "tests/support/temporary_folder.hpp"

namespace {

using namespace crest;
using tests::TemporaryFolder;

/// Vertices, polylines, triangles and strips with rows, and points of no cell.
vtkSmartPointer<vtkPolyData> mixed(tests::Random& random) {
  io::PolyData data;
  for (int i = 0; i < 200; ++i) {
    data.add_point({double(random() % 100), double(i), 0.25});
    data.point_rows().add("height", 0.5 * i);
  }
  const auto any = [&] { return static_cast<io::PolyData::Id>(random() % 190); };
  for (int c = 0; c < 60; ++c) {
    const auto a = any();
    const std::array<io::PolyData::Id, 4> row{a, a + 1, a + 3, a + 7};
    io::Columns& to = c % 4 == 0   ? data.add_vertex(a)
                      : c % 4 == 1 ? data.add_line(row)
                      : c % 4 == 2 ? data.add_triangle(a, a + 1, a + 2)
                                   : data.add_strip(row);
    to.add("number", c);
    to.add("name", std::string(1, static_cast<char>('a' + c % 26)));
  }
  data.fields().add("text", std::string("words"));
  return data.data();
}

/// Places of the cells' points with their height, and the cells' numbers: all that is drawn.
template <class Data>
std::vector<double> drawn(Data& data, const char* of_points, const char* of_cells) {
  std::vector<double> r;
  vtkDataArray* const points = data.GetPointData()->GetArray(of_points);
  vtkDataArray* const cells = of_cells ? data.GetCellData()->GetArray(of_cells) : nullptr;
  REQUIRE(points);
  for (vtkIdType c = 0; c < data.GetNumberOfCells(); ++c) {
    r.push_back(data.GetCellType(c));
    if (cells) r.push_back(cells->GetTuple1(c));
    vtkCell* const cell = data.GetCell(c);
    for (int i = 0; i < static_cast<int>(cell->GetNumberOfPoints()); ++i) {
      const vtkIdType v = cell->GetPointId(i);
      r.insert(r.end(), data.GetPoint(v), data.GetPoint(v) + 3);
      r.push_back(points->GetTuple1(v));
    }
  }
  return r;
}

template <class Reader>
auto read_back(const std::string& path) {
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkSmartPointer data = reader->GetOutput();
  return data;
}

}  // namespace

TEST_CASE("polydata in pieces: together they are the whole", "[io]") {
  tests::Random random(77);
  const auto whole = mixed(random);
  const auto expected = drawn(*whole, "height", "number");
  for (const long long most : {1LL, 7LL, 30LL, 59LL, 60LL, 1000LL}) {
    INFO(most << " cells a piece");
    const TemporaryFolder folder;
    io::write_pvtp(folder / "all.pvtp", *whole, most);
    const auto pieces = (59 + most) / most;
    CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == pieces + 1);
    const auto read = read_back<vtkXMLPPolyDataReader>(folder / "all.pvtp");
    // VTK numbers vertices before lines before polygons: of the cells' numbers only the set.
    auto found = drawn(*read, "height", "number"), sorted = expected;
    std::sort(found.begin(), found.end());
    std::sort(sorted.begin(), sorted.end());
    CHECK(found == sorted);
    CHECK(read->GetCellData()->GetAbstractArray("name") == nullptr);  // VTK cannot read it
    CHECK(read->GetPointData()->GetGlobalIds() != nullptr);
    if (pieces == 1) CHECK(read->GetNumberOfPoints() == whole->GetNumberOfPoints());
    if (pieces == 1) CHECK(drawn(*read, "height", "number") == expected);
  }
}

TEST_CASE("polydata in pieces: nothing at all is one piece", "[io]") {
  const TemporaryFolder folder;
  vtkNew<vtkPolyData> nothing;
  io::write_pvtp(folder / "all.pvtp", *nothing);
  CHECK(std::filesystem::exists(folder / "all_0.vtp"));
  CHECK(read_back<vtkXMLPPolyDataReader>(folder / "all.pvtp")->GetNumberOfCells() == 0);
}

TEST_CASE("curvatures in pieces: the cells of the whole, in its order", "[io]") {
  const TemporaryFolder folder;
  const tests::Surface s = tests::icosphere(3);
  const kernel::TriangleMesh mesh(s.points, s.triangles);
  const auto result = curvature::estimate(mesh, curvature::Options{});
  const auto whole = io::curvature_poly_data(mesh, result, {});
  const auto expected = drawn(*whole, "H", nullptr);
  io::write_pvtp(folder / "c.pvtp", *whole, 100);
  CHECK(drawn(*read_back<vtkXMLPPolyDataReader>(folder / "c.pvtp"), "H", nullptr) == expected);
  io::write_curvature(folder / "d.pvtu", mesh, result, {});
  CHECK(drawn(*read_back<vtkXMLPUnstructuredGridReader>(folder / "d.pvtu"), "H", nullptr) ==
        expected);
}

TEST_CASE("pieces have 50 000 cells, more where there would be more than 256", "[io]") {
  CHECK(io::cells_a_piece(0) == 50000);
  CHECK(io::cells_a_piece(12800000) == 50000);
  CHECK(io::cells_a_piece(12800001) == 50001);
}
