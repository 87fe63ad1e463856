// SPDX-License-Identifier: GPL-3.0-or-later
// Wavefront OBJ.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/io/soups.hpp"

namespace {

using namespace crest::io;
using namespace crest::tests;
using Nodes = std::vector<Cells::Node>;

const std::string kPoints = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";

}  // namespace

TEST_CASE("corners of OBJ in every spelling", "[io]") {
  const std::string text =
      "# made by hand\r\nmtllib a\\b.mtl\no thing\n" + kPoints +
      "vt 0 0\nvn 0 0 1\ng a\nusemtl b\ns off\nf 1 3 2\nf 1/1 2/1 4/1\nf 1//1 4//1 3//1 # end\n"
      "f\t-3/1/1  -2/-1/-1\t-1/1/1\t\r\nf 1 2 \\\n 3 \\\r\n 4\nf 1 2 3 4 1\nf +1 2 2\nf 1 2\n";
  const Soup soup = soup_of("a.obj", text);
  CHECK(counts(soup) == "4 points, 5 of type 5, 2 of type 7, 1 of type 9");
  const std::vector<Nodes> faces = {{0, 2, 1},    {0, 1, 3},       {0, 3, 2}, {1, 2, 3},
                                    {0, 1, 2, 3}, {0, 1, 2, 3, 0}, {0, 1, 1}, {0, 1}};
  for (std::size_t f = 0; f < faces.size(); ++f) CHECK(nodes_of(soup, f) == faces[f]);
}

TEST_CASE("vertices of OBJ with weights, colours and bad numbers", "[io]") {
  const Soup soup = soup_of("a.obj",
                            "v 0 0 0 1\nv 1 0 0 0.5 0.25 1\nv +1.5e0 1.5D+00 -1.#IND\n"
                            "v 1e999 1 \\\n 2\nf 1 2 3\n");
  CHECK(counts(soup) == "4 points, 1 of type 5");
  CHECK(soup.points[2][0] == 1.5);
  CHECK(soup.points[2][1] == 1.5);
  CHECK(std::isnan(soup.points[2][2]));
  CHECK(std::isinf(soup.points[3][0]));
  CHECK(soup.points[3][2] == 2);
  CHECK(soup.point_name(2) == "vertex 2 (line 3)");
  CHECK(soup.point_name(3) == "vertex 3 (line 5)");
}

TEST_CASE("lines and points of OBJ follow the faces, which keep their numbers", "[io]") {
  const Soup soup = soup_of("a.obj", kPoints + "l 1 2 3/1\nf 1 2 3\np 4\nl -1 -2\nf 2 3 4\n");
  CHECK(counts(soup) == "4 points, 1 of type 2, 2 of type 4, 2 of type 5");
  CHECK(nodes_of(soup, 1) == Nodes{1, 2, 3});
  CHECK(nodes_of(soup, 2) == Nodes{0, 1, 2});
  CHECK(nodes_of(soup, 4) == Nodes{3, 2});
}

TEST_CASE("normals of OBJ are those of the corners, where these agree", "[io]") {
  const std::string normals = "vn 0 0 1\nvn 0 3 4\nvn 0 0 1\n";
  const Soup same = soup_of("a.obj", kPoints + normals + "f 1//1 2//2 3//3\nf 2//-2 1//3 4/1/1\n",
                            {.normals = true});
  CHECK(field_names(same) == "Normals 3*");
  CHECK(numbers_of<double>(same.point_fields, "Normals") ==
        std::vector<double>{0, 0, 1, 0, 3, 4, 0, 0, 1, 0, 0, 1});
  CHECK(same.point_fields[0].missing.empty());
  CHECK(same.warnings.empty());

  const Soup sharp =
      soup_of("a.obj", kPoints + normals + "f 1//1 2//1 3//1\nf 2//2 1//1 4\n", {.normals = true});
  CHECK(sharp.point_fields[0].missing == std::vector<bool>{false, true, false, true});
  CHECK(sharp.warnings == std::vector<std::string>{
                              "left out the normals of 1 vertices, at which faces have different "
                              "ones"});
  CHECK(soup_of("a.obj", kPoints + normals + "f 1//1 2//1 3//1\n").point_fields.empty());
  CHECK(soup_of("a.obj", kPoints + "f 1 2 3\n", {.normals = true}).point_fields.empty());
  // A number that no normal has is none.
  const Soup none = soup_of("a.obj", kPoints + normals + "f 1//9 2//-9 3//1\n", {true, ""});
  CHECK(none.point_fields[0].missing == std::vector<bool>{true, true, false, true});
}

TEST_CASE("faults of OBJ files are named with their line", "[io]") {
  const std::pair<const char*, std::string> faults[] = {
      {"vertex 0 (line 1): has 2 coordinates; give x y z", "v 0 0\n"},
      {"vertex 1 (line 3): coordinate '0x1' is not a number", "v 0 0 0\n\nv 0x1 0 0\n"},
      {"face 0 (line 5): index 0 does not exist; OBJ counts from 1", kPoints + "f 1 2 0\n"},
      {"face 0 (line 5): index -5 is out of range", kPoints + "f 1 2 -5\n"},
      {"face 1 (line 6): index 5 is out of range; the file has 4 vertices, numbered from 1",
       kPoints + "f 1 2 3\nf 1 2 5\n"},
      {"line 0 (line 5): index 7 is out of range", kPoints + "l 1 7\n"},
      {"face 0 (line 5): index 'one' is not an integer", kPoints + "f one 2 3\n"},
      {"face 0 (line 5): index '1.0' is not an integer", kPoints + "f 1.0 2 3\n"},
      {"face 0 (line 5): index '99999999999999999999' is not an integer",
       kPoints + "f 99999999999999999999 2 3\n"},
      {"face 0 (line 7): index 'x' is not an integer", kPoints + "f 1 \\\n 2 \\\r\n x\n"},
      {"byte 3: is zero in a text format", std::string("v 0\0 0 0\n", 9)},
  };
  for (const auto& [expected, text] : faults) {
    const std::string message = soup_error("a.obj", text);
    INFO(text << "\n" << message);
    CHECK(message.find(expected) == 0);
  }
  CHECK(soup_error("a.obj", kPoints + "vn 0 0\n", {.normals = true})
            .starts_with("normal 0 (line 5): is not three numbers"));
  // Forward references are allowed.
  CHECK(counts(soup_of("a.obj", "f 1 2 3\n" + kPoints)) == "4 points, 1 of type 5");
}
