// SPDX-License-Identifier: GPL-3.0-or-later
// The one way from polylines to VTK.
#include "io/write/poly_data.hpp"

#include <SMP/Common/vtkSMPToolsAPI.h>
#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <array>
#include <catch2/catch.hpp>
#include <stdexcept>

#include "algorithms/feature_lines/feature_graph.hpp"
#include "io/features/feature_writer.hpp"
#include "io/write/atomic_file.hpp"
#include "tests/support/temporary_folder.hpp"

namespace {

using crest::io::PolyData;
using crest::tests::TemporaryFolder;
using Ids = std::vector<PolyData::Id>;

vtkSmartPointer<vtkPolyData> read_back(const std::string& path) {
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

double cell_value(vtkPolyData& data, const char* name, vtkIdType cell) {
  vtkDataArray* array = data.GetCellData()->GetArray(name);
  REQUIRE(array != nullptr);
  return array->GetTuple1(cell);
}

}  // namespace

TEST_CASE("cells stand with their rows in VTK's order, a line of one point as a vertex", "[io]") {
  const TemporaryFolder folder;
  PolyData data;
  data.add_points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  const auto row = [&](crest::io::Columns& columns, int number) {
    columns.add("number", number);
    columns.add("half", 0.5 * number);
  };
  row(data.add_triangle(0, 1, 2), 4);
  row(data.add_line(Ids{0, 1, 2, 0}), 2);
  row(data.add_line(Ids{2}), 0);
  row(data.add_line(Ids{1, 2}), 3);
  row(data.add_vertex(1), 1);
  data.fields().add("text", std::string("words"));
  crest::io::write_atomically(folder / "a.vtp", data.bytes());
  const auto read = read_back(folder / "a.vtp");
  CHECK(read->GetNumberOfVerts() == 2);
  CHECK(read->GetNumberOfLines() == 2);
  CHECK(read->GetNumberOfPolys() == 1);
  const vtkIdType sizes[] = {1, 1, 4, 2, 3};
  for (vtkIdType c = 0; c < 5; ++c) {
    CHECK(cell_value(*read, "number", c) == static_cast<double>(c));
    CHECK(cell_value(*read, "half", c) == 0.5 * static_cast<double>(c));
    CHECK(read->GetCell(c)->GetNumberOfPoints() == sizes[c]);
  }
  CHECK(read->GetFieldData()->GetAbstractArray("text") != nullptr);
}

TEST_CASE("cells without points, or with points that are not there, are never written", "[io]") {
  PolyData data;
  data.add_point({0, 0, 0});
  CHECK_THROWS_AS(data.add_line(Ids{}), std::logic_error);
  CHECK_THROWS_AS(data.add_line(Ids{0, 1}), std::logic_error);
  CHECK_THROWS_AS(data.add_vertex(-1), std::logic_error);
  data.add_vertex(0).add("a", 1);
  CHECK_THROWS_AS(data.add_vertex(0).add("a", 1.5), std::logic_error);
}

TEST_CASE("VTK writes in one thread", "[io]") {
  // In several it is a matter of chance, one run in hundreds, which of 0 and -0 a range begins
  // with.
  PolyData data;
  data.add_vertex(data.add_point({0, 0, 0}));
  data.bytes();
  CHECK(std::string(vtk::detail::smp::vtkSMPToolsAPI::GetInstance().GetBackend()) == "Sequential");
}

TEST_CASE("a feature line of one vertex is written as a vertex", "[io]") {
  namespace features = crest::feature_lines;
  const TemporaryFolder folder;
  // A square fan; its middle is marked alone.
  const crest::kernel::TriangleMesh mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}},
                                         {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}});
  const features::FeatureGraph graph = features::build_feature_graph(mesh, {1, 0, 0, 0, 0});
  REQUIRE(graph.lines.size() == 1);
  REQUIRE(graph.lines[0].vertices.size() == 1);
  crest::io::write_features(folder / "f.vtp", mesh, graph, {9, 1, 2, 3, 4}, "abc");
  const auto read = read_back(folder / "f.vtp");
  CHECK(read->GetNumberOfVerts() == 1);
  CHECK(read->GetNumberOfLines() == 0);
  CHECK(read->GetNumberOfPolys() == 4);
  CHECK(cell_value(*read, "kind", 0) == 5);
  CHECK(cell_value(*read, "kind", 1) == 0);
}
