// SPDX-License-Identifier: GPL-3.0-or-later
// Each rule of the cleaning on soups by hand: what becomes of them, what is counted, what is said.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "io/clean/triangulate.hpp"
#include "tests/io/clean_soups.hpp"

using namespace crest::tests;
using crest::io::CleanOptions;
using crest::io::words;
using crest::kernel::kNone;

namespace {

using Lines = std::vector<std::string>;

CleanOptions weld(double distance) {
  CleanOptions options;
  options.weld = distance;
  return options;
}
CleanOptions split() {
  CleanOptions options;
  options.split = true;
  return options;
}
CleanOptions outward() {
  CleanOptions options;
  options.outward = true;
  return options;
}

std::vector<Face> tetrahedron_and(const Face& face) {
  std::vector<Face> faces = kTetrahedronFaces;
  faces.push_back(face);
  return faces;
}

std::vector<Face> turned(std::vector<Face> faces) {
  for (Face& face : faces) std::swap(face[1], face[2]);
  return faces;
}

}  // namespace

TEST_CASE("a clean surface stays as it is, without a word", "[io]") {
  const Cleaned c = cleaned(soup_of(kTetrahedronPoints, kTetrahedronFaces));
  CHECK(c.surface.points == kTetrahedronPoints);
  CHECK(c.surface.faces == std::vector<Triangle>{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
  CHECK(c.surface.point_of == std::vector<Index>{0, 1, 2, 3});
  CHECK(c.surface.cell_of == std::vector<Index>{0, 1, 2, 3});
  CHECK(words(c.done).empty());
}

TEST_CASE("cells of other dimensions are left out by kind", "[io]") {
  Soup soup = soup_of(kTetrahedronPoints, {});
  soup.cells.add(CellType::tetrahedron, Face{0, 1, 2, 3});
  soup.cells.add(CellType::line, Face{0, 1});
  soup.cells.add(CellType::triangle, Face{0, 1, 2});
  soup.cells.add(CellType::line, Face{0, 2});
  soup.cells.add(CellType::vertex, Face{9});  // nobody looks at it
  const Cleaned c = cleaned(soup);
  CHECK(c.surface.faces == std::vector<Triangle>{{0, 1, 2}});
  CHECK(c.surface.cell_of == std::vector<Index>{2});
  CHECK(words(c.done) ==
        Lines{"left out 1 point, 2 lines, 1 tetrahedron", "left out 1 vertex that no face uses"});
  // Not what is a face, or what may be: a number that VTK has not filled, or does not know.
  for (const int type : {52, 99}) {
    Soup other = soup;
    other.cells.add(CellType(type), Face{0, 1});
    CHECK(cleaned(other).error.starts_with(
        fmt::format("cell 5: has VTK's type {}; give triangles", type)));
  }
}

TEST_CASE("quadrilaterals, pixels, polygons and strips become triangles of their cell", "[io]") {
  const std::vector<Vec3> square = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}, {4, 0, 0}};
  Soup soup = soup_of(square, {{0, 1, 2, 3}, {1, 4, 2}});
  CHECK(cleaned(soup).surface.faces ==
        std::vector<Triangle>{{3, 0, 1}, {3, 1, 2}, {1, 4, 2}});  // equal: tip 0
  CHECK(cleaned(soup).surface.cell_of == std::vector<Index>{0, 0, 1});
  CHECK(words(cleaned(soup).done) == Lines{"split 1 polygon into triangles"});
  // Two that share both ends of their shorter diagonal: the second takes the other one.
  const Cleaned doublet = cleaned(soup_of({{0, -1, 0}, {0, 1, 0}, {-2, 0, 0}, {2, 0, 0}, {0, 0, 3}},
                                          {{2, 0, 4, 1}, {1, 4, 0, 3}}));
  CHECK(doublet.error == "");
  CHECK(doublet.surface.faces.size() == 4);
  Soup pixel;
  pixel.points = square;
  pixel.cells.add(CellType::pixel, Face{0, 1, 3, 2});
  CHECK(cleaned(pixel).surface.faces == std::vector<Triangle>{{3, 0, 1}, {3, 1, 2}});
  Soup strip;
  strip.points = square;
  strip.cells.add(CellType::triangle_strip, Face{3, 0, 2, 1, 4});
  const Cleaned c = cleaned(strip);
  CHECK(c.surface.faces == std::vector<Triangle>{{3, 0, 2}, {2, 0, 1}, {2, 1, 4}});
  CHECK(c.done.polygons == 1);
  CHECK(c.done.turned_faces == 0);
  Soup quadratic;
  quadratic.points = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  quadratic.cells.add(CellType::quadratic_triangle, Face{0, 1, 2, 3, 4, 5});
  CHECK(cleaned(quadratic).surface.points.size() == 3);
  CHECK(words(cleaned(quadratic).done) == Lines{"took 1 curved face by the corners alone"});
  const Cleaned curved = cleaned(quadratic, {}, Purpose::function);
  CHECK(curved.surface.midside == std::vector<std::array<Index, 3>>{{3, 4, 5}});
  CHECK(words(curved.done).empty());
}

TEST_CASE("of a polygon that meets a vertex twice each triangle knows its corners", "[io]") {
  // A square around a square hole, cut from 0 to 4; what surrounds it comes first, turned round.
  std::vector<Vec3> points;
  for (const auto& [low, high] : {std::pair{0., 3.}, {1., 2.}, {-1., 4.}})
    points.insert(points.end(), {{low, low, 0}, {high, low, 0}, {high, high, 0}, {low, high, 0}});
  std::vector<Face> faces = {{0, 1, 1}};
  for (const int i : {0, 1, 2, 3}) faces.push_back({i, (i + 1) % 4, 8 + (i + 1) % 4, 8 + i});
  faces.push_back({0, 1, 2, 3, 0, 4, 7, 6, 5, 4});
  const Soup soup = soup_of(points, faces);
  const Surface surface = cleaned(soup, {}, Purpose::connectivity).surface;
  REQUIRE(surface.faces.size() == 16);
  REQUIRE(surface.places.size() == 16);
  std::vector<std::size_t> met(10, 0);
  for (Index f = 0; f < 16; ++f) {
    const std::vector<Index> corners = crest::io::corners_of(soup, surface.cell_of[f]);
    CHECK((surface.places[f][0] == kNone) == (f < 8));
    for (std::size_t k = 0; f >= 8 && k < 3; ++k) {
      const Index at = surface.places[f][k];
      REQUIRE(at < 10);
      CHECK(corners[at] == surface.faces[f][k]);
      ++met[at];
    }
  }
  CHECK(std::count(met.begin(), met.end(), 0) == 0);
  CHECK(cleaned(soup, {}, Purpose::connectivity).done.turned_faces == 8);
  CHECK(cleaned(soup_of(points, {{0, 1, 2, 3}})).surface.places.empty());
}

TEST_CASE("faces of higher order are taken by their corners", "[io]") {
  Soup soup;
  for (int i = 0; i < 9; ++i) soup.points.push_back({double(i % 3), double(i / 3), 0});
  const std::tuple<CellType, Face, std::size_t> kinds[] = {
      {CellType::quadratic_linear_quad, {0, 2, 8, 6, 1, 7}, 2},
      {CellType::biquadratic_triangle, {0, 2, 6, 1, 4, 3, 4}, 1},
      {CellType::quadratic_polygon, {0, 2, 8, 6, 1, 5, 7, 3}, 2},
      {CellType::quadratic_polygon, {0, 2, 6, 1, 4, 3}, 1},
      {CellType::bezier_triangle, {0, 2, 6, 1, 4, 3}, 1},
      {CellType::bezier_quad, {0, 2, 8, 6, 1, 5, 7, 3, 4}, 2}};
  for (const auto& [type, nodes, faces] : kinds) {
    Soup one = soup;
    one.cells.add(type, nodes);
    const Cleaned c = cleaned(one);
    INFO(static_cast<int>(type) << " " << c.error);
    CHECK(c.surface.faces.size() == faces);
    CHECK(c.surface.points.size() == faces + 2);
    CHECK(c.done.curved_faces == 1);
    CHECK(c.done.polygons == faces - 1);
    CHECK(c.done.turned_faces == 0);
    one.cells.add(type, Face(nodes.begin(), nodes.begin() + (faces == 1 ? 1 : 3)));
    CHECK(cleaned(one).error.starts_with("cell 1: has"));
  }
}

TEST_CASE("repeated corners, duplicates and unused vertices are left out", "[io]") {
  CHECK(cleaned(soup_of(kTetrahedronPoints, tetrahedron_and({1, 1, 3}))).surface.faces.size() == 4);
  CHECK(words(cleaned(soup_of(kTetrahedronPoints, tetrahedron_and({1, 1, 3}))).done) ==
        Lines{"left out 1 face with repeated corners"});
  CHECK(words(cleaned(soup_of(kTetrahedronPoints, tetrahedron_and({1, 3}))).done) ==
        Lines{"left out 1 face with repeated corners"});
  for (const Face& twice : {Face{2, 3, 1}, Face{3, 2, 1}}) {
    const Cleaned c = cleaned(soup_of(kTetrahedronPoints, tetrahedron_and(twice)));
    CHECK(c.surface.cell_of == std::vector<Index>{0, 1, 2, 3});
    CHECK(words(c.done) == Lines{"left out 1 face with the vertices of another"});
  }
  const double nan = std::nan("");
  std::vector<Vec3> points = {{nan, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, HUGE_VAL, 0}, {0, 1, 0}};
  const Cleaned c = cleaned(soup_of(points, {{1, 2, 4}, {0, 0, 3}}));
  CHECK(c.surface.point_of == std::vector<Index>{1, 2, 4});
  CHECK(c.surface.faces == std::vector<Triangle>{{0, 1, 2}});
  CHECK(words(c.done) ==
        Lines{"left out 1 face with repeated corners", "left out 2 vertices that no face uses"});
  CHECK(cleaned(soup_of(points, {{1, 2, 4}, {0, 1, 2}}))
            .error.starts_with("vertex 0: its coordinate x is not a number; "));
  CHECK(cleaned(soup_of(points, {{1, 2, 4, 3}}))
            .error.starts_with("vertex 3: its coordinate y is not finite; "));
  CHECK(cleaned(soup_of(points, {{1, 2, 5}}))
            .error.starts_with(
                "face 0: vertex 5 (counted from 0) does not exist; the file has 5 vertices"));
  CHECK(cleaned(soup_of(points, {})).error.starts_with("faces: there are none; "));
  CHECK(cleaned(soup_of(points, {{1, 1, 2}})).error.starts_with("faces: all have repeated "));
}

TEST_CASE("every fan but the first gets a vertex of its own", "[io]") {
  // Two tetrahedra that share vertex 0, and a triangle that does.
  std::vector<Vec3> points = kTetrahedronPoints;
  for (std::size_t v = 1; v < 4; ++v)
    points.push_back({-points[v][0], -points[v][1], -points[v][2]});
  points.push_back({1, 1, 0});
  points.push_back({-1, 1, 0});
  std::vector<Face> faces = turned({{0, 5, 4}, {0, 4, 6}, {0, 6, 5}, {4, 5, 6}});
  faces.insert(faces.end(), kTetrahedronFaces.begin(), kTetrahedronFaces.end());
  faces.push_back({0, 7, 8});
  const Cleaned c = cleaned(soup_of(points, faces));
  CHECK(words(c.done) == Lines{"split 1 vertex where several fans of faces meet"});
  REQUIRE(c.surface.points.size() == 11);
  CHECK(c.surface.point_of[9] == 0);
  CHECK(c.surface.point_of[10] == 0);
  CHECK(c.surface.points[10] == points[0]);
  CHECK(c.surface.faces[0][0] == 0);
  CHECK(c.surface.faces[4] == Triangle{9, 2, 1});
  CHECK(c.surface.faces[8] == Triangle{10, 7, 8});
}

TEST_CASE("welding: first come, first served, exactly", "[io]") {
  // A strip of vertices 1 apart: 0 takes 1, 2 stays and takes 3.
  const std::vector<Vec3> points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0},
                                    {3, 0, 0}, {0, 9, 0}, {9, 9, 0}};
  const Soup soup = soup_of(points, {{0, 1, 4}, {1, 2, 4}, {2, 3, 5}});
  const Cleaned c = cleaned(soup, weld(1));
  CHECK(c.surface.point_of == std::vector<Index>{0, 2, 4});
  CHECK(c.surface.faces == std::vector<Triangle>{{0, 1, 2}});
  CHECK(words(c.done) == Lines{"left out 2 faces with repeated corners",
                               "left out 1 vertex that no face uses",
                               "welded 2 vertices to others"});
  CHECK(cleaned(soup, weld(std::nextafter(1, 0))).done.welded_vertices == 0);
  CHECK(cleaned(soup, weld(0)).done.welded_vertices == 0);
  // Distances that no double holds, on both sides of a grid's line, far from the origin.
  const double far = 0x1p40;
  for (const double t : {1e-9, 0.1, 3.0, 0x1p-12}) {
    const std::vector<Vec3> pair = {{far, 0, 0}, {far + 0x1p-12, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    CHECK(cleaned(soup_of(pair, {{0, 2, 3}, {1, 3, 2}}), weld(t)).done.welded_vertices ==
          (t < 0x1p-12 ? 0u
           : t < 1.4   ? 1u
                       : 2u));
  }
  // Seams: two squares whose common corners are there twice.
  const std::vector<Vec3> seam = {{0, 0, 0}, {1, 0, 0},    {1, 1, 0}, {0, 1, 0},
                                  {2, 0, 0}, {1, -0.0, 0}, {2, 1, 0}, {1, 1, 0}};
  const Soup squares = soup_of(seam, {{0, 1, 2, 3}, {5, 4, 6, 7}});
  CHECK(words(cleaned(squares).done) ==
        Lines{"split 2 polygons into triangles",
              "2 vertices stand at the place of another one, faces that only meet there are not "
              "joined; --weld 0 makes them one"});
  const Cleaned joined = cleaned(squares, weld(0));
  CHECK(joined.surface.point_of == std::vector<Index>{0, 1, 2, 3, 4, 6});
  CHECK(words(joined.done) ==
        Lines{"split 2 polygons into triangles", "welded 2 vertices to others"});
}

TEST_CASE("edges of three faces are refused with the option that cuts them", "[io]") {
  // A square of two triangles and a fin on its diagonal.
  const std::vector<Vec3> points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}};
  const Soup fin = soup_of(points, {{0, 1, 2}, {0, 2, 3}, {0, 2, 4}});
  CHECK(cleaned(fin).error ==
        "edge 0-2: is in faces 0, 1 and 2, 1 edge is so in all; separate the sheets that meet "
        "there, or cut them apart with --split");
  const Cleaned c = cleaned(fin, split());
  CHECK(c.done.cut_edges == 1);
  CHECK(c.surface.points.size() == 9);  // three triangles apart: each has a fan at 0 and at 2
  // A fin inside a disk: around its ends the sheet goes on, so that it stays whole.
  std::vector<Vec3> disk = {{0, 0, 0},  {1, 0, 0}, {-2, 0, 0}, {0, 2, 0},
                            {0, -2, 0}, {3, 0, 0}, {0.5, 0, 1}};
  std::vector<Face> faces = {{0, 1, 3}, {1, 0, 4}, {0, 3, 2}, {0, 2, 4},
                             {1, 5, 3}, {1, 4, 5}, {0, 1, 6}};
  const Cleaned sheet = cleaned(soup_of(disk, faces), split());
  CHECK(sheet.done.cut_edges == 1);
  CHECK(sheet.done.split_vertices == 2);
  CHECK(sheet.surface.points.size() == 9);
  CHECK(sheet.surface.faces[0] == Triangle{0, 1, 3});
  CHECK(sheet.surface.faces[1] == Triangle{1, 0, 4});
  CHECK(sheet.surface.faces[6] == Triangle{7, 8, 6});
}

TEST_CASE("one-sided surfaces are for functions, or cut open on demand", "[io]") {
  std::vector<Vec3> points;
  std::vector<Face> faces;
  constexpr int n = 7;
  for (int i = 0; i < n; ++i) {
    const double t = 2 * 3.14159265358979 * i / n;
    for (const double w : {-1.0, 1.0}) {
      const double r = 3 + w * std::cos(0.5 * t);
      points.push_back({r * std::cos(t), r * std::sin(t), w * std::sin(0.5 * t)});
    }
  }
  for (int i = 0; i < n; ++i) {
    const int a = 2 * i, b = 2 * i + 1, c = i + 1 < n ? a + 2 : 1, d = i + 1 < n ? b + 2 : 0;
    faces.push_back({a, c, d, b});
  }
  const Soup moebius = soup_of(points, faces);
  CHECK(cleaned(moebius).error.find("the surface is one-sided (not orientable); cut it open with "
                                    "--split") != std::string::npos);
  CHECK(cleaned(moebius, {}, Purpose::function).surface.faces.size() == 2 * n);
  const Cleaned c = cleaned(moebius, split());
  CHECK(c.done.cut_edges >= 1);
  CHECK(c.surface.points.size() == points.size() + 2);
  CHECK(cleaned(soup_of(c.surface)).error.empty());
}

TEST_CASE("orientation: the majority, and outward on demand", "[io]") {
  std::vector<Face> faces = kTetrahedronFaces;
  std::swap(faces[0][1], faces[0][2]);
  CHECK(words(cleaned(soup_of(kTetrahedronPoints, faces)).done) ==
        Lines{"flipped 1 face oriented against the majority of their component"});
  const Soup inside = soup_of(kTetrahedronPoints, turned(kTetrahedronFaces));
  const Cleaned seen = cleaned(inside);
  CHECK(seen.done.inside_out_parts == 1);
  CHECK(seen.surface.faces[0] == Triangle{0, 1, 2});
  REQUIRE(words(seen.done).size() == 1);
  CHECK(words(seen.done)[0].starts_with("1 closed component has negative volume"));
  CHECK(words(seen.done)[0].find("--outward") != std::string::npos);
  const Cleaned out = cleaned(inside, outward());
  CHECK(out.surface.faces[0] == Triangle{0, 2, 1});
  CHECK(words(out.done) == Lines{"turned 1 closed component with negative volume"});
  // Open surfaces have no inside.
  const Soup open = soup_of(kTetrahedronPoints, {{0, 1, 2}, {0, 3, 1}});
  CHECK(words(cleaned(open, outward()).done).empty());
}

TEST_CASE("unusable parts of cells are named as the file names them", "[io]") {
  Soup soup = soup_of(kTetrahedronPoints, tetrahedron_and({0, 1, 2}));
  soup.point_tags = {10, 20, 30, 40};
  soup.cell_tags = {1, 2, 3, 4, 7};
  soup.points[2][1] = HUGE_VAL;
  CHECK(cleaned(soup).error.starts_with("vertex 30: its coordinate y is not finite"));
  soup.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
  const std::string line = cleaned(soup).error;
  INFO(line);
  CHECK(line.starts_with("face"));
}
