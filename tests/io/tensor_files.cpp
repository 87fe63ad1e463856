// SPDX-License-Identifier: GPL-3.0-or-later
// Tensors on solids from every format: each file's answer is known.
#include <vtkMath.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "io/read/tet_reader.hpp"
#include "kernel/geometry/input_error.hpp"
#include "tests/support/shared_data.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace crest;
using namespace crest::tests;
using Six = std::array<double, 6>;

namespace {

void put(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}
io::TensorFile read(const TemporaryFolder& folder, const std::string& name, const std::string& text,
                    const io::TensorRequest& request = {}) {
  put(folder / name, text);
  return io::read_tensors(folder / name, request);
}
std::string error(const std::string& path, const io::TensorRequest& request = {}) {
  try {
    io::read_tensors(path, request);
  } catch (const kernel::InputError& e) {
    return e.what();
  }
  return "no error";
}

/// One tetrahedron, its tensors' six numbers counted on from 1.
const std::string kVtk =
    "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n"
    "0 0 0 1 0 0 0 1 0 0 0 1\nCELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\nPOINT_DATA 4\n";
const std::string kSixNumbers =
    "FIELD f 1\nt 6 4 double\n1 2 3 4 5 6\n7 8 9 10 11 12\n13 14 15 16 17 18\n19 20 21 22 23 24\n";

}  // namespace

TEST_CASE("six components are in VTK's order, as VTK itself expands them") {
  const TemporaryFolder folder;
  const auto file = read(folder, "a.vtk", kVtk + kSixNumbers);
  double tensor[9] = {1, 2, 3, 4, 5, 6};
  vtkMath::TensorFromSymmetricTensor(tensor);
  // xx yy zz xy yz xz of the rows of the matrix.
  CHECK(file.tensors[0] == Six{tensor[0], tensor[4], tensor[8], tensor[1], tensor[5], tensor[2]});
  const auto other = read(folder, "a.vtk", kVtk + kSixNumbers, {.order = "xx,xy,xz,yy,yz,zz"});
  CHECK(other.tensors[0] == Six{1, 4, 6, 2, 5, 3});
}

TEST_CASE("six components of a thin plate: no stress across its free side") {
  const auto path = shared_data("tensors/notch_stress_fixed.vtk");
  if (!path) return;
  const auto free_share = [&](const std::string& order) {
    const auto file = io::read_tensors(*path, {.order = order});
    std::size_t free = 0;
    for (const Six& t : file.tensors) {
      double size = 0;
      for (const double x : t) size = std::hypot(size, x);
      free += std::hypot(t[2], t[4], t[5]) < 0.1 * size ? 1 : 0;
    }
    return static_cast<double>(free) / static_cast<double>(file.tensors.size());
  };
  // The plate is thin along z.
  CHECK(free_share("") > 0.98);
  CHECK(free_share("zz yy xx xy yz xz") < 0.1);
  CHECK(free_share("xx zz yy xz yz xy") < 0.5);
}

TEST_CASE("medit: a mesh and the solution beside it") {
  const TemporaryFolder folder;
  const std::string mesh =
      "MeshVersionFormatted 2\nDimension\n3\n# four\nVertices\n4\n0 0 0 7\n1 0 0 7\n0 1 0 7\n"
      "0 0 1 7\nTriangles 1\n1 2 3 0\nCorners 1\n2\nTetrahedra\n1\n1 2 3 4 9\nEnd\n";
  put(folder / "a.mesh", mesh);
  CHECK(error(folder / "a.mesh").find("no array of points") != std::string::npos);
  // Medit's order: xx xy yy xz yz zz.
  put(folder / "a.sol",
      "MeshVersionFormatted 2\nDimension 3\nSolAtVertices\n4\n2 1 3\n"
      "0.5 1 2 3 4 5 6\n0.5 1 2 3 4 5 6\n0.5 1 2 3 4 5 6\n0.5 1 2 3 4 5 6\nEnd\n");
  const auto file = io::read_tensors(folder / "a.mesh", {});
  CHECK(file.field == "solution2");
  CHECK(file.tensors[3] == Six{1, 3, 6, 2, 5, 4});
  CHECK(file.cell_of == std::vector<std::int64_t>{1});
  CHECK(file.mesh.orientation(0) == 1);
  put(folder / "a.sol", "MeshVersionFormatted 2\nDimension 3\nSolAtVertices\n3\n1 3\n");
  CHECK(error(folder / "a.mesh").find("a.sol") != std::string::npos);
  for (const std::string bad :
       {"Vertices 4", "MeshVersionFormatted 2\nVertices\n99999999\n",
        "MeshVersionFormatted 2\nVertices\n1\n0 x 0 0\n", "MeshVersionFormatted 2\nDimension 2\n",
        "MeshVersionFormatted 2\nTetrahedra\n1\n1 2 3 4 0\n"}) {
    put(folder / "b.mesh", bad);
    CHECK(error(folder / "b.mesh").find("b.mesh") != std::string::npos);
  }
}

TEST_CASE("frd: solids and the tensors of the last step, or of the one asked for") {
  const TemporaryFolder folder;
  const auto values = [](const char* step, const char* numbers) {
    std::string text = std::string("  100CL  101 1.000000000           4                     0") +
                       step + "           1\n -4  STRESS      6    1\n";
    for (const char* c : {"SXX         1    4    1    1", "SYY         1    4    2    2",
                          "SZZ         1    4    3    3", "SXY         1    4    1    2",
                          "SYZ         1    4    2    3", "SZX         1    4    3    1"})
      text += std::string(" -5  ") + c + "\n";
    for (const char* node : {"         1", "         2", "         5", "         9"})
      text += std::string(" -1") + node + numbers + "\n";
    return text + " -3\n";
  };
  const std::string head =
      "    1C\n"
      "    2C                             4                                     1\n"
      " -1         1 0.00000E+00 0.00000E+00 0.00000E+00\n"
      " -1         2 1.00000E+00 0.00000E+00 0.00000E+00\n"
      " -1         5 0.00000E+00 1.00000E+00 0.00000E+00\n"
      " -1         9 0.00000E+00 0.00000E+00 1.00000E+00\n -3\n"
      "    3C                             1                                     1\n"
      " -1        77    3    0    1\n -2         1         2         5         9\n -3\n";
  const std::string text =
      head +
      values("    1", " 9.00000E+00 9.00000E+00 9.00000E+00 9.00000E+00 9.00000E+00 9.00000E+00") +
      values("    2", " 1.00000E+00-2.00000E+00 3.00000E+00-4.00000E+00 5.00000E+00-6.00000E+00") +
      " 9999\n";
  const auto file = read(folder, "a.frd", text);
  CHECK(file.field == "STRESS");
  CHECK(file.tensors[2] == Six{1, -2, 3, -4, 5, -6});
  CHECK(file.cell_of == std::vector<std::int64_t>{77});
  CHECK(read(folder, "a.frd", text, {.step = 1}).tensors[0] == Six{9, 9, 9, 9, 9, 9});
  CHECK(error(folder / "a.frd", {.step = 3}).find("its steps are 1, 2") != std::string::npos);
  for (std::size_t cut = 100; cut < text.size(); cut += 97) {
    put(folder / "b.frd", text.substr(0, cut));
    CHECK(error(folder / "b.frd").find("b.frd") != std::string::npos);
  }
}

TEST_CASE("nrrd: tensors with a mask, of six and of nine numbers") {
  const TemporaryFolder folder;
  const std::string sizes = "dimension: 4\nencoding: ascii\ntype: double\n";
  std::string samples;
  for (int v = 0; v < 8; ++v) samples += (v == 3 ? "0" : "1") + std::string(" 1 2 3 4 5 6\n");
  const auto masked = read(folder, "a.nrrd",
                           "NRRD0004\n" + sizes +
                               "sizes: 7 2 2 2\nspacings: nan 2 3 4\nkinds: "
                               "3D-masked-symmetric-matrix space space space\n\n" +
                               samples);
  CHECK(masked.tensors[0] == Six{1, 4, 6, 2, 5, 3});
  CHECK(masked.tensors[3] == Six{});
  CHECK(masked.mesh.points()[7] == kernel::Vec3{2, 3, 4});
  CHECK(masked.mesh.tets().size() == 6);
  for (kernel::Index t = 0; t < 6; ++t) CHECK(masked.mesh.orientation(t) == 1);
  CHECK(masked.warnings.size() == 1);
  std::string nine;
  for (int v = 0; v < 8; ++v) nine += "1 2 3 2 4 5 3 5 6\n";
  const auto whole =
      read(folder, "b.nrrd",
           "NRRD0004\n" + sizes +
               "sizes: 9 2 2 2\nspace dimension: 3\nspace directions: none (1,0,0) (0,0,1) "
               "(0,1,0)\nspace origin: (5,6,7)\n\n" +
               nine);
  CHECK(whole.tensors[7] == Six{1, 4, 6, 2, 5, 3});
  CHECK(whole.mesh.points()[2] == kernel::Vec3{5, 6, 8});
  CHECK(whole.mesh.orientation(0) == -1);  // as the file's axes are turned
  put(folder / "c.nrrd", "NRRD0004\n" + sizes + "sizes: 3 2 2 2\n\n1 2 3\n");
  CHECK(error(folder / "c.nrrd").find("c.nrrd") != std::string::npos);
}

TEST_CASE("other solids are split into tetrahedra of positive volume, turned numbering or not") {
  const TemporaryFolder folder;
  const std::string head =
      "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 8 double\n"
      "0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1\n";
  std::string fields = "POINT_DATA 8\nFIELD f 1\nt 6 8 double\n";
  for (int v = 0; v < 8; ++v) fields += "1 2 3 4 5 6\n";
  struct Case {
    const char* cells;
    std::size_t parts;
  };
  for (const Case& c : {Case{"CELLS 1 9\n8 0 1 2 3 4 5 6 7\nCELL_TYPES 1\n12\n", 6},
                        Case{"CELLS 1 9\n8 4 5 6 7 0 1 2 3\nCELL_TYPES 1\n12\n", 6},
                        Case{"CELLS 1 9\n8 0 1 3 2 4 5 7 6\nCELL_TYPES 1\n11\n", 6},
                        Case{"CELLS 1 7\n6 0 1 2 4 5 6\nCELL_TYPES 1\n13\n", 3},
                        Case{"CELLS 1 7\n6 4 5 6 0 1 2\nCELL_TYPES 1\n13\n", 3},
                        Case{"CELLS 1 6\n5 0 1 2 3 4\nCELL_TYPES 1\n14\n", 2}}) {
    INFO(c.cells);
    const auto file = read(folder, "a.vtk", head + c.cells + fields);
    CHECK(file.mesh.tets().size() == c.parts);
    for (kernel::Index t = 0; t < file.mesh.tets().size(); ++t)
      CHECK(file.mesh.orientation(t) == 1);
  }
}
