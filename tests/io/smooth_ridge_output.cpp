// SPDX-License-Identifier: GPL-3.0-or-later
// Results about smooth surfaces as files: read back with VTK or word by word, pictures by pixels.
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <sstream>

#include "io/read/mesh_reader.hpp"
#include "io/ridges/smooth_ridge_lines.hpp"
#include "io/ridges/smooth_ridge_picture.hpp"
#include "io/ridges/smooth_ridge_writer.hpp"
#include "kernel/geometry/input_error.hpp"
#include "tests/support/temporary_folder.hpp"

namespace {

using namespace crest::smooth_ridges;
using crest::io::PictureOptions;
using crest::kernel::InputError;
using crest::tests::read_text;
using crest::tests::TemporaryFolder;

constexpr RidgeType kNo = RidgeType::none, kE = RidgeType::elliptic, kH = RidgeType::hyperbolic,
                    kT = RidgeType::turning;

/// The square [-1, 1]^2 on z = 0 in 2 n^2 triangles, facing up; two are in a patch.
SmoothRidges square(Index n) {
  SmoothRidges r;
  for (Index i = 0; i <= n; ++i)
    for (Index j = 0; j <= n; ++j) r.points.push_back({2.0 * i / n - 1, 2.0 * j / n - 1, 0});
  const auto at = [&](Index i, Index j) { return i * (n + 1) + j; };
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < n; ++j) {
      r.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      r.faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  r.in_patch.assign(r.faces.size(), false);
  r.in_patch[0] = r.in_patch[1] = true;
  r.euler_characteristic = 1;
  r.components = r.boundary_loops = 1;
  r.certified = true;
  return r;
}

/// A blue path from an umbilic to the boundary with a turning point, a red loop of one type, a blue
/// loop of two.
SmoothRidges scene() {
  SmoothRidges r = square(8);
  r.umbilics = {{{-0.9, -0.9, 0}, 1, {1, 1}}, {{0.9, 0.9, 0}, -1, {3, 3}}};
  SmoothRidge path;
  path.colour = Colour::blue;
  path.ends = {0, kNone};
  path.points = {{-0.9, -0.9, 0}, {-0.7, -0.9, 0}, {-0.5, -0.9, 0}, {0, -0.9, 0}, {1, -0.9, 0}};
  path.types = {kNo, kH, kT, kE};
  SmoothRidge two;
  two.colour = Colour::blue;
  two.loop = true;
  two.points = {{-0.5, 0, 0}, {0, 0, 0}, {0, 0.5, 0}, {-0.5, 0.5, 0}};
  two.types = {kE, kH, kH, kE};
  SmoothRidge one;
  one.colour = Colour::red;
  one.loop = true;
  one.points = {{0.2, 0, 0}, {0.7, 0, 0}, {0.7, 0.5, 0}};
  one.types = {kE, kE, kE};
  r.ridges = {path, two, one};
  r.turning_points = {{{-0.25, -0.9, 0}, Colour::blue}};
  r.purple_points = {{{0.3, -0.5, 0}}};
  return r;
}

/// The same, not certified in one face.
SmoothRidges partial_scene() {
  SmoothRidges r = scene();
  r.certified = false;
  r.obstacles = {"1 of 128 cells are not certified"};
  const auto& f = r.faces[40];
  Vec3 middle;
  for (std::size_t k = 0; k < 3; ++k)
    middle[k] = (r.points[f[0]][k] + r.points[f[1]][k] + r.points[f[2]][k]) / 3;
  r.undecided = {{middle, 0.25, "no reason"}};
  return r;
}

vtkSmartPointer<vtkPolyData> read_vtp(const std::string& path) {
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

double value(vtkFieldData* data, const char* name, vtkIdType i) {
  auto* array = vtkDataArray::SafeDownCast(data->GetAbstractArray(name));
  INFO(name);
  REQUIRE(array != nullptr);
  REQUIRE(i < array->GetNumberOfTuples());
  return array->GetTuple1(i);
}

std::size_t lines_starting(const std::string& text, const std::string& start) {
  std::istringstream stream(text);
  std::size_t count = 0;
  for (std::string line; std::getline(stream, line);) count += line.starts_with(start) ? 1 : 0;
  return count;
}

SmoothRidge ridge_of(std::vector<RidgeType> types, bool loop) {
  SmoothRidge r;
  r.loop = loop;
  r.types = std::move(types);
  r.points.resize(r.types.size() + (loop ? 0 : 1));
  return r;
}

}  // namespace

TEST_CASE("types in patches follow from the faces beside them", "[io]") {
  using crest::io::drawn_types;
  const auto drawn = [](std::vector<RidgeType> t) { return drawn_types(ridge_of(t, false)); };
  CHECK(drawn({kNo, kE, kE, kNo}) == std::vector{kE, kE, kE, kE});
  CHECK(drawn({kNo, kT, kE}) == std::vector{kH, kT, kE});
  CHECK(drawn({kNo, kT, kT, kE}) == std::vector{kE, kT, kT, kE});
  CHECK(drawn({kE, kT, kNo}) == std::vector{kE, kT, kH});
  CHECK(drawn({kNo, kH, kT, kNo}) == std::vector{kH, kH, kT, kE});
  CHECK(drawn({kNo, kT, kNo}) == std::vector{kNo, kT, kNo});
  CHECK(drawn({}).empty());
}

TEST_CASE("runs cover every segment of a ridge once", "[io]") {
  using crest::io::runs_of;
  const auto one = runs_of(ridge_of({kE, kE, kE}, true));
  REQUIRE(one.size() == 1);
  CHECK(one[0].points == std::vector<std::size_t>{0, 1, 2, 0});
  const auto wrapped = runs_of(ridge_of({kE, kH, kH, kE}, true));
  REQUIRE(wrapped.size() == 2);
  CHECK(wrapped[0].type == kH);
  CHECK(wrapped[0].points == std::vector<std::size_t>{1, 2, 3});
  CHECK(wrapped[1].points == std::vector<std::size_t>{3, 0, 1});
  const auto path = runs_of(ridge_of({kNo, kE, kT, kNo}, false));
  REQUIRE(path.size() == 3);
  CHECK(path[0].points == std::vector<std::size_t>{0, 1, 2});
  CHECK(path[2].type == kH);
  CHECK(path[2].points == std::vector<std::size_t>{3, 4});
}

TEST_CASE("ends are open only where nothing holds them", "[io]") {
  SmoothRidges r = scene();
  CHECK(crest::io::open_ends(r) == 0);
  CHECK(crest::io::end_kind(r, r.ridges[0], 0) == 1);
  CHECK(crest::io::end_kind(r, r.ridges[0], 1) == 2);
  r.boundary_loops = 0;
  CHECK(crest::io::open_ends(r) == 1);
}

TEST_CASE("smooth ridges read back from VTP with every array everywhere", "[io]") {
  const SmoothRidges r = scene();
  const TemporaryFolder folder;
  const std::string path = folder / "r.vtp";
  crest::io::write_smooth_ridges(path, r, "abc123");
  const auto data = read_vtp(path);
  REQUIRE(data->GetNumberOfVerts() == 4);
  REQUIRE(data->GetNumberOfLines() == 3 + 2 + 1);
  REQUIRE(data->GetNumberOfPoints() == 4 + 5 + 4 + 3);
  CHECK(data->GetPointData()->GetNumberOfArrays() == 8);
  CHECK(data->GetCellData()->GetNumberOfArrays() == 16);
  for (int i = 0; i < 8; ++i)
    CHECK(data->GetPointData()->GetAbstractArray(i)->GetNumberOfTuples() == 16);
  for (int i = 0; i < 16; ++i)
    CHECK(data->GetCellData()->GetAbstractArray(i)->GetNumberOfTuples() == 10);
  vtkFieldData *points = data->GetPointData(), *cells = data->GetCellData();
  const double kinds[] = {1, 3, 4, 5, -1, -1, -1, -1, -1, -1};
  const double colours[] = {-1, -1, 0, -1, 0, 0, 0, 0, 0, 1};
  const double types[] = {-1, -1, -1, -1, 2, 3, 1, 2, 1, 1};
  const double ridges[] = {-1, -1, -1, -1, 0, 0, 0, 1, 1, 2};
  for (vtkIdType i = 0; i < 10; ++i) {
    INFO(i);
    CHECK(value(cells, "kind", i) == kinds[i]);
    CHECK(value(cells, "colour", i) == colours[i]);
    CHECK(value(cells, "type", i) == types[i]);
    CHECK(value(cells, "ridge", i) == ridges[i]);
  }
  CHECK(value(cells, "loop", 4) == 0);
  CHECK(value(cells, "loop", 9) == 1);
  CHECK(value(cells, "end_kind_0", 4) == 1);
  CHECK(value(cells, "end_umbilic_0", 4) == 0);
  CHECK(value(cells, "end_kind_1", 4) == 2);
  CHECK(value(cells, "end_umbilic_1", 4) == -1);
  CHECK(value(cells, "length", 6) == Approx(1));
  CHECK(value(cells, "umbilic", 1) == 1);
  CHECK(value(points, "index", 1) == -0.5);
  CHECK(value(points, "twice_index", 1) == -1);
  CHECK(value(points, "blue_branches", 1) == 3);
  CHECK(value(points, "red_branches", 0) == 1);
  CHECK(value(points, "type", 4) == 2);
  CHECK(value(points, "type", 8) == 1);
  vtkNew<vtkIdList> ids;
  data->GetCellPoints(9, ids);
  REQUIRE(ids->GetNumberOfIds() == 4);
  CHECK(ids->GetId(0) == ids->GetId(3));
  CHECK(value(data->GetFieldData(), "certified", 0) == 1);
  CHECK(value(data->GetFieldData(), "undecided", 0) == 0);
  auto* digest =
      vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray("data_digest"));
  REQUIRE(digest != nullptr);
  CHECK(digest->GetValue(0) == "abc123");
  const std::string bytes = read_text(path);
  crest::io::write_smooth_ridges(path, r, "abc123");
  CHECK(read_text(path) == bytes);
}

TEST_CASE("partial results are marked as such in every format", "[io]") {
  const SmoothRidges r = partial_scene();
  const TemporaryFolder folder;
  crest::io::write_smooth_ridges(folder / "r.vtp", r, "");
  const auto data = read_vtp(folder / "r.vtp");
  CHECK(value(data->GetFieldData(), "certified", 0) == 0);
  CHECK(value(data->GetFieldData(), "undecided", 0) == 1);
  REQUIRE(data->GetNumberOfVerts() == 5);
  CHECK(value(data->GetCellData(), "kind", 4) == 6);
  CHECK(value(data->GetCellData(), "size", 4) == 0.25);
  CHECK(value(data->GetCellData(), "end_kind_1", 5) == 0);
  for (const char* name : {"r.obj", "r.ply"}) {
    crest::io::write_smooth_ridges(folder / name, r, "");
    CHECK(read_text(folder / name).find("NOT CERTIFIED") != std::string::npos);
    crest::io::write_smooth_ridges(folder / name, scene(), "");
    CHECK(read_text(folder / name).find("NOT CERTIFIED") == std::string::npos);
  }
  crest::io::write_smooth_mesh(folder / "m.vtp", r, "");
  const auto mesh = read_vtp(folder / "m.vtp");
  CHECK(value(mesh->GetFieldData(), "certified", 0) == 0);
  for (vtkIdType f = 0; f < 128; ++f) {
    INFO(f);
    CHECK(value(mesh->GetCellData(), "undecided", f) == (f == 40 ? 1 : 0));
    CHECK(value(mesh->GetCellData(), "in_patch", f) == (f < 2 ? 1 : 0));
  }
}

TEST_CASE("smooth ridges are complete in OBJ and PLY", "[io]") {
  const SmoothRidges r = scene();
  const TemporaryFolder folder;
  crest::io::write_smooth_ridges(folder / "r.obj", r, "abc");
  const std::string obj = read_text(folder / "r.obj");
  CHECK(lines_starting(obj, "v ") == 16);
  CHECK(lines_starting(obj, "p ") == 4);
  CHECK(lines_starting(obj, "l ") == 3);
  CHECK(lines_starting(obj, "g ") == 5);
  CHECK(lines_starting(obj, "l 14 15 16 14") == 1);
  crest::io::write_smooth_ridges(folder / "r.ply", r, "abc");
  const std::string ply = read_text(folder / "r.ply");
  CHECK(lines_starting(ply, "element vertex 16") == 1);
  CHECK(lines_starting(ply, "element edge 11") == 1);
  const std::size_t header = lines_starting(ply.substr(0, ply.find("end_header")), "") + 1;
  CHECK(lines_starting(ply, "") == header + 16 + 11);
  CHECK_THROWS_AS(crest::io::write_smooth_ridges(folder / "r.xyz", r, ""), InputError);
  CHECK_THROWS_AS(crest::io::write_smooth_mesh(folder / "r.xyz", r, ""), InputError);
  CHECK(folder.entries() == 2);
}

TEST_CASE("the triangulation of a smooth surface is a mesh again", "[io]") {
  const SmoothRidges r = scene();
  const TemporaryFolder folder;
  for (const char* name : {"m.vtp", "m.off", "m.obj", "m.ply"}) {
    INFO(name);
    crest::io::write_smooth_mesh(folder / name, r, "");
    const auto file = crest::io::read_mesh(folder / name);
    CHECK(file.mesh.points() == r.points);
    CHECK(file.mesh.faces() == r.faces);
  }
}

TEST_CASE("a result without a surface is written, too", "[io]") {
  SmoothRidges nothing;
  nothing.obstacles = {"F has no zero in the box"};
  const TemporaryFolder folder;
  for (const char* name : {"r.vtp", "r.obj", "r.ply"})
    crest::io::write_smooth_ridges(folder / name, nothing, "");
  crest::io::write_smooth_mesh(folder / "m.vtp", nothing, "");
  crest::io::write_smooth_picture(folder / "p.png", nothing);
  crest::io::write_smooth_picture(folder / "p.svg", nothing);
  CHECK(folder.entries() == 6);
  CHECK(value(read_vtp(folder / "r.vtp")->GetFieldData(), "certified", 0) == 0);
  CHECK(read_text(folder / "p.svg").find("result not certified") != std::string::npos);
}

TEST_CASE("a picture of a smooth surface shows what faces the eye, each kind with its mark",
          "[io]") {
  const TemporaryFolder folder;
  PictureOptions options;
  options.width = 400;
  options.view = Vec3{0, 0, -1};
  crest::io::write_smooth_picture(folder / "p.svg", scene(), options);
  const std::string svg = read_text(folder / "p.svg");
  CHECK(svg.ends_with("</svg>\n"));
  const std::string drawn = svg.substr(0, svg.find("font-family"));
  // Blue elliptic, hyperbolic and turning, red elliptic; not red hyperbolic.
  for (const char* ink : {"#1c46de", "#169e3c", "#188ca0", "#da1a20"}) {
    INFO(ink);
    CHECK(drawn.find(std::string("stroke=\"") + ink) != std::string::npos);
  }
  CHECK(drawn.find("stroke=\"#fad014\"") == std::string::npos);
  CHECK(lines_starting(drawn, "<circle") == 1);       // +1/2
  CHECK(lines_starting(drawn, "<polygon") == 3 * 2);  // -1/2, turning, purple; each with its rim
  for (const char* label :
       {"umbilic +1/2, 1-ridge", "umbilic -1/2, 3-ridge", "blue turning point", "purple point"})
    CHECK(svg.find(label) != std::string::npos);
  CHECK(svg.find("not certified") == std::string::npos);
  crest::io::write_smooth_picture(folder / "q.svg", partial_scene(), options);
  const std::string partial = read_text(folder / "q.svg");
  CHECK(partial.find("result not certified") != std::string::npos);
  CHECK(partial.find("face not certified") != std::string::npos);
  options.view = Vec3{0, 0, 0};
  CHECK_THROWS_AS(crest::io::write_smooth_picture(folder / "a.png", scene(), options), InputError);
  CHECK_THROWS_AS(crest::io::write_smooth_picture(folder / "a.gif", scene(), {}), InputError);
}

TEST_CASE("marks are painted in pixels as in SVG, faces in doubt are tinted", "[io]") {
  const TemporaryFolder folder;
  PictureOptions options;
  options.width = 1000;
  options.view = Vec3{0, 0, -1};
  options.show_legend = false;
  struct Counts {
    int purple = 0, pink = 0, black = 0;
  };
  const auto count = [&](const SmoothRidges& r) {
    crest::io::write_smooth_picture(folder / "p.png", r, options);
    vtkNew<vtkPNGReader> reader;
    reader->SetFileName((folder / "p.png").c_str());
    reader->Update();
    const int* size = reader->GetOutput()->GetDimensions();
    const auto* p = static_cast<const unsigned char*>(reader->GetOutput()->GetScalarPointer());
    Counts c;
    for (int i = 0; i < size[0] * size[1]; ++i, p += 3) {
      c.purple += p[2] > 180 && p[1] < 110 && p[0] > 130 ? 1 : 0;
      c.pink += p[0] > p[1] + 40 && std::abs(p[1] - p[2]) < 8 && p[1] > 60 ? 1 : 0;
      c.black += p[0] + p[1] + p[2] < 12 ? 1 : 0;
    }
    return c;
  };
  SmoothRidges r = scene();
  r.ridges.clear();
  r.umbilics.clear();
  r.turning_points.clear();
  const Counts purple = count(r);
  CHECK(purple.purple > 20);
  CHECK(purple.pink == 0);
  r.purple_points.clear();
  CHECK(count(r).purple == 0);
  CHECK(count(r).black == 0);
  r.umbilics = {{{0.5, 0.5, 0}, -1, {3, 3}}};
  CHECK(count(r).black > 10);
  SmoothRidges doubt = partial_scene();
  doubt.ridges.clear();
  CHECK(count(doubt).pink > 100);
}
