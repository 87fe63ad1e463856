// SPDX-License-Identifier: GPL-3.0-or-later
// Files with curvatures and normals, read back.
#include <vtkCell.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <bit>
#include <catch2/catch.hpp>

#include "io/curvature/curvature_picture.hpp"
#include "io/curvature/curvature_writer.hpp"
#include "io/read/mesh_reader.hpp"
#include "io/write/formats.hpp"
#include "kernel/geometry/input_error.hpp"
#include "tests/curvature/shapes.hpp"
#include "tests/support/program.hpp"

using namespace crest::curvature;
using crest::kernel::InputError;
using crest::tests::read_text;
using crest::tests::TemporaryFolder;
using crest::tests::torus;
using crest::tests::write_text;

namespace {

/// A binary PLY of one triangle with double positions and float normals behind an extra byte.
std::string binary_ply(bool big_endian, const std::vector<Vec3>& normals) {
  std::string bytes = "ply\nformat ";
  bytes += big_endian ? "binary_big_endian" : "binary_little_endian";
  bytes +=
      " 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n"
      "property uchar flag\nproperty float nx\nproperty float ny\nproperty float nz\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  const auto put = [&](std::uint64_t bits, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) {
      const std::size_t shift = 8 * (big_endian ? size - 1 - i : i);
      bytes += static_cast<char>(bits >> shift & 0xff);
    }
  };
  const Vec3 points[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  for (std::size_t v = 0; v < 3; ++v) {
    for (const double x : points[v]) put(std::bit_cast<std::uint64_t>(x), 8);
    put(7, 1);
    for (const double x : normals[v]) put(std::bit_cast<std::uint32_t>(static_cast<float>(x)), 4);
  }
  put(3, 1);
  for (const std::uint64_t v : {0, 1, 2}) put(v, 4);
  return bytes;
}

std::vector<Vec3> normals_of(const std::string& path) {
  crest::io::MeshRequest request;
  request.normals = true;
  return crest::io::read_mesh(path, request).normals;
}

}  // namespace

TEST_CASE("curvature files read back as the mesh and its normals, to the last bit") {
  const TemporaryFolder folder;
  const auto shape = torus(10, 3);
  Options o;
  o.method = Method::np;
  o.normals = shape.normals;
  const Result r = estimate(shape.mesh, o);
  const auto corners = corner_curvatures(shape.mesh, r.normals);
  for (const char* name : {"t.vtp", "t.ply"}) {
    const std::string path = (folder / name).string();
    crest::io::write_curvature(path, shape.mesh, r, corners);
    INFO(name);
    const auto back = crest::io::read_mesh(path);
    CHECK(back.mesh.points() == shape.mesh.points());
    CHECK(back.mesh.faces() == shape.mesh.faces());
    CHECK(normals_of(path) == shape.normals);
    const std::string once = read_text(path);
    // The file's arrays are made when it comes to them, another program's all at once.
    if (path.ends_with(".vtp"))
      CHECK(once == crest::io::vtp_bytes(*crest::io::curvature_poly_data(shape.mesh, r, corners)));
    crest::io::write_curvature(path, shape.mesh, r, corners);
    CHECK(read_text(path) == once);
  }
  const std::string vtu = (folder / "t.vtu").string();
  crest::io::write_curvature(vtu, shape.mesh, r, corners);
  CHECK(read_text(vtu).find("\"corner_asymmetry\"") != std::string::npos);
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(vtu.c_str());
  reader->Update();
  vtkUnstructuredGrid& grid = *reader->GetOutput();
  REQUIRE(grid.GetNumberOfCells() == static_cast<vtkIdType>(shape.mesh.face_count()));
  for (crest::kernel::Index f = 0; f < shape.mesh.face_count(); ++f)
    for (int k = 0; k < 3; ++k)
      REQUIRE(grid.GetCell(f)->GetPointId(k) == shape.mesh.faces()[f][static_cast<std::size_t>(k)]);
  CHECK_THROWS_AS(crest::io::write_curvature((folder / "t.off").string(), shape.mesh, r, corners),
                  InputError);
}

TEST_CASE("normals of binary PLY files in both byte orders") {
  const TemporaryFolder folder;
  const std::vector<Vec3> normals = {{0, 0, 1}, {0.5, 0.25, 2}, {-0.125, 0, 1}};
  for (const bool big : {false, true}) {
    const std::string path = (folder / "b.ply").string();
    write_text(path, binary_ply(big, normals));
    CHECK(crest::io::read_mesh(path).mesh.face_count() == 1);
    CHECK(normals_of(path) == normals);
    const std::string whole = read_text(path);
    write_text(path, whole.substr(0, whole.size() - 40));
    CHECK_THROWS_AS(normals_of(path), InputError);
  }
  write_text(folder / "b.off", "OFF\n");
  CHECK_THROWS_AS(normals_of((folder / "b.off").string()), InputError);
  CHECK_THROWS_AS(normals_of((folder / "missing.ply").string()), InputError);
  CHECK_THROWS_AS(normals_of((folder / "missing.vtp").string()), InputError);
}

TEST_CASE("pictures of focal surfaces: green for positive, red for negative") {
  const TemporaryFolder folder;
  const auto shape = torus(16, 0);
  crest::io::ColourPicture options;
  options.width = 160;
  options.label = "mean curvature";
  std::vector<std::string> pictures;
  for (const double sign : {1.0, -1.0}) {
    FocalSurface s = focal_of_triangles(shape.mesh, shape.normals, Quantity::mean, 0.1, 2);
    for (double& x : s.values) x *= sign;
    const std::string path = (folder / "f.png").string();
    crest::io::write_focal_picture(path, shape.mesh, s, options);
    pictures.push_back(read_text(path));
    crest::io::write_focal((folder / "f.vtp").string(), {s, s});
    CHECK(read_text(folder / "f.vtp").find("\"quantity\"") != std::string::npos);
  }
  CHECK(pictures[0].substr(1, 3) == "PNG");
  CHECK(pictures[0] != pictures[1]);
  CHECK_THROWS_AS(crest::io::write_focal((folder / "f.ply").string(), {}), InputError);
}

TEST_CASE("pictures show the sign of a curvature") {
  const TemporaryFolder folder;
  const auto shape = torus(24, 0);
  std::vector<double> outer, inner;
  for (const auto& c : shape.exact) outer.push_back(c.K);
  for (const auto& c : shape.exact) inner.push_back(-c.K);
  const std::string a = (folder / "a.png").string(), b = (folder / "b.png").string();
  crest::io::ColourPicture options;
  options.width = 200;
  options.label = "gaussian curvature";
  crest::io::write_colour_picture(a, shape.mesh, outer, options);
  crest::io::write_colour_picture(b, shape.mesh, inner, options);
  CHECK(read_text(a).substr(1, 3) == "PNG");
  CHECK(read_text(a) != read_text(b));
  const std::string once = read_text(a);
  crest::io::write_colour_picture(a, shape.mesh, outer, options);
  CHECK(read_text(a) == once);
  CHECK_THROWS_AS(
      crest::io::write_colour_picture((folder / "a.pdf").string(), shape.mesh, outer, options),
      InputError);
}
