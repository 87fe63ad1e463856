// SPDX-License-Identifier: GPL-3.0-or-later
// Hand-made faults of files with functions: one line with file, element and remedy.
#include <catch2/catch.hpp>
#include <limits>

#include "io/read/quadratic_reader.hpp"
#include "kernel/geometry/input_error.hpp"
#include "tests/support/quadratic_files.hpp"

namespace {

using crest::io::FunctionSource;
using crest::kernel::Expression;
using crest::kernel::kNone;
using namespace crest::tests;

double slope(const Vec3& p) {
  return p[0] + 0.25 * p[1];
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

std::string error_of(const std::string& name, const std::string& text,
                     const FunctionSource& source = {}) {
  try {
    crest::io::read_quadratic_mesh_bytes(name, text, source);
  } catch (const crest::kernel::InputError& error) {
    const std::string line = error.what();
    CHECK(line.starts_with(name + ": "));
    CHECK(line.find("; ") != std::string::npos);
    CHECK(line.find('\n') == std::string::npos);
    return line;
  }
  return "no error";
}

void check_error(const std::string& name, const std::string& text, const std::string& expected,
                 const FunctionSource& source = {}) {
  const std::string line = error_of(name, text, source);
  INFO(name << " -> " << line << "\nexpected " << expected);
  CHECK(line.find(expected) != std::string::npos);
}

const QuadraticGrid kSquare = square_grid(1, slope);  // nodes 0..3 corners, 4..8 mid-side

}  // namespace

TEST_CASE("bad values name their node", "[io]") {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    QuadraticGrid grid = kSquare;
    grid.values[2] = bad;
    check_error("a.vtu", vtu_text(grid), "vertex 2: its value of 'T' is ");
    check_error("a.msh", msh_text(grid, 4), "vertex 16: its value of 'T' is ");
    grid = kSquare;
    grid.values[6] = bad;
    check_error("a.vtu", vtu_text(grid), "vertex 6: its value of 'T' is ");
    check_error("a.msh", msh_text(grid, 2), "vertex 28: its value of 'T' is ");
    grid = kSquare;
    grid.nodes[6][1] = bad;
    check_error("a.vtu", vtu_text(grid), "vertex 6: its coordinate y is not ");
    check_error("a.msh", msh_text(grid, 2), "vertex 28 (line 12): its coordinate y is not ");
  }
  check_error("a.msh", replaced(msh_text(kSquare, 2), "\n16 0.75", "\n17 0.75"),
              "field 'T': node 17 does not exist");
  const std::string partial =
      replaced(msh_text(kSquare, 2), "\n1\n9\n10 ", "\n1\n8\n");  // the first value is gone
  CHECK(error_of("a.msh", partial) != "no error");
}

TEST_CASE("missing mid-side nodes are named with their cell", "[io]") {
  const std::string vtu = vtu_text(kSquare);
  // The first cell is told to end after its corners and two middles.
  std::string shorter =
      replaced(vtu, "offsets\" format=\"ascii\">\n6\n", "offsets\" format=\"ascii\">\n5\n");
  check_error("a.vtu", shorter, "cell 0: has 5 nodes instead of 6; ");
  const std::string lost = replaced(vtu, "0 2 3 4 5 6 ", "0 2 3 4 5 99 ");
  check_error("a.vtu", lost, "face 0: vertex 99 (counted from 0) does not exist");
  check_error("a.vtu", replaced(vtu, "0 2 3 4 5 6 ", "0 2 3 4 5 -1 "), "vertex -1 (counted");
  check_error("a.vtu", replaced(vtu, "0 2 3 4 5 6 ", "0 2 77 4 5 6 "),
              "face 0: vertex 77 (counted from 0) does not exist");
  const std::string msh = msh_text(kSquare, 2);
  check_error("a.msh", replaced(msh, " 10 16 19 22 25 28\n", " 10 16 19\n"),
              "element 10 (line 19): has 3 nodes instead of 6; its mid-side nodes are missing");
  check_error("a.msh", replaced(msh, " 10 16 19 22 25 28\n", " 10 16 19 22 25 29\n"),
              "element 10 (line 19): node 29 does not exist");
}

TEST_CASE("the field is found or the message has the names there are", "[io]") {
  const std::string vtu = vtu_text(kSquare);
  check_error("a.vtu", vtu, "field 'U': does not exist; the scalar fields are 'T'",
              {"U", {}, false});
  check_error("a.msh", msh_text(kSquare, 4), "field 'U': does not exist; the scalar fields are 'T'",
              {"U", {}, false});
  const std::string array =
      "<DataArray type=\"Float64\" Name=\"V\" format=\"ascii\">0 0 0 0 0 0 0 0 0</DataArray>\n";
  const std::string two = replaced(vtu, "</PointData>", array + "</PointData>");
  check_error("a.vtu", two,
              "fields: there are several; the scalar fields are 'T', 'V'; choose one");
  CHECK(error_of("a.vtu", two, {"V", {}, false}) == "no error");
  const std::string of_cells = replaced(vtu, "<Points>",
                                        "<CellData>\n<DataArray type=\"Float64\" Name=\"C\" "
                                        "format=\"ascii\">0 0</DataArray>\n</CellData>\n<Points>");
  CHECK(error_of("a.vtu", of_cells, {"C", {}, false}) == "no error");
  const std::string vectors = replaced(
      vtu, "</PointData>",
      "<DataArray type=\"Float64\" Name=\"W\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 0 0 "
      "0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0</DataArray>\n</PointData>");
  check_error("a.vtu", vectors, "field 'W': has 3 components", {"W", {}, false});
  CHECK(error_of("a.vtu", vectors) == "no error");  // T is the only one that can be meant
  const auto begin = vtu.find("<PointData>"), end = vtu.find("</PointData>");
  const std::string none = vtu.substr(0, begin) + "<PointData>" + vtu.substr(end);
  check_error("a.vtu", none, "fields: none is given; the file has no scalar field");
  check_error("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "fields: none is given; ");
  const std::string msh = msh_text(kSquare, 2);
  const std::string again = msh.substr(msh.find("$NodeData"));
  check_error("a.msh", msh + again, "fields: there are several");
  check_error("a.msh", msh + again, "field 'T': is there several times", {"T", {}, false});
  const std::string large = replaced(
      vtu, "</PointData>",
      "<DataArray type=\"Int64\" Name=\"L\" format=\"ascii\">0 0 9007199254740993 0 0 0 0 0 "
      "0</DataArray>\n</PointData>");
  check_error("a.vtu", replaced(large, "9007199254740993", "9007199254740995"),
              "vertex 2: its value of 'L' exceeds 2^53", {"L", {}, false});
}

TEST_CASE("what is not a surface is named in the file's numbers", "[io]") {
  QuadraticGrid grid = kSquare;
  for (auto& cell : grid.cells) cell[3] = cell[4] = cell[5] = kNone;
  grid.cells.push_back({0, 3, 6, kNone, kNone, kNone});
  check_error("a.vtu", vtu_text(grid), "edge 0-3: is in faces 0, 1 and 2, ");
  check_error("a.msh", msh_text(grid, 4), "edge 10-19: is in faces 10, 13 and 16");
  grid = kSquare;
  grid.cells[1][4] = 1;
  check_error("a.vtu", vtu_text(grid), "vertex 1: is a corner of one face and a mid-side node of");
  // Each face has a middle node of its own on the diagonal, with values that differ.
  grid = kSquare;
  const Index own = static_cast<Index>(grid.nodes.size());
  for (Index& node : grid.cells[1])
    if (node == 6) node = own;
  grid.nodes.push_back(grid.nodes[6]);
  grid.values.push_back(grid.values[6] + 1);
  check_error("a.vtu", vtu_text(grid), "edge 0-3: faces 0 and 1 have the values ");
  grid.values.back() = grid.values[6];
  CHECK(error_of("a.vtu", vtu_text(grid)) == "no error");
  grid.cells.clear();
  check_error("a.vtu", vtu_text(grid), "faces: there are none");
  check_error("a.msh", msh_text(grid, 4), "faces: there are none");
  check_error("a.vtu", "", "file: is empty");
  check_error("a.msh", "", "file: is empty");
}

TEST_CASE("other cells and formats are refused, lines and points left out", "[io]") {
  const std::string vtu = vtu_text(kSquare);
  check_error("a.vtu", replaced(vtu, "22\n22\n", "22\n53\n"), "cell 1: has VTK's type 53; give");
  const std::string lines = replaced(vtu, "22\n22\n", "21\n22\n");
  const auto file = crest::io::read_quadratic_mesh_bytes("a.vtu", lines, {});
  CHECK(file.mesh.face_count() == 1);
  CHECK(file.warnings[0] == "left out 1 line");
  check_error("a.vtu", replaced(vtu, "Name=\"types\"", "Name=\"faces\""), "there are polyhedra");
  check_error("a.vtu", vtu.substr(0, vtu.size() / 2), "cannot be read as VTU");
  check_error("a.vtu", replaced(vtu, "NumberOfCells=\"2\"", "NumberOfCells=\"99999999999\""),
              "NumberOfCells is 99999999999, more than the file holds");
  const std::string msh = msh_text(kSquare, 2);
  check_error("a.msh", replaced(msh, "2.2 0 8", "2.2 1 8"), "$MeshFormat: has no mark of the byte");
  check_error("a.msh", replaced(msh, "2.2 0 8", "4 0 8"), "$MeshFormat: is neither 2.2 nor 4.1");
  check_error("a.msh", msh.substr(0, msh.find("$Elements") + 12), "$Elements: ends early");
  check_error("a.msh", msh.substr(0, msh.find("$EndNodeData")), "$NodeData: does not end");
  check_error("a.msh", replaced(msh, "\n10 9 2 1 1", "\n10 4 2 1 1"),
              "element 10 (line 19): has more than 4 nodes");
  check_error("a.msh", replaced(msh, "$Nodes\n9", "$Nodes\nnine"),
              "line 5: 'nine' is not an integer");
  check_error("a.msh", replaced(msh, "$Nodes\n9", "$Nodes\n99999999999"), "$Nodes: ends early");
  check_error("a.msh", replaced(msh, "\n13 ", "\n10 "), "node 10: is there twice");
  check_error("a.msh", "hello\n", "file: has no $MeshFormat");
  check_error("a.xyz", "hello\n",
              "use .off, .obj, .ply, .stl, .vtp, .vtu, .vtk, .msh, .pvtp or .pvtu");
}

TEST_CASE("an expression that is not finite somewhere names the place", "[io]") {
  const FunctionSource source{"", Expression::parse("1/x", {"x", "y", "z"}), false};
  const std::string off = "OFF\n3 1 0\n-1 0 0\n1 0 0\n2 1 0\n3 0 1 2\n";
  check_error("a.off", off, "edge 0-1: the expression is inf at its middle", source);
  check_error("a.off", replaced(off, "2 1 0\n3", "0 1 0\n3"),
              "vertex 2: the expression is inf there", source);
}
