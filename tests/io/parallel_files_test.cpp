// SPDX-License-Identifier: GPL-3.0-or-later
// VTK's parallel files, .pvtp .pvtu .pvti: the pieces as one.
#include <fmt/format.h>
#include <vtkCellData.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLImageDataWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <catch2/catch.hpp>

#include "io/read/mesh_reader.hpp"
#include "io/read/tet_reader.hpp"
#include "io/read/volume_boxes.hpp"
#include "io/write/formats.hpp"
#include "io/write/poly_data.hpp"
#include "io/write/vtk_pieces.hpp"
#include "kernel/geometry/input_error.hpp"
#include "tests/support/closed_surfaces.hpp"
#include "tests/support/temporary_folder.hpp"

namespace {

using namespace crest;
using namespace crest::tests;
using Box = std::array<int, 6>;

std::string reading_error(const std::function<void()>& read) {
  try {
    read();
  } catch (const kernel::InputError& error) {
    return error.what();
  }
  return "none";
}

/// Tetrahedra of a row of prisms, numbers first .. last - 1 of nine; tensors by place.
void write_tets(const std::string& path, int first, int last, int ghosts_before, int seam = -1) {
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> tensors;
  tensors->SetName("stress");
  tensors->SetNumberOfComponents(6);
  for (int x = first; x <= last; ++x)
    for (const auto& [y, z] : {std::pair(0, 0), std::pair(1, 0), std::pair(0, 1)}) {
      points->InsertNextPoint(x, y, z);
      const double tensor[6] = {1.0 + x, 2.0 - y, 3.0 * z, 0.5 * x, 0.25, -1};
      tensors->InsertNextTuple(tensor);
    }
  if (seam >= 0) {  // a second point where there is one
    points->InsertNextPoint(seam, 0, 0);
    tensors->InsertNextTuple(tensors->GetTuple(0));
  }
  grid->SetPoints(points);
  grid->GetPointData()->AddArray(tensors);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName("vtkGhostType");
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("number");
  for (int x = first; x < last; ++x)
    for (int k = 0; k < 3; ++k) {
      const vtkIdType v = 3 * (x - first) + k;
      const vtkIdType tet[4] = {v, v + 1, v + 2, v + 3};
      grid->InsertNextCell(VTK_TETRA, 4, tet);
      ghosts->InsertNextValue(x < first + ghosts_before ? 1 : 0);
      numbers->InsertNextValue(3 * x + k);
    }
  if (ghosts_before > 0) grid->GetCellData()->AddArray(ghosts);
  grid->GetCellData()->AddArray(numbers);
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(grid);
  REQUIRE(writer->Write() == 1);
}

std::string index_of(const char* type, const std::string& attributes,
                     const std::vector<std::string>& pieces) {
  std::string text =
      fmt::format("<?xml version=\"1.0\"?>\n<VTKFile type=\"{0}\" version=\"0.1\">\n<{0} {1}>\n",
                  type, attributes);
  for (const std::string& piece : pieces) text += fmt::format("<Piece {}/>\n", piece);
  return text + fmt::format("</{0}>\n</VTKFile>\n", type);
}

float sample_at(int x, int y, int z) {
  return static_cast<float>(x) + 100.0F * static_cast<float>(y) + 0.5F * static_cast<float>(z * z);
}

void write_image(const std::string& path, Box extent, double spacing = 0.1, int type = 0) {
  vtkNew<vtkImageData> image;
  image->SetExtent(extent.data());
  image->SetOrigin(1.5, -2, 0.3);
  image->SetSpacing(spacing, 0.7, 1.0 / 3);
  image->SetDirectionMatrix(0, 1, 0, -1, 0, 0, 0, 0, 1);
  image->AllocateScalars(type == 0 ? VTK_FLOAT : VTK_SHORT, 1);
  image->GetPointData()->GetScalars()->SetName("density");
  for (int z = extent[4]; z <= extent[5]; ++z)
    for (int y = extent[2]; y <= extent[3]; ++y)
      for (int x = extent[0]; x <= extent[1]; ++x)
        image->SetScalarComponentFromDouble(x, y, z, 0, sample_at(x, y, z));
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(image);
  REQUIRE(writer->Write() == 1);
}

std::string image_piece(const std::string& name, const Box& e) {
  return fmt::format("Extent=\"{} {} {} {} {} {}\" Source=\"{}\"", e[0], e[1], e[2], e[3], e[4],
                     e[5], name);
}

}  // namespace

TEST_CASE("a mesh in pieces is the mesh: what crest wrote, read again") {
  const TemporaryFolder folder;
  const sampling::PlainSurface surface = torus_surface(24, 12);
  const kernel::TriangleMesh mesh(surface.points, surface.triangles);
  io::PolyData data;
  for (const kernel::Vec3& p : mesh.points()) {
    data.add_point(p);
    data.point_rows().add("height", p[2]);
  }
  for (const auto& f : mesh.faces())
    data.add_triangle(f[0], f[1], f[2]).add("number", static_cast<int>(f[0]));
  io::write_pvtp(folder / "t.pvtp", *data.data(), 50);
  const io::MeshFile file = io::read_mesh(folder / "t.pvtp", {.field = "height"});
  CHECK(file.mesh.vertex_count() == mesh.vertex_count());
  REQUIRE(file.mesh.face_count() == mesh.face_count());
  CHECK(file.mesh.closed());
  CHECK(file.warnings.empty());
  for (kernel::Index f = 0; f < mesh.face_count(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const kernel::Index v = file.mesh.faces()[f][k];
      CHECK(file.mesh.points()[v] == mesh.points()[mesh.faces()[f][k]]);
      CHECK(file.values[v] == file.mesh.points()[v][2]);
    }
}

TEST_CASE("a solid in pieces is the solid, without the ghost cells") {
  const TemporaryFolder folder;
  write_tets(folder / "one.vtu", 0, 9, 0);
  const io::TensorFile one = io::read_tensors(folder / "one.vtu", {});
  for (const int ghosts : {0, 2}) {
    write_tets(folder / "a.vtu", 0, 4, 0);
    write_tets(folder / "b.vtu", 4 - ghosts, 9, ghosts);
    write_text(folder / "all.pvtu", index_of("PUnstructuredGrid", "GhostLevel=\"0\"",
                                             {"Source=\"a.vtu\"", "Source=\"b.vtu\""}));
    const io::TensorFile all = io::read_tensors(folder / "all.pvtu", {});
    CHECK(all.mesh.points() == one.mesh.points());
    CHECK(all.mesh.tets() == one.mesh.tets());
    CHECK(all.tensors == one.tensors);
    CHECK(all.warnings.size() == (ghosts > 0 ? 1 : 0));
  }
  // Alone, too, a piece has no ghost cells; its cells keep their numbers in the file.
  const io::TensorFile piece = io::read_tensors(folder / "b.vtu", {});
  CHECK(piece.mesh.tets().size() == 15);
  CHECK(piece.cell_of.front() == 6);
}

TEST_CASE("points that coincide within a piece stay apart, with a warning") {
  const TemporaryFolder folder;
  write_tets(folder / "a.vtu", 0, 4, 0, 4);
  write_tets(folder / "b.vtu", 4, 9, 0);
  write_text(folder / "all.pvtu",
             index_of("PUnstructuredGrid", "", {"Source=\"a.vtu\"", "Source=\"b.vtu\""}));
  const io::TensorFile all = io::read_tensors(folder / "all.pvtu", {});
  REQUIRE(!all.warnings.empty());
  CHECK(all.warnings[0].find("3 points of several pieces coincide") == 0);
}

TEST_CASE("a volume in pieces is the volume, as a whole and in boxes") {
  const TemporaryFolder folder;
  const Box whole = {-2, 7, 3, 9, 0, 5};
  write_image(folder / "one.vti", whole);
  const io::VolumeFile one = io::read_volume(folder / "one.vti", {});
  const std::vector<Box> parts = {{-2, 3, 3, 9, 0, 5}, {3, 7, 3, 6, 0, 5}, {2, 7, 6, 9, 0, 5}};
  std::vector<std::string> pieces;
  for (const Box& part : parts) {
    const std::string name = fmt::format("p{}.vti", pieces.size());
    write_image(folder / name, part);
    pieces.push_back(image_piece(name, part));
  }
  write_text(folder / "all.pvti", index_of("PImageData", "WholeExtent=\"-2 7 3 9 0 5\"", pieces));
  const io::VolumeFile all = io::read_volume(folder / "all.pvti", {});
  CHECK(all.grid.samples == one.grid.samples);
  CHECK(all.grid.size == one.grid.size);
  CHECK(all.grid.origin == one.grid.origin);
  CHECK(all.grid.spacing == one.grid.spacing);
  CHECK(all.grid.directions == one.grid.directions);
  const io::VolumeBoxes boxes(folder / "all.pvti", {}), known(folder / "one.vti", {});
  CHECK(boxes.frame().origin == known.frame().origin);
  for (const kernel::GridBox& box :
       {kernel::GridBox{{0, 0, 0}, {10, 7, 6}}, kernel::GridBox{{4, 2, 1}, {9, 5, 3}},
        kernel::GridBox{{5, 3, 0}, {6, 4, 6}}})
    CHECK(boxes.read(box) == known.read(box));
  // A box needs the pieces that it meets alone.
  std::filesystem::remove(folder / "p2.vti");
  CHECK(boxes.read({{0, 0, 0}, {3, 7, 6}}) == known.read({{0, 0, 0}, {3, 7, 6}}));
  CHECK(reading_error([&] {
          boxes.read({{0, 0, 0}, {10, 7, 6}});
        }).find("piece 2 ('p2.vti')") != std::string::npos);
}

TEST_CASE("parallel files that are wrong are refused, with the piece") {
  const TemporaryFolder folder;
  write_image(folder / "a.vti", {0, 4, 0, 4, 0, 4});
  write_image(folder / "b.vti", {4, 8, 0, 4, 0, 4});
  write_image(folder / "other.vti", {4, 8, 0, 4, 0, 4}, 0.2);
  write_image(folder / "short.vti", {4, 8, 0, 4, 0, 4}, 0.1, 1);
  const std::string a = image_piece("a.vti", {0, 4, 0, 4, 0, 4});
  const auto b = [](const std::string& name) { return image_piece(name, {4, 8, 0, 4, 0, 4}); };
  const std::string extent = "WholeExtent=\"0 8 0 4 0 4\"";
  const auto check = [&](const std::string& attributes, const std::vector<std::string>& pieces,
                         const std::string& words) {
    write_text(folder / "x.pvti", index_of("PImageData", attributes, pieces));
    const std::string error = reading_error([&] { io::read_volume(folder / "x.pvti", {}); });
    INFO(error);
    CHECK(error.find(words) != std::string::npos);
  };
  check(extent, {a, b("b.vti")}, "none");
  check(extent, {}, "names no pieces");
  check("", {a, b("b.vti")}, "no WholeExtent of six integers");
  check("WholeExtent=\"0 -1 0 4 0 4\"", {a}, "WholeExtent is empty");
  check("WholeExtent=\"0 2000000000 0 2000000000 0 2000000000\"", {a}, "too large");
  check("WholeExtent=\"0 900000000 0 900000000 0 900000000\"", {a}, "do not cover");
  check(extent, {a, "Source=\"b.vti\""}, "piece 1: has no Extent");
  check(extent, {a, a}, "piece 1: names 'a.vti' again");
  check(extent, {a, b("c.vti")}, "piece 1 ('c.vti'): samples: the file 'c.vti' that the header");
  check(extent, {a, b("x.pvti")}, "piece 1: names no .vti file");
  check(extent, {a}, "do not cover the whole extent");
  check(extent, {a, image_piece("b.vti", {3, 8, 0, 4, 0, 4})}, "is not that of the piece");
  check(extent, {a, image_piece("b.vti", {4, 9, 0, 4, 0, 4})}, "not within the whole");
  check(extent, {a, b("other.vti")}, "another origin, spacing or direction");
  check(extent, {a, b("short.vti")}, "another type");
  write_text(folder / "y.pvtu", index_of("PPolyData", "", {"Source=\"a.vtp\""}));
  CHECK(reading_error([&] { io::read_tensors(folder / "y.pvtu", {}); }).find("PUnstructuredGrid") !=
        std::string::npos);
  write_text(folder / "y.pvtp", index_of("PPolyData", "", {"Source=\"gone.vtp\""}));
  CHECK(reading_error([&] { io::read_mesh(folder / "y.pvtp"); }).find("piece 0 ('gone.vtp')") !=
        std::string::npos);
  write_text(folder / "y.pvtp", "<VTKFile");
  CHECK(reading_error([&] { io::read_mesh(folder / "y.pvtp"); }).find("is not XML of VTK") !=
        std::string::npos);
}
