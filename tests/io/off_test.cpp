// SPDX-License-Identifier: GPL-3.0-or-later
// OFF in all its variants.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/io/bytes.hpp"
#include "tests/io/soups.hpp"

namespace {

using namespace crest::io;
using namespace crest::tests;
using crest::kernel::Vec3;
using Nodes = std::vector<Cells::Node>;

const std::string kPoints = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
const std::string kFaces = "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

std::string replaced(std::string text, char from, const std::string& to) {
  std::string result;
  for (const char c : text) c == from ? result += to : result += c;
  return result;
}

void check_tetrahedron(const std::string& text) {
  INFO(text);
  const Soup soup = soup_of("a.off", text);
  CHECK(counts(soup) == "4 points, 4 of type 5");
  CHECK(signed_volume(soup) == Approx(1. / 6));
  CHECK(nodes_of(soup, 3) == Nodes{1, 2, 3});
  CHECK(soup.warnings.empty());
}

}  // namespace

TEST_CASE("spellings of one OFF file give one soup", "[io]") {
  const std::string plain = "OFF\n4 4 6\n" + kPoints + kFaces;
  const std::string texts[] = {
      plain,
      "OFF 4 4 6\n" + kPoints + kFaces,  // counts behind the keyword
      "4 4 6\n" + kPoints + kFaces,      // no keyword
      "off\n4 4 6\n" + kPoints + kFaces,
      "OFF\n4 4\n" + kPoints + kFaces,  // two counts
      "OFF 4 4\n" + kPoints + kFaces,
      "OFF\n4\n4\n6\n" + kPoints + kFaces,  // a count a line
      "\xef\xbb\xbf" + plain,               // byte order mark
      replaced(plain, '\n', "\r\n"),
      replaced(plain, '\n', "\r"),
      replaced(plain, '\n', "\n\n \t \n"),  // blank lines
      replaced(plain, '\n', " # a comment 1 2 3\n# another\n"),
      replaced(plain, '\n', "#x\n"),
      replaced(plain, '\n', " "),  // one line
      replaced(plain, ' ', "\n"),  // a word a line
      replaced("OFF\n4 4\n" + kPoints + kFaces, ' ', "\n"),
      "OFF\n4 4 6\n0 0 0 1 0\n0 0 1 0 0 0\n1\n3 0 2 1 3 0 1 3\n3 0 3 2 3 1 2 3",
      "OFF\n4 4 6\n0 0 0 1 0 0\n0 1 0 0 0 1\n" + kFaces,  // two vertices a line
      plain + "# the end\n",
      plain + "a word behind the end\n",
  };
  for (const std::string& text : texts) check_tetrahedron(text);
}

TEST_CASE("what follows a vertex or a face on its line is no part of it", "[io]") {
  const std::string faces[] = {"3 0 2 1 7\n3 0 1 3 255 0 0\n3 0 3 2 0.5 0.5 0.5 1\n3 1 2 3\n",
                               "3 0 2 1 9 9 9\n3 0 1 3 9 9 9\n3 0 3 2 9 9 9\n3 1 2 3 9 9 9\n"};
  for (const std::string& coloured : faces) {
    check_tetrahedron("OFF\n4 4 6\n" + kPoints + coloured);
    check_tetrahedron(
        "COFF\n4 4 6\n0 0 0 255 0 0 255\n1 0 0 0 0 0 1\n0 1 0 .1 .2 .3 1\n"
        "0 0 1 9 9 9\n" +
        coloured);
    check_tetrahedron("OFF\n4 4 6\n0 0 0 1\n1 0 0 2\n0 1 0 3\n0 0 1 4\n" + coloured);
    // Wrapped vertices and coloured faces: vertices have the numbers that the keyword says.
    check_tetrahedron("OFF\n4 4 6\n0\n0\n0\n1 0\n0 0 1 0\n0 0 1\n" + coloured);
    check_tetrahedron(
        "COFF\n4 4 6\n0 0 0\n9 9 9 1\n1 0 0\n9 9 9 1\n0 1 0\n9 9 9 1\n0 0 1\n9 9 9 "
        "1\n" +
        coloured);
  }
  // Corners that are wrapped, their colour behind the last one.
  check_tetrahedron("OFF\n4 4 6\n" + kPoints + "3 0\n2 1 7\n3\n0 1 3\n3 0 3 2 9 9 9\n3 1\n2\n3\n");
}

TEST_CASE("polygons of OFF keep their corners", "[io]") {
  const Soup soup = soup_of("a.off", "OFF\n5 4 0\n" + kPoints +
                                         "nan 0 inf\n4 0 1 2 3\n5 0 1 2 3 4\n3 1 1 2\n2 0 "
                                         "1\n");
  CHECK(counts(soup) == "5 points, 1 of type 5, 2 of type 7, 1 of type 9");
  CHECK(nodes_of(soup, 1) == Nodes{0, 1, 2, 3, 4});
  CHECK(nodes_of(soup, 2) == Nodes{1, 1, 2});
  CHECK(nodes_of(soup, 3) == Nodes{0, 1});
  CHECK(std::isnan(soup.points[4][0]));
  CHECK(std::isinf(soup.points[4][2]));
  CHECK(soup.point_name(4) == "vertex 4 (line 7)");
}

TEST_CASE("NOFF gives normals where they are asked for", "[io]") {
  const std::string text =
      "STCNOFF\n3 1 0\n0 0 0 0 0 1 255 0 0 255 .5 .5\n1 0 0 0 3 4\n0 1 0 0 0 "
      "1 9\n3 0 1 2\n";
  CHECK(soup_of("a.off", text).point_fields.empty());
  for (const FieldRequest& request :
       {FieldRequest{true, ""}, FieldRequest{true, "Normals"}, FieldRequest{.normals = true}}) {
    const Soup soup = soup_of("a.off", text, request);
    CHECK(field_names(soup) == "Normals 3*");
    CHECK(numbers_of<double>(soup.point_fields, "Normals") ==
          std::vector<double>{0, 0, 1, 0, 3, 4, 0, 0, 1});
    CHECK(soup.point_fields[0].missing.empty());
  }
  const Soup wrapped = soup_of("a.off",
                               "NOFF\n3 1 0\n0 0 0\n0 0 1\n1 0 0\n0 3 4\n0 1 0\n0 0 1\n"
                               "3 0 1 2\n",
                               {.normals = true});
  CHECK(numbers_of<double>(wrapped.point_fields, "Normals") ==
        std::vector<double>{0, 0, 1, 0, 3, 4, 0, 0, 1});
  const Soup partial = soup_of("a.off", "NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 7\n0 1 0 0 0 2\n3 0 1 2\n",
                               {.normals = true});
  CHECK(partial.point_fields[0].missing == std::vector<bool>{false, true, false});
  CHECK(numbers_of<double>(partial.point_fields, "Normals")[3] == 0);
}

namespace {

/// The tetrahedron, each vertex with `behind` numbers, each face with `colours`.
std::string binary_off(const std::string& keyword, int behind, int colours) {
  std::string bytes = keyword + " BINARY\n";
  for (const int count : {4, 4, 6}) put(bytes, count, true);
  for (const Vec3& p : {Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
    for (const double x : p) put(bytes, static_cast<float>(x), true);
    for (int k = 0; k < behind; ++k) put(bytes, static_cast<float>(k), true);
  }
  for (const auto& f : {std::array{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}) {
    put(bytes, 3, true);
    for (const int v : f) put(bytes, v, true);
    put(bytes, colours, true);
    for (int k = 0; k < colours; ++k) put(bytes, 0.5F, true);
  }
  return bytes;
}

}  // namespace

TEST_CASE("binary OFF", "[io]") {
  check_tetrahedron(binary_off("OFF", 0, 0));
  check_tetrahedron(binary_off("OFF", 0, 4));
  check_tetrahedron(binary_off("COFF", 4, 0));
  check_tetrahedron(binary_off("STCNOFF", 9, 1));
  std::string crlf = binary_off("OFF", 0, 3);
  check_tetrahedron(crlf.insert(10, "\r"));
  const Soup soup = soup_of("a.off", binary_off("NOFF", 3, 0), {.normals = true});
  CHECK(field_names(soup) == "Normals 3*");
  CHECK(numbers_of<double>(soup.point_fields, "Normals")[5] == 2);

  const std::string whole = binary_off("OFF", 0, 1);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const std::string message = soup_error("a.off", whole.substr(0, size));
    INFO(size << ": " << message);
    CHECK(message.find("; ") != std::string::npos);
  }
  const auto with = [&](std::size_t number, int value) {
    std::string bytes = whole;
    std::string replacement;
    put(replacement, value, true);
    return soup_error("a.off", bytes.replace(11 + 4 * number, 4, replacement));
  };
  CHECK(with(0, 1 << 30).starts_with("header: announces 1073741824 vertices and 4 faces, more"));
  CHECK(with(1, -1).starts_with("header: has a bad count -1"));
  CHECK(with(15, 0).starts_with("face 0: has 0 corners"));
  CHECK(with(15, 1 << 30).starts_with("face 0: the file ends before or in it"));
  CHECK(with(22, 4).starts_with("face 1: vertex 4 does not exist"));
  CHECK(with(19, -2).starts_with("face 0: has a bad count -2"));
}

TEST_CASE("faults of OFF files are named with their line", "[io]") {
  const std::pair<const char*, std::string> faults[] = {
      {"header: is missing; start the file with 'OFF'", "# nothing\n"},
      {"header (line 1): 'PLY' is not read", "PLY\n"},
      {"header (line 1): '4OFF' is not read", "4OFF\n3 1 0\n"},
      {"header (line 2): has a bad count 'x'", "OFF\n3 x 0\n"},
      {"header (line 2): has a bad count '-3'", "OFF\n-3 1 0\n"},
      {"header (line 2): announces 4000000000 vertices and 1 faces, more than the file holds",
       "OFF\n4000000000 1 0\n0 0 0\n"},
      {"vertex 1 (line 4): has 2 coordinates; give x y z",
       "OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2"
       "\n"},
      {"vertex 1 (line 4): coordinate '1,5' is not a number",
       "OFF\n3 1 0\n0 0 0\n1,5 0 0\n0 1 0\n3 0 1 2\n"},
      {"face 0 (line 6): has fewer indices than it announces",
       "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n"},
      {"face 0 (line 6): index '1.5' is not an integer",
       "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1.5 2\n"},
      {"face 0 (line 6): vertex 3 does not exist; the file has 3 vertices, numbered from 0",
       "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"},
      {"face 0 (line 6): has 0 corners", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"},
      {"vertices: have no normals; start the file with 'OFF'",
       "NOFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
      {"face 1: is missing, the file ends before it; the file is truncated",
       "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
      {"vertex 2: is missing, the file ends before it", "OFF\n3 1 0\n0 0 0\n1 0 0\n"},
      {"byte 26: is zero in a text format", std::string("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 \0 0", 29)},
  };
  for (const auto& [expected, text] : faults) {
    const std::string message = soup_error("a.off", text);
    INFO(text << "\n" << message);
    CHECK(message.find(expected) == 0);
  }
}
