// SPDX-License-Identifier: GPL-3.0-or-later
// Soups: cells of every kind and fields with their own numbers, and which of them are a surface.
#include <catch2/catch.hpp>

#include "io/formats/readers.hpp"
#include "io/read/mesh_reader.hpp"
#include "io/read/point_values.hpp"
#include "kernel/geometry/input_error.hpp"
#include "tests/support/temporary_folder.hpp"

namespace {

using namespace crest::io;
using crest::kernel::InputError;
using crest::kernel::Vec3;
using crest::tests::TemporaryFolder;
using crest::tests::write_text;

template <class Call>
std::string error_of(Call&& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::string array(const char* type, const char* name, const std::string& values,
                  int components = 1) {
  return std::string("<DataArray type=\"") + type + "\" Name=\"" + name +
         "\" NumberOfComponents=\"" + std::to_string(components) + "\" format=\"ascii\">" + values +
         "</DataArray>\n";
}

/// A tetrahedron, two triangles, a quadrangle, a line and a point over six points.
std::string mixed_vtu(const std::string& point_data, const std::string& cell_data) {
  return "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
         "<UnstructuredGrid><Piece NumberOfPoints=\"6\" NumberOfCells=\"6\">\n<PointData>" +
         point_data + "</PointData>\n<CellData>" + cell_data + "</CellData>\n<Points>" +
         array("Float64", "Points", "0 0 0 1 0 0 0 1 0 0 0 1 1 1 0 5 5 5", 3) +
         "</Points>\n<Cells>" +
         array("Int64", "connectivity", "0 1 2 3 0 1 2 1 4 2 0 1 4 2 0 5 5") +
         array("Int64", "offsets", "4 7 10 14 16 17") + array("UInt8", "types", "10 5 5 9 3 1") +
         "</Cells>\n</Piece></UnstructuredGrid></VTKFile>\n";
}

/// The faces of a tetrahedron over four points and a fifth that nothing uses.
std::string tetrahedron_vtp(const std::string& point_data, const std::string& attributes = "") {
  return "<VTKFile type=\"PolyData\" version=\"1.0\" "
         "byte_order=\"LittleEndian\">\n<PolyData><Piece "
         "NumberOfPoints=\"5\" NumberOfPolys=\"4\">\n<PointData" +
         attributes + ">" + point_data + "</PointData>\n<Points>" +
         array("Float64", "Points", "0 0 0 1 0 0 9 9 9 0 1 0 0 0 1", 3) + "</Points>\n<Polys>" +
         array("Int64", "connectivity", "0 3 1 0 1 4 1 3 4 0 4 3") +
         array("Int64", "offsets", "3 6 9 12") + "</Polys>\n</Piece></PolyData></VTKFile>\n";
}

MeshRequest field_and_normals(const char* field) {
  MeshRequest request;
  request.field = field;
  request.normals = true;
  return request;
}

Soup triangle_and_line() {
  Soup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  soup.cells.add(CellType::line, std::array<Cells::Node, 2>{0, 1});
  soup.cells.add(CellType::triangle, std::array<Cells::Node, 3>{0, 1, 2});
  return soup;
}

}  // namespace

TEST_CASE("a grid of mixed cells keeps their types and nodes", "[io]") {
  const Soup soup = read_vtu(mixed_vtu("", ""), {});
  REQUIRE(soup.points.size() == 6);
  CHECK(soup.points[5] == Vec3{5, 5, 5});
  const CellType types[] = {CellType::tetrahedron, CellType::triangle, CellType::triangle,
                            CellType::quad,        CellType::line,     CellType::vertex};
  const int dimensions[] = {3, 2, 2, 2, 1, 0};
  REQUIRE(soup.cells.size() == 6);
  for (std::size_t c = 0; c < 6; ++c) {
    CHECK(soup.cells.type(c) == types[c]);
    CHECK(dimension_of(soup.cells.type(c)) == dimensions[c]);
  }
  const auto quad = soup.cells.nodes(3);
  CHECK(std::vector<Cells::Node>(quad.begin(), quad.end()) == std::vector<Cells::Node>{0, 1, 4, 2});
  CHECK(dimension_of(CellType{200}) == -1);
}

TEST_CASE("fields keep their components and their own kind of number", "[io]") {
  const std::string points =
      array("Int64", "i", "1 2 9007199254740993 4 5 -6") +
      array("UInt64", "u", "1 2 18446744073709551615 4 5 6") +
      array("Float32", "f", "0.5 1 2 3 4 5") +
      array("Float64", "v", "0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17", 3);
  const std::string cells = array("Float64", "c", "1 2 3 4 5 6");
  const Soup soup = read_vtu(mixed_vtu(points, cells), {true, "no such"});
  REQUIRE(soup.point_fields.size() == 4);
  const auto& fields = soup.point_fields;
  CHECK(std::get<std::vector<std::int64_t>>(fields[0].numbers)[2] == 9007199254740993);
  CHECK(std::get<std::vector<std::int64_t>>(fields[0].numbers)[5] == -6);
  CHECK(std::get<std::vector<std::uint64_t>>(fields[1].numbers)[2] == 18446744073709551615u);
  CHECK(std::get<std::vector<double>>(fields[2].numbers)[0] == 0.5);
  CHECK(fields[3].components == 3);
  CHECK(std::get<std::vector<double>>(fields[3].numbers)[17] == 17);
  REQUIRE(soup.cell_fields.size() == 1);
  CHECK(soup.cell_fields[0].size() == 6);
  CHECK(PointValues(soup, "f", "").at(5) == 5);
  CHECK(PointValues(soup, "i", "").at(1) == 2);
  for (const std::size_t i : {0u, 1u}) {
    CHECK(error_of([&] { PointValues(soup, fields[i].name, "").at(2); }) ==
          "vertex 2: its value of '" + fields[i].name +
              "' exceeds 2^53; store the field as doubles");
  }
  const auto choice = [&](const char* name) {
    return error_of([&] { PointValues(soup, name, "use another file"); });
  };
  CHECK(choice("v") ==
        "field 'v': has 3 components; the scalar fields are 'i', 'u', 'f', of cells 'c'");
  CHECK(
      choice("w").starts_with("field 'w': does not exist; the scalar fields are 'i', 'u', 'f', "));
  CHECK(choice("f") == "no error");
  // The mean over the faces around a point: cells 1 to 3, the quadrangle once.
  const PointValues means(soup, "c", "");
  CHECK(means.at(0) == (2.0 + 4.0) / 2);
  CHECK(means.at(4) == (3.0 + 4.0) / 2);
  CHECK(means.at(2) == (2.0 + 3.0 + 4.0) / 3);
  CHECK(means.note() == "'c' is a field of cells: each vertex has the mean over its faces");
}

TEST_CASE("only what may be meant is loaded", "[io]") {
  const std::string points =
      array("Float64", "a", "1 2 3 4 5 6") + array("Float64", "b", "1 2 3 4 5 6");
  const std::string file = mixed_vtu(points, array("Float64", "c", "1 2 3 4 5 6"));
  CHECK(read_vtu(file, {}).point_fields.empty());
  const Soup one = read_vtu(file, {true, "b"});
  REQUIRE(one.point_fields.size() == 1);
  CHECK(one.point_fields[0].name == "b");
  CHECK(one.cell_fields.empty());
  CHECK(read_vtu(file, {true, ""}).point_fields.size() == 2);
}

TEST_CASE("what is left out of a soup is noted, numbers stay the file's", "[io]") {
  Soup soup = triangle_and_line();
  soup.warnings = {"odd"};
  soup.point_tags = {7, 8, 9};
  const MeshFile file = mesh_of_soup(soup);
  CHECK(file.mesh.face_count() == 1);
  CHECK(file.warnings == std::vector<std::string>{"odd", "left out 1 line"});
  CHECK(file.numbers.faces == std::vector<std::int64_t>{1});
  CHECK(file.numbers.vertices == std::vector<std::int64_t>{7, 8, 9});
}

TEST_CASE("fields and normals of a file are those of the mesh's vertices", "[io]") {
  const TemporaryFolder folder;
  const std::string path = folder / "a.vtp";
  const std::string normals = array("Float32", "N", "0 0 1 0 0 2 0 0 3 0 0 4 0 0 5", 3);
  write_text(path,
             tetrahedron_vtp(array("Float64", "a", "1 2 nan 4 5") + normals, " Normals=\"N\""));
  const MeshFile file = read_mesh(path, field_and_normals("a"));
  CHECK(file.mesh.vertex_count() == 4);
  CHECK(file.numbers.vertices == std::vector<std::int64_t>{0, 1, 3, 4});
  CHECK(file.values == std::vector<double>{1, 2, 4, 5});
  CHECK(file.normals == std::vector<Vec3>{{0, 0, 1}, {0, 0, 2}, {0, 0, 4}, {0, 0, 5}});
  CHECK(error_of([&] { read_mesh(path, field_and_normals("b")); }) ==
        path + ": field 'b': does not exist; the scalar fields are 'a'");
  MeshRequest request;
  request.normals = true;
  write_text(path, tetrahedron_vtp(array("Float32", "N", "0 0 1 0 0 0 0 0 0 0 0 4 0 0 5", 3),
                                   " Normals=\"N\""));
  CHECK(error_of([&] { read_mesh(path, request); }) ==
        path + ": vertex 1: its normal is zero; repair it or use --normals estimated");
  write_text(path, tetrahedron_vtp(normals));
  CHECK(error_of([&] {
          read_mesh(path, request);
        }).starts_with(path + ": normals: the file has none"));
}

TEST_CASE("what reads fields and normals of a VTP file checks it first", "[io]") {
  const TemporaryFolder folder;
  const std::string path = folder / "a.vtp";
  std::string text = tetrahedron_vtp(array("Float64", "a", "1 2 3 4 5"));
  text.replace(text.find("NumberOfPoints=\"5"), 17, "NumberOfPoints=\"99999999995");
  write_text(path, text);
  const std::string expected =
      path + ": header: NumberOfPoints is 99999999995, more than the file holds; ";
  CHECK(error_of([&] { read_mesh(path, field_and_normals("a")); }).starts_with(expected));
  CHECK(error_of([&] { read_mesh(path); }).starts_with(expected));
}
