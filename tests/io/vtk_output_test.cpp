// SPDX-License-Identifier: GPL-3.0-or-later
// What is not sound is never written: VTK data sets, numbers that are not finite, VTK's complaints.
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <vector>

#include "io/formats/vtk_quiet.hpp"
#include "io/write/formats.hpp"
#include "io/write/mesh_writer.hpp"
#include "io/write/poly_data.hpp"
#include "io/write/text.hpp"
#include "tests/support/temporary_folder.hpp"

namespace {

using crest::io::vtp_bytes;
using crest::io::vtu_bytes;
using crest::tests::TemporaryFolder;

void insert(vtkCellArray* cells, const std::vector<vtkIdType>& points) {
  cells->InsertNextCell(static_cast<vtkIdType>(points.size()), points.data());
}

/// Two triangles, a line and a vertex, each with a number; points, too.
struct Square {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> vertices, lines, triangles;
  vtkNew<vtkDoubleArray> of_points, of_cells;
  vtkNew<vtkPolyData> data;

  Square() {
    points->SetDataTypeToDouble();
    for (const double x : {0.0, 1.0})
      for (const double y : {0.0, 1.0}) points->InsertNextPoint(x, y, 0);
    insert(vertices, {0});
    insert(lines, {0, 1, 3});
    insert(triangles, {0, 1, 2});
    insert(triangles, {1, 3, 2});
    data->SetPoints(points);
    data->SetVerts(vertices);
    data->SetLines(lines);
    data->SetPolys(triangles);
    of_points->SetName("of points");
    of_cells->SetName("of cells");
    for (int i = 0; i < 4; ++i) of_points->InsertNextValue(i);
    for (int i = 0; i < 4; ++i) of_cells->InsertNextValue(i);
    data->GetPointData()->AddArray(of_points);
    data->GetCellData()->AddArray(of_cells);
  }
};

struct Fault {
  const char* words;  ///< of the error
  std::function<void(Square&)> make;
};

}  // namespace

TEST_CASE("unsound VTP data are an error that names the place", "[io]") {
  Square sound;
  CHECK_NOTHROW(vtp_bytes(*sound.data));
  const Fault faults[] = {
      {"line 1 has 1 points",
       [](Square& s) {
         insert(s.lines, {2});
         s.of_cells->InsertNextValue(4);
       }},
      {"line 0 has 0 points",
       [](Square& s) {
         s.lines->Reset();
         insert(s.lines, {});
       }},
      {"vertex 0 has 2 points",
       [](Square& s) {
         s.vertices->Reset();
         insert(s.vertices, {0, 1});
       }},
      {"polygon 2 names point 4 of 4",
       [](Square& s) {
         insert(s.triangles, {0, 1, 4});
       }},
      {"polygon 2 names point -1 of 4",
       [](Square& s) {
         insert(s.triangles, {0, 1, -1});
       }},
      {"array 'of cells' has 4 rows for 5",
       [](Square& s) {
         insert(s.triangles, {0, 1, 3});
       }},
      {"array 'of points' has 5 rows for 4", [](Square& s) { s.of_points->InsertNextValue(0); }},
      {"array without a name", [](Square& s) { s.of_cells->SetName(nullptr); }},
      {"array 'of cells' is not finite at 3",
       [](Square& s) { s.of_cells->SetValue(3, std::nan("")); }},
      {"array 'of points' is not finite at 0",
       [](Square& s) { s.of_points->SetValue(0, HUGE_VAL); }},
      {"array 'Points' is not finite at 2",
       [](Square& s) { s.points->SetPoint(2, 0, -HUGE_VAL, 0); }},
      {"array 'scale' is not finite at 0", [](Square& s) {
         vtkNew<vtkDoubleArray> scale;
         scale->SetName("scale");
         scale->InsertNextValue(HUGE_VAL);
         s.data->GetFieldData()->AddArray(scale);
       }}};
  for (const Fault& fault : faults) {
    Square square;
    fault.make(square);
    CHECK_THROWS_WITH(vtp_bytes(*square.data), std::string("the output's ") + fault.words);
  }
}

TEST_CASE("unsound VTU data are an error that names the place", "[io]") {
  const auto grid_of = [](int type, std::initializer_list<vtkIdType> cell) {
    Square square;
    auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
    vtkNew<vtkCellArray> cells;
    cells->InsertNextCell(cell);
    grid->SetPoints(square.points);
    grid->SetCells(type, cells);
    return grid;
  };
  CHECK(vtu_bytes(*grid_of(VTK_TRIANGLE, {0, 1, 2})).find("AppendedData") == std::string::npos);
  CHECK_THROWS_WITH(vtu_bytes(*grid_of(VTK_LINE, {0, 1})), "the output's cell 0 is no triangle");
  CHECK_THROWS_WITH(vtu_bytes(*grid_of(VTK_TRIANGLE, {0, 1})),
                    "the output's triangle 0 has 2 points");
  CHECK_THROWS_WITH(vtu_bytes(*grid_of(VTK_TRIANGLE, {0, 1, 9})),
                    "the output's triangle 0 names point 9 of 4");
}

TEST_CASE("no file holds a number that is not finite", "[io]") {
  const TemporaryFolder folder;
  for (const double x : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    for (const char* name : {"a.off", "a.obj", "a.ply", "a.vtp"}) {
      INFO(name);
      CHECK_THROWS_AS(
          crest::io::write_mesh(folder / name, {{0, 0, 0}, {1, 0, 0}, {0, x, 0}}, {{0, 1, 2}}),
          std::runtime_error);
    }
    crest::io::PolyData data;
    data.add_point({0, 0, 0});
    data.add_vertex(0).add("length", x);
    CHECK_THROWS_WITH(data.bytes(), "the output's array 'length' is not finite at 0");
    crest::io::Text text;
    const std::vector<double> numbers = {1, x};
    CHECK_THROWS_WITH(text.add("{}", x), "the output's number is not finite");
    CHECK_THROWS_WITH(text.add("{} {}\n", 1, fmt::join(numbers, " ")),
                      "the output's number is not finite");
    text.add("nan {} {}", 1.5, fmt::join(std::vector{1, 2}, " "));
    CHECK(text.text() == "nan 1.5 1 2");
  }
  CHECK(folder.entries() == 0);
}

TEST_CASE("the first thing VTK complains of is kept, in one line", "[io]") {
  const crest::io::VtkQuiet quiet;
  CHECK(quiet.complaint().empty());
  vtkNew<vtkPolyData> data;
  vtkGenericWarningMacro(<< "the first\nproblem");
  CHECK(quiet.complaint() == "the first problem");
  CHECK_FALSE(quiet.failed());
  vtkErrorWithObjectMacro(data.Get(), << "the second");
  CHECK(quiet.failed());
  CHECK(quiet.complaint() == "the first problem");
  const crest::io::VtkQuiet inner;
  vtkErrorWithObjectMacro(data.Get(), << "an error");
  CHECK(inner.complaint() == "an error");
}
