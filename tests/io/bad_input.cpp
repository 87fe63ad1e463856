// SPDX-License-Identifier: GPL-3.0-or-later
// Hand-made faults: each gives one line that names the file, the element and a remedy.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <string>

#include "io/read/mesh_reader.hpp"
#include "kernel/geometry/input_error.hpp"
#include "tests/support/temporary_folder.hpp"

namespace {

using crest::io::read_mesh;
using crest::tests::TemporaryFolder;
using crest::tests::write_text;

std::string error_of(const std::string& path) {
  try {
    read_mesh(path);
  } catch (const crest::kernel::InputError& error) {
    return error.what();
  }
  return "no error";
}

const std::string kTetrahedron = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
const std::string kTetrahedronFaces = "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

struct Case {
  const char* name;
  std::string bytes;
  const char* expected;
};

std::string binary_stl(std::uint32_t announced, std::uint32_t written, float special) {
  std::string bytes(80, 'x');
  bytes.append(reinterpret_cast<const char*>(&announced), 4);
  for (std::uint32_t i = 0; i < written; ++i) {
    const auto base = static_cast<float>(10 * i);
    const float facet[12] = {0, 0, 0, base, 0, 0, base + 1, 0, 0, base, special, 0};
    bytes.append(reinterpret_cast<const char*>(facet), sizeof facet);
    bytes.append(2, '\0');
  }
  return bytes;
}

std::string ply(const std::string& elements, const std::string& data) {
  return "ply\nformat ascii 1.0\n" + elements + "end_header\n" + data;
}
const std::string kXyz = "property float x\nproperty float y\nproperty float z\n";
const std::string kList = "property list uchar int vertex_indices\n";

const std::string kStl =
    "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
    "endfacet\n";

const Case kCases[] = {
    {"empty.off", "", "file: is empty"},
    {"no_vertices.off", "3 1 0\n", "vertex 0: is missing, the file ends before it"},
    {"binary.off", "OFF BINARY\n", "header: the file ends before or in it"},
    {"counts.off", "OFF\n3 x 0\n", "header (line 2): has a bad count"},
    {"huge.off", "OFF\n4000000000 4000000000 0\n0 0 0\n", "more than the file holds"},
    {"cut.off", "OFF\n4 4 0\n" + kTetrahedron + "3 0 2 1\n3 0 1 3\n", "face 2: is missing"},
    {"nan.off", "OFF # c\n4 4 0\n\n0 0 0\n1 0 0\n0 nan 0\n0 0 1\n" + kTetrahedronFaces,
     "vertex 2 (line 6): its coordinate y is not a number"},
    {"huge_number.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1e999 0\n0 0 1\n" + kTetrahedronFaces,
     "vertex 2 (line 5): its coordinate y is not finite"},
    {"word.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1x 0\n0 0 1\n" + kTetrahedronFaces,
     "vertex 2 (line 5): coordinate '1x' is not a number"},
    {"range.off", "OFF\n4 1 0\n" + kTetrahedron + "3 0 1 4\n",
     "face 0 (line 7): vertex 4 does not"},
    {"negative.off", "OFF\n4 1 0\n" + kTetrahedron + "3 0 1 -1\n", "vertex -1 does not exist"},
    {"repeat.off", "OFF\n4 1 0\n" + kTetrahedron + "3 0 1 1\n", "faces: all have repeated corners"},
    {"collinear.off", "OFF\n3 1 0\n0 0 0\n1 1 1\n2 2 2\n3 0 1 2\n", "face 0: its area is exactly"},
    {"edge.off", "OFF\n5 3 0\n" + kTetrahedron + "0 -1 0\n3 0 1 2\n3 1 0 3\n3 0 1 4\n",
     "edge 0-1: is in faces 0, 1 and 2"},
    // Vertex 0 is unreferenced: the number in the message is still the file's.
    {"unused.off",
     "OFF\n6 3 0\n9 9 9\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 1 1\n3 1 2 3\n3 2 1 4\n3 1 2 5\n",
     "edge 1-2: is in faces 0, 1 and 2"},
    {"no_faces.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n", "faces: there are none"},
    {"zero.off", std::string("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n") + '\0' + "9",
     "byte 36: is zero"},
    {"vertex.obj", "v 0 0\n", "vertex 0 (line 1): has 2 coordinates"},
    {"nan.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n",
     "vertex 1 (line 2): its coordinate x is not a number"},
    {"index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 0\n",
     "face 0 (line 4): index 0 does not exist"},
    {"range.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n",
     "face 0 (line 4): index 4 is out of range"},
    {"past.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -4\n",
     "face 0 (line 4): index -4 is out of range"},
    {"words.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf one 2 3\n", "index 'one' is not an integer"},
    {"no_faces.obj", "hello world\n", "faces: there are none"},
    {"header.ply", "plx\n", "header (line 1): does not start with 'ply'"},
    {"end.ply", "ply\nformat ascii 1.0\n", "header: has no 'end_header'"},
    {"type.ply", ply("element vertex 1\nproperty half x\n", ""), "line 4): unknown type 'half'"},
    {"xyz.ply", ply("element vertex 1\nproperty int x\nelement face 1\n" + kList, "1\n"),
     "vertices have no number 'y'"},
    {"list.ply",
     ply("element vertex 3\n" + kXyz +
             "element face 1\nproperty list uchar float "
             "vertex_indices\n",
         "0 0 0 1 0 0 0 1 0\n3 0 1 2\n"),
     "faces have no list of integers"},
    {"huge.ply", ply("element vertex 99999999999\n" + kXyz + "element face 1\n" + kList, "0 0 0\n"),
     "more than the file holds"},
    {"long.ply",
     ply("element vertex 1\n" + kXyz +
             "element face 1\nproperty list uint int "
             "vertex_indices\n",
         "0 0 0\n4000000000 0 0 0\n"),
     "face 0 (line 12): the file ends before or in it"},
    {"other.ply",
     ply("element a 1\nproperty list uint int b\nelement vertex 3\n" + kXyz + "element face 1\n" +
             kList,
         "4000000000 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15\n"),
     "a 0 (line 13): the file ends"},
    {"nan.ply",
     ply("element vertex 3\n" + kXyz + "element face 1\n" + kList,
         "0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n"),
     "vertex 1 (line 11): its coordinate y is not a number"},
    {"range.ply",
     ply("element vertex 3\n" + kXyz + "element face 1\n" + kList,
         "0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n"),
     "face 0 (line 13): vertex -1"},
    {"cut.ply",
     ply("element vertex 3\n" + kXyz + "element face 1\n" + kList, "0 0 0\n1 0 0\n0 1 0\n3 0 1\n"),
     "the file ends before or in it"},
    {"short.stl", "abc", "file: is too short for STL"},
    {"cut.stl", binary_stl(3, 2, 1), "face 2: is missing or cut, the header announces 3 faces"},
    {"nan.stl", binary_stl(2, 2, std::nanf("")),
     "face 0: a coordinate of its corner 2 is not finite"},
    {"text_cut.stl", kStl.substr(0, 70), "face 0 (line 6): the file ends in it"},
    {"text_nan.stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 nan\n",
     "face 0 (line 4): a coordinate of its corner 0 is not finite"},
    {"text_two.stl", "solid\nfacet\nvertex 0 0 0\nvertex 1 0 0\nendfacet\nendsolid\n",
     "faces: all have repeated corners"},
    {"garbage.vtp", "this is no XML", "file: cannot be read as VTP"},
    {"huge.vtp", "<VTKFile type=\"PolyData\"><PolyData><Piece NumberOfPoints=\"99999999999\"",
     "header: NumberOfPoints is 99999999999, more than the file holds"},
    {"thing.xyz", "1 2 3", "file: has the unknown extension '.xyz'"},
    {"thing", "1 2 3", "file: has no extension"},
    // Another format than the name says, or none.
    {"ply.obj", ply("element vertex 1\n" + kXyz, "0 0 0\n"), "file: holds PLY; name it .ply"},
    {"off.stl", "OFF\n4 4 0\n" + kTetrahedron + kTetrahedronFaces, "holds OFF; name it .off"},
    {"off.obj", "OFF\n4 4 0\n" + kTetrahedron + kTetrahedronFaces, "holds OFF; name it .off"},
    {"stl.off", kStl + "endsolid\n", "file: holds STL; name it .stl"},
    {"binary_stl.off", binary_stl(2, 2, 0), "file: holds binary STL; name it .stl"},
    {"vtk.vtp", "# vtk DataFile Version 3.0\n", "file: holds legacy VTK; name it .vtk"},
    {"vtp.vtk", "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\">", "name it .vtp"},
    {"vtu.vtp", "<VTKFile type=\"UnstructuredGrid\">", "name it .vtu"},
    {"msh.vtk", "$MeshFormat\n2.2 0 8\n", "file: holds a Gmsh mesh; name it .msh"},
    {"gzip.ply", "\x1f\x8b\x08 and so on", "file: is compressed by gzip; unpack it"},
    {"archive.stl", std::string("PK\x03\x04") + std::string(200, '\0'), "is a ZIP archive; unpack"},
    {"wide.off", std::string("\xff\xfeO\0F\0F\0\n\0", 10), "is a text in UTF-16; save it as UTF-8"},
    {"bytes.off", "\x80\xc3\xa4\xc3(\xf5\n", "header (line 1): '?\xc3\xa4?(?' is not read"},
    // What ends early is truncated, whatever the place.
    {"cut.obj", "v 0 0 0\nv 1 0", "vertex 1 (line 2): the file ends in it; the file is truncated"},
    {"cut_vertex.off", "OFF\n3 1 0\n0 0 0\n1", "vertex 1 (line 4): the file ends in it"},
    {"cut_face.off", "OFF\n4 4 0\n" + kTetrahedron + "3 0 2",
     "face 0 (line 7): the file ends in it"},
    {"cut.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n2\n1 0 0",
     "$Nodes: ends early (line 6); the file is truncated"},
    {"short.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n2\n1 0 0\n2 1 1 1\n$EndNodes\n",
     "line 6: has too few numbers"},
    {"solid.stl", "solid" + binary_stl(3, 2, 0).substr(5),
     "face 2: is missing or cut, the header announces 3 faces; the file is truncated"},
    {"zero.stl", std::string("solid a\nfacet\0normal", 20) + std::string(99, ' '),
     "byte 13: is zero in a text format"},
    {"comma.obj", "v 0 0,5 0\n", "'0,5' is not a number; write numbers with a point, not a comma"},
};

}  // namespace

TEST_CASE("each fault gives one line naming file, element and remedy", "[io]") {
  const TemporaryFolder folder;
  for (const Case& c : kCases) {
    const std::string path = folder / c.name;
    write_text(path, c.bytes);
    const std::string line = error_of(path);
    INFO(c.name << " -> " << line);
    CHECK(line.starts_with(path + ": "));
    CHECK(line.find(c.expected) != std::string::npos);
    CHECK(line.find("; ") != std::string::npos);
    CHECK(line.find('\n') == std::string::npos);
  }
  CHECK(error_of(folder / "absent.off").find("file: does not exist; ") != std::string::npos);
  CHECK(error_of(folder / "").find("file: ") != std::string::npos);
}

TEST_CASE("a file's name with a line break still gives one line", "[io]") {
  const TemporaryFolder folder;
  const std::string line = error_of(folder / "a\nb.off");
  CHECK(line.find('\n') == std::string::npos);
}

TEST_CASE("zeros behind a text are passed over", "[io]") {
  const TemporaryFolder folder;
  const std::string zeros(3, '\0'), off = "OFF\n4 4 0\n" + kTetrahedron + kTetrahedronFaces;
  const std::string faces = "element vertex 3\n" + kXyz + "element face 1\n" + kList;
  const std::pair<const char*, std::string> files[] = {
      {"a.off", off + zeros},
      {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n" + zeros},
      {"a.ply", ply(faces, "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n") + zeros},
      {"a.stl", kStl + "endsolid" + zeros},
      {"a.vtk",
       "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\n"
       "POLYGONS 1 4\n3 0 1 2\n" +
           zeros}};
  for (const auto& [name, bytes] : files) {
    write_text(folder / name, bytes);
    INFO(name << ": " << error_of(folder / name));
    CHECK(error_of(folder / name) == "no error");
  }
}

TEST_CASE("what only looks bad is read", "[io]") {
  const TemporaryFolder folder;
  write_text(folder / "tabs.obj",
             "# c\r\nv\t0 0 0\r\nv 1 0 0\nv 0 1 0 1\nl 1 2\nv 0 0 +1e-400\nv 1 1 \\\n1\n" +
                 std::string("f 1 2\t3\r\nf 1//7 3//7 -1/2/3 # comment\n"));
  const auto obj = read_mesh(folder / "tabs.obj");
  CHECK(obj.mesh.face_count() == 2);
  CHECK(obj.mesh.vertex_count() == 4);
  CHECK(obj.warnings ==
        std::vector<std::string>{"left out 1 line", "left out 1 vertex that no face uses"});

  write_text(folder / "colours.off",
             "STCNOFF 3 1 0\n0 0 0 0 0 1 255 0 0 0.5 0.5\n1 0 0\n0 1 0\n3 0 1 2 9 9\n");
  CHECK(read_mesh(folder / "colours.off").mesh.face_count() == 1);

  write_text(folder / "NAMED.STL",
             "  solid facet solid vertex\n" + kStl.substr(8) + "endsolid solid\n");
  CHECK(read_mesh(folder / "NAMED.STL").mesh.face_count() == 1);

  std::string solid = binary_stl(2, 2, 1);
  solid.replace(0, 6, "solid ");
  write_text(folder / "solid.stl", solid);
  CHECK(read_mesh(folder / "solid.stl").mesh.face_count() == 2);
}

TEST_CASE("the minority of each component is flipped, a tie keeps the first face", "[io]") {
  const TemporaryFolder folder;
  write_text(folder / "tetrahedron.off",
             "OFF\n4 4 0\n" + kTetrahedron + "3 0 1 2\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
  const auto one = read_mesh(folder / "tetrahedron.off");
  REQUIRE(one.warnings.size() == 1);
  CHECK(one.warnings[0] == "flipped 1 face oriented against the majority of their component");
  CHECK(one.mesh.faces()[1] == crest::kernel::Triangle{0, 1, 3});
  CHECK(one.mesh.faces()[0] == crest::kernel::Triangle{0, 2, 1});
  write_text(folder / "tie.off", "OFF\n4 2 0\n" + kTetrahedron + "3 0 1 2\n3 0 1 3\n");
  const auto tie = read_mesh(folder / "tie.off");
  CHECK(tie.mesh.faces()[0] == crest::kernel::Triangle{0, 1, 2});
  CHECK(tie.mesh.faces()[1] == crest::kernel::Triangle{0, 3, 1});
}
