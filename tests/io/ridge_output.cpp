// SPDX-License-Identifier: GPL-3.0-or-later
// Ridge files read back with VTK or word by word; pictures looked at pixel by pixel.
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <sstream>

#include "algorithms/ridges/ridges.hpp"
#include "io/ridges/ridge_picture.hpp"
#include "io/ridges/ridge_writer.hpp"
#include "kernel/geometry/input_error.hpp"
#include "tests/support/temporary_folder.hpp"

namespace {

using namespace crest::ridges;
using crest::io::PictureOptions;
using crest::kernel::Triangle;
using crest::kernel::TriangleMesh;
using crest::tests::read_text;
using crest::tests::TemporaryFolder;

/// A unit sphere of latitude rings around z.
TriangleMesh sphere(Index rings, Index around) {
  const auto angle = [](Index i, Index n) { return std::numbers::pi * i / n; };
  std::vector<Vec3> points = {{0, 0, 1}};
  for (Index r = 1; r < rings; ++r) {
    for (Index a = 0; a < around; ++a) {
      const double t = angle(r, rings), p = 2 * angle(a, around);
      points.push_back({std::sin(t) * std::cos(p), std::sin(t) * std::sin(p), std::cos(t)});
    }
  }
  points.push_back({0, 0, -1});
  const auto south = static_cast<Index>(points.size() - 1);
  const auto at = [&](Index r, Index a) { return 1 + (r - 1) * around + a % around; };
  std::vector<Triangle> faces;
  for (Index a = 0; a < around; ++a) {
    faces.push_back({0, at(1, a), at(1, a + 1)});
    for (Index r = 1; r + 1 < rings; ++r) {
      faces.push_back({at(r, a), at(r + 1, a), at(r + 1, a + 1)});
      faces.push_back({at(r, a), at(r + 1, a + 1), at(r, a + 1)});
    }
    faces.push_back({south, at(rings - 1, a + 1), at(rings - 1, a)});
  }
  return {points, faces};
}

/// The loop in which the plane z = level cuts the mesh.
Ridge latitude(const TriangleMesh& mesh, double level, Colour colour, RidgeType type) {
  Ridge ridge{};
  ridge.colour = colour;
  ridge.loop = true;
  std::vector<std::pair<double, Crossing>> sorted;
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Vec3 &p = mesh.points()[mesh.edges()[e].v0], &q = mesh.points()[mesh.edges()[e].v1];
    if ((p[2] < level) == (q[2] < level)) continue;
    const double w = (level - p[2]) / (q[2] - p[2]);
    const Vec3 at = {p[0] + w * (q[0] - p[0]), p[1] + w * (q[1] - p[1]), level};
    sorted.push_back({std::atan2(at[1], at[0]), {e, w, at, type, -1, -2, 0.25, 0.5}});
  }
  std::sort(sorted.begin(), sorted.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& item : sorted) ridge.crossings.push_back(item.second);
  ridge.third_order.assign(ridge.crossings.size(), type);
  ridge.strength = 3;
  ridge.sharpness = 4;
  ridge.length = 5;
  return ridge;
}

/// A blue loop in the north, a red path in the south that starts at an umbilic.
RidgeGraph two_ridges(const TriangleMesh& mesh) {
  RidgeGraph graph;
  graph.ridges.push_back(latitude(mesh, 0.55, Colour::blue, RidgeType::elliptic));
  Ridge path = latitude(mesh, -0.55, Colour::red, RidgeType::elliptic);
  path.loop = false;
  path.crossings.resize(7);
  path.crossings[3].type = RidgeType::hyperbolic;
  path.third_order.assign(6, RidgeType::hyperbolic);
  path.ends[0] = {EndKind::umbilic, 0};
  path.ends[1].kind = EndKind::cut;
  path.lead_in = {{0, 0, -1}, {-0.1, 0, -0.9}};
  path.weight = 2.5;
  path.crossings[2].significance = 7;
  path.crossings[2].crest_significance = 6;
  path.crossings[2].prominence = 0.5;
  path.crossings[2].level = 2;
  graph.ridges.push_back(path);
  const Index face = mesh.face_count() - 1;  // at the south pole
  graph.umbilics.push_back({face, {0, 0, -1}, -1, UmbilicKind::three_ridge, true, {face}, {3, 3}});
  graph.umbilics[0].level = 1;
  return graph;
}

FitResult flat_fit(const TriangleMesh& mesh) {
  FitResult fit;
  fit.forms.resize(mesh.vertex_count());
  for (auto& form : fit.forms) form.k1 = -1, form.k2 = -3;
  return fit;
}

std::size_t words_starting(const std::string& text, const std::string& start) {
  std::istringstream stream(text);
  std::size_t count = 0;
  for (std::string line; std::getline(stream, line);) count += line.starts_with(start) ? 1 : 0;
  return count;
}

double value(vtkFieldData* data, const char* name, vtkIdType i) {
  auto* array = vtkDataArray::SafeDownCast(data->GetAbstractArray(name));
  REQUIRE(array != nullptr);
  return array->GetTuple1(i);
}

/// Counts pixels by their strongest channel where the colour is strong.
struct Inks {
  int red = 0, blue = 0, grey = 0, width = 0, height = 0;
};
Inks inks(const std::string& path) {
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  const int* size = reader->GetOutput()->GetDimensions();
  Inks sum{0, 0, 0, size[0], size[1]};
  const auto* p = static_cast<const unsigned char*>(reader->GetOutput()->GetScalarPointer());
  for (int i = 0; i < size[0] * size[1]; ++i, p += 3) {
    sum.red += p[0] > p[2] + 100 ? 1 : 0;
    sum.blue += p[2] > p[0] + 100 ? 1 : 0;
    sum.grey += p[0] < 252 && std::abs(p[0] - p[2]) < 8 ? 1 : 0;
  }
  return sum;
}

}  // namespace

TEST_CASE("a ridge graph reads back from VTP with every array everywhere", "[io]") {
  const TriangleMesh mesh = sphere(16, 24);
  const RidgeGraph graph = two_ridges(mesh);
  const TemporaryFolder folder;
  const std::string path = folder / "r.vtp";
  crest::io::write_ridges(path, mesh, flat_fit(mesh), graph, "abc123");
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkPolyData* data = reader->GetOutput();
  const auto loop = static_cast<vtkIdType>(graph.ridges[0].crossings.size());
  REQUIRE(data->GetNumberOfPoints() == 1 + loop + 9);
  REQUIRE(data->GetNumberOfVerts() == 1);
  REQUIRE(data->GetNumberOfLines() == 2);
  REQUIRE(data->GetNumberOfCells() == 3);
  CHECK(data->GetPointData()->GetNumberOfArrays() == 17);
  CHECK(data->GetCellData()->GetNumberOfArrays() == 14);
  for (int i = 0; i < data->GetPointData()->GetNumberOfArrays(); ++i)
    CHECK(data->GetPointData()->GetAbstractArray(i)->GetNumberOfTuples() == 10 + loop);
  for (int i = 0; i < data->GetCellData()->GetNumberOfArrays(); ++i)
    CHECK(data->GetCellData()->GetAbstractArray(i)->GetNumberOfTuples() == 3);
  vtkNew<vtkIdList> ids;
  data->GetCellPoints(1, ids);
  CHECK(ids->GetNumberOfIds() == loop + 1);
  CHECK(ids->GetId(0) == ids->GetId(loop));
  data->GetCellPoints(2, ids);
  CHECK(ids->GetNumberOfIds() == 9);
  vtkFieldData *points = data->GetPointData(), *cells = data->GetCellData();
  CHECK(value(points, "k1", 0) == Approx(-1));
  CHECK(value(points, "k2", 0) == Approx(-3));
  CHECK(value(points, "index", 0) == -0.5);
  CHECK(value(points, "kind", 0) == 3);
  CHECK(value(points, "colour", 0) == -1);
  CHECK(value(points, "b", 1) == 0.25);
  CHECK(value(points, "P", 1) == 0.5);
  CHECK(value(points, "kind", 1) == -1);
  // Path: two lead-in points, then crossings; the fourth is hyperbolic between elliptic ones.
  const vtkIdType first = 1 + loop + 2;
  const double types[7] = {1, 1, 3, 3, 1, 1, 1};
  for (vtkIdType i = 0; i < 7; ++i) CHECK(value(points, "type", first + i) == types[i]);
  CHECK(value(points, "crossing_type", first + 3) == 2);
  CHECK(value(points, "crossing_type", first - 1) == -1);
  CHECK(value(points, "type_third_order", first) == 2);
  CHECK(value(cells, "loop", 1) == 1);
  CHECK(value(cells, "loop", 2) == 0);
  CHECK(value(cells, "colour", 2) == 1);
  CHECK(value(cells, "end_kind_0", 2) == 1);
  CHECK(value(cells, "end_umbilic_0", 2) == 0);
  CHECK(value(cells, "end_umbilic_1", 2) == -1);
  CHECK(value(cells, "strength", 2) == 3);
  CHECK(value(cells, "sharpness", 2) == 4);
  CHECK(value(cells, "length", 2) == 5);
  CHECK(value(cells, "weight", 2) == 2.5);
  CHECK(value(cells, "end_kind_1", 2) == 3);
  CHECK(value(points, "significance", first + 2) == 7);
  CHECK(value(points, "crest_significance", first + 2) == 6);
  CHECK(value(points, "prominence", first + 2) == 0.5);
  CHECK(value(points, "level", first + 2) == 2);
  CHECK(value(points, "level", first + 3) == 0);
  CHECK(value(points, "level", 0) == 1);
  auto* digest =
      vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray("data_digest"));
  REQUIRE(digest != nullptr);
  CHECK(digest->GetValue(0) == "abc123");
  double p[3];
  data->GetPoint(1, p);
  CHECK(p[0] == graph.ridges[0].crossings[0].point[0]);

  const std::string bytes = read_text(path);
  crest::io::write_ridges(path, mesh, flat_fit(mesh), graph, "abc123");
  CHECK(read_text(path) == bytes);
}

TEST_CASE("a ridge graph is complete in OBJ and PLY", "[io]") {
  const TriangleMesh mesh = sphere(16, 24);
  const RidgeGraph graph = two_ridges(mesh);
  const TemporaryFolder folder;
  const std::size_t loop = graph.ridges[0].crossings.size(), points = 1 + loop + 9;
  crest::io::write_ridges(folder / "r.obj", mesh, flat_fit(mesh), graph, "abc");
  const std::string obj = read_text(folder / "r.obj");
  CHECK(words_starting(obj, "v ") == points);
  CHECK(words_starting(obj, "p ") == 1);
  CHECK(words_starting(obj, "l ") == 2);
  CHECK(words_starting(obj, "g ") == 3);
  crest::io::write_ridges(folder / "r.ply", mesh, flat_fit(mesh), graph, "abc");
  const std::string ply = read_text(folder / "r.ply");
  CHECK(words_starting(ply, "element vertex " + std::to_string(points)) == 1);
  CHECK(words_starting(ply, "element edge " + std::to_string(loop + 8)) == 1);
  const std::size_t header = words_starting(ply.substr(0, ply.find("end_header")), "") + 1;
  CHECK(words_starting(ply, "") == header + points + loop + 8);
  CHECK_THROWS_AS(crest::io::write_ridges(folder / "r.xyz", mesh, flat_fit(mesh), graph, ""),
                  crest::kernel::InputError);
  CHECK(folder.entries() == 2);
}

TEST_CASE("a graph without ridges is written, too", "[io]") {
  const TriangleMesh mesh = sphere(4, 5);
  const TemporaryFolder folder;
  for (const char* name : {"r.vtp", "r.obj", "r.ply"})
    crest::io::write_ridges(folder / name, mesh, flat_fit(mesh), {}, "");
  crest::io::write_picture(folder / "r.png", mesh, {});
  crest::io::write_picture(folder / "r.svg", mesh, {});
  CHECK(folder.entries() == 5);
}

TEST_CASE("a picture shows what faces the eye and hides the rest", "[io]") {
  const TriangleMesh mesh = sphere(32, 48);
  const RidgeGraph graph = two_ridges(mesh);
  const TemporaryFolder folder;
  PictureOptions options;
  options.width = 300;
  options.show_legend = false;
  options.view = Vec3{0, 0, -1};
  crest::io::write_picture(folder / "north.png", mesh, graph, options);
  const Inks north = inks(folder / "north.png");
  CHECK(north.width == 300);
  CHECK(north.height == 300);
  CHECK(north.blue > 300);
  CHECK(north.red == 0);
  // The disk fills 92 % of the width.
  CHECK(north.grey > 0.80 * std::numbers::pi * 138 * 138);
  options.view = Vec3{0, 0, 1};
  crest::io::write_picture(folder / "south.png", mesh, graph, options);
  const Inks south = inks(folder / "south.png");
  CHECK(south.blue == 0);
  CHECK(south.red > 20);
  options.show_legend = true;
  options.width = 600;
  crest::io::write_picture(folder / "legend.png", mesh, graph, options);
  CHECK(inks(folder / "legend.png").blue > 0);
  CHECK(inks(folder / "legend.png").height > 600);

  crest::io::write_picture(folder / "south.svg", mesh, graph, options);
  const std::string svg = read_text(folder / "south.svg");
  CHECK(svg.ends_with("</svg>\n"));
  const std::string drawn = svg.substr(0, svg.find("font-family"));
  CHECK(drawn.find("stroke=\"#da1a20\"") != std::string::npos);
  CHECK(drawn.find("stroke=\"#1c46de\"") == std::string::npos);
  CHECK(words_starting(drawn, "<circle") == 1);
}

TEST_CASE("a picture by salience draws salient lines wide, others thin, and significant umbilics",
          "[io]") {
  const TriangleMesh mesh = sphere(32, 48);
  RidgeGraph graph = two_ridges(mesh);
  const TemporaryFolder folder;
  PictureOptions options;
  options.width = 300;
  options.show_legend = false;
  options.by_salience = true;
  options.view = Vec3{0, 0, -1};
  const auto ink = [&](const char* name) {
    crest::io::write_picture(folder / name, mesh, graph, options);
    return inks(folder / name).blue;
  };
  const int thin = ink("thin.png");
  options.full_level = 0;
  const int all = ink("all.png");
  options.full_level = 2;
  for (Crossing& c : graph.ridges[0].crossings) c.level = 2;
  CHECK(ink("salient.png") == all);
  CHECK(2 * thin < all);

  // The umbilic in the south has a ridge, but no region of non-zero index.
  options.view = Vec3{0, 0, 1};
  const auto marks = [&](const char* name, const char* mark) {
    crest::io::write_picture(folder / name, mesh, graph, options);
    return words_starting(read_text(folder / name), mark);
  };
  CHECK(marks("none.svg", "<circle") == 0);
  graph.umbilics[0].region_twice_index = -1;
  CHECK(marks("umbilic.svg", "<circle") == 1);
  graph.umbilics[0].level = 0;
  CHECK(marks("region.svg", "<circle") == 0);
}

TEST_CASE("a picture by salience draws a line whole where it weaves along an outline", "[io]") {
  const TriangleMesh mesh = sphere(32, 160);
  const Ridge front = latitude(mesh, 0.05, Colour::blue, RidgeType::elliptic);
  const Ridge back = latitude(mesh, -0.15, Colour::blue, RidgeType::elliptic);
  REQUIRE(front.crossings.size() == 320);
  REQUIRE(back.crossings.size() == 320);
  const TemporaryFolder folder;
  // The strokes of a loop of which in every `period` crossings those from `first` on are behind.
  const auto strokes = [&](std::size_t period, std::size_t first, bool by_salience) {
    RidgeGraph graph;
    graph.ridges = {front};
    for (std::size_t i = 0; i < 320; ++i)
      if (i % period >= first) graph.ridges[0].crossings[i] = back.crossings[i];
    PictureOptions options;
    options.width = 600;
    options.show_legend = false;
    options.view = Vec3{0, 0, -1};
    options.by_salience = by_salience;
    crest::io::write_picture(folder / "woven.svg", mesh, graph, options);
    const std::string svg = read_text(folder / "woven.svg");
    return std::count(svg.begin() + static_cast<std::ptrdiff_t>(svg.find("<g ")), svg.end(), 'M') /
           2;  // each stroke has a rim
  };
  CHECK(strokes(10, 8, false) == 32);
  CHECK(strokes(10, 8, true) == 1);
  CHECK(strokes(64, 32, true) == 5);  // too long a stretch to be drawn
  CHECK(strokes(10, 1, true) == 0);   // glimpses
}

TEST_CASE("pictures repeat byte by byte and refuse nonsense", "[io]") {
  const TriangleMesh mesh = sphere(16, 24);
  const RidgeGraph graph = two_ridges(mesh);
  const TemporaryFolder folder;
  PictureOptions options;
  options.width = 200;
  for (const char* name : {"a.png", "a.svg"}) {
    crest::io::write_picture(folder / name, mesh, graph, options);
    const std::string first = read_text(folder / name);
    crest::io::write_picture(folder / name, mesh, graph, options);
    CHECK(read_text(folder / name) == first);
  }
  using crest::kernel::InputError;
  CHECK_THROWS_AS(crest::io::write_picture(folder / "a.gif", mesh, graph, options), InputError);
  options.width = 3;
  CHECK_THROWS_AS(crest::io::write_picture(folder / "b.png", mesh, graph, options), InputError);
  options.width = 200;
  options.view = Vec3{0, 0, 0};
  CHECK_THROWS_AS(crest::io::write_picture(folder / "b.png", mesh, graph, options), InputError);
  CHECK(folder.entries() == 2);
}

TEST_CASE("meshes of extreme size can be drawn", "[io]") {
  const TemporaryFolder folder;
  PictureOptions options;
  options.width = 120;
  options.show_legend = false;
  for (const double scale : {1e-200, 1e-9, 1.0, 1e9, 1e150}) {
    INFO(scale);
    TriangleMesh unit = sphere(16, 24);
    std::vector<Vec3> points = unit.points();
    for (Vec3& p : points)
      for (double& x : p) x *= scale;
    const TriangleMesh mesh(points, unit.faces());
    crest::io::write_picture(folder / "a.png", mesh, {}, options);
    CHECK(inks(folder / "a.png").grey > 0.80 * std::numbers::pi * 55 * 55);
  }
}
