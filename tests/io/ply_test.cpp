// SPDX-License-Identifier: GPL-3.0-or-later
// PLY in all its variants.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/io/bytes.hpp"
#include "tests/io/soups.hpp"

namespace {

using namespace crest::io;
using namespace crest::tests;
using Nodes = std::vector<Cells::Node>;

/// A number's type in headers and how it is written.
struct Type {
  const char* name;
  void (*put)(std::string&, double, bool);
  bool real = false;
};
template <class T>
void put_as(std::string& bytes, double x, bool big) {
  put(bytes, static_cast<T>(x), big);
}
const Type kTypes[] = {{"char", put_as<std::int8_t>},   {"uint8", put_as<std::uint8_t>},
                       {"short", put_as<std::int16_t>}, {"ushort", put_as<std::uint16_t>},
                       {"int32", put_as<std::int32_t>}, {"uint", put_as<std::uint32_t>},
                       {"int64", put_as<std::int64_t>}, {"uint64", put_as<std::uint64_t>},
                       {"float", put_as<float>, true},  {"float64", put_as<double>, true}};

enum class Storage { text, little, big };

/// Numbers one after another.
class Data {
 public:
  explicit Data(Storage storage) : storage_(storage) {}
  void add(const Type& type, double x) {
    if (storage_ != Storage::text) return type.put(bytes, x, storage_ == Storage::big);
    const std::string number = std::to_string(x);
    bytes += (type.real ? number : number.substr(0, number.find('.'))) + "\n";
  }
  std::string bytes;

 private:
  Storage storage_;
};

std::string header(Storage storage, const std::string& elements) {
  const char* format = storage == Storage::text     ? "ascii"
                       : storage == Storage::little ? "binary_little_endian"
                                                    : "binary_big_endian";
  return std::string("ply\nformat ") + format + " 1.0\n" + elements + "end_header\n";
}

const Type &kInt = kTypes[4], &kUchar = kTypes[1], &kFloat = kTypes[8];
const double kPoints[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
const int kFaces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

/// A tetrahedron whose coordinates, list lengths and indices have these types.
std::string tetrahedron(Storage storage, const Type& coordinate, const Type& length,
                        const Type& index) {
  std::string elements = "element vertex 4\n";
  for (const char* name : {"x", "y", "z"})
    elements += std::string("property ") + coordinate.name + " " + name + "\n";
  elements += std::string("element face 4\nproperty list ") + length.name + " " + index.name +
              " vertex_indices\n";
  Data data(storage);
  for (const auto& point : kPoints)
    for (const double x : point) data.add(coordinate, x);
  for (const auto& face : kFaces) {
    data.add(length, 3);
    for (const int v : face) data.add(index, v);
  }
  return header(storage, elements) + data.bytes;
}

const std::string kXyz = "property float x\nproperty float y\nproperty float z\n";
const std::string kList = "property list uchar int vertex_indices\n";
const std::string kVertices = "element vertex 3\n" + kXyz;
const std::string kTriangle = "0 0 0\n1 0 0\n0 1 0\n";

std::string text(const std::string& elements, const std::string& data) {
  return header(Storage::text, elements) + data;
}

}  // namespace

TEST_CASE("PLY has coordinates, lengths and indices of any type", "[io]") {
  for (const Storage storage : {Storage::text, Storage::little, Storage::big}) {
    for (const Type& type : kTypes) {
      INFO(type.name);
      std::vector<std::string> files = {tetrahedron(storage, type, kUchar, kInt)};
      if (!type.real) {
        files.push_back(tetrahedron(storage, kFloat, type, kInt));
        files.push_back(tetrahedron(storage, kFloat, kUchar, type));
      }
      for (const std::string& file : files) {
        const Soup soup = soup_of("a.ply", file);
        CHECK(counts(soup) == "4 points, 4 of type 5");
        CHECK(signed_volume(soup) == Approx(1. / 6));
      }
    }
  }
}

TEST_CASE("headers of PLY are blank in places, commented, of any line end", "[io]") {
  const std::string plain = text(kVertices + "element face 1\n" + kList, kTriangle + "3 0 1 2\n");
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string result = plain;
    for (std::size_t at = 0; (at = result.find(from, at)) != result.npos; at += to.size())
      result.replace(at, from.size(), to);
    return result;
  };
  for (const std::string& file :
       {plain, with("\n", "\r\n"), with("\n", "\r"), with("\n", "\n\n"),
        with("element", "comment a b c\nobj_info 1 2 3\nelement"), with("ply\n", "ply\ncomment\n"),
        with("vertex_indices", "vertex_index"), "\xef\xbb\xbf" + plain, plain + "trailing 1 2\n"})
    CHECK(counts(soup_of("a.ply", file)) == "3 points, 1 of type 5");
  // The data of a binary file may start with a line feed.
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    std::string file;
    for (const char c : header(Storage::little,
                               "element vertex 1\nproperty uchar x\nproperty uchar "
                               "y\nproperty uchar z\nelement face 1\n" +
                                   kList))
      c == '\n' ? file += end : file += c;
    put<std::uint8_t>(file, 10);
    put<std::uint8_t>(file, 13);
    put<std::uint8_t>(file, 10);
    put<std::uint8_t>(file, 1);
    put<std::int32_t>(file, 0);
    const Soup soup = soup_of("a.ply", file);
    CHECK(counts(soup) == "1 points, 1 of type 7");
    CHECK(soup.points[0] == crest::kernel::Vec3{10, 13, 10});
  }
}

TEST_CASE("properties of PLY are fields", "[io]") {
  const std::string elements =
      "element camera 2\nproperty float a\nproperty list int float b\n"
      "element vertex 3\nproperty uchar red\n" +
      kXyz +
      "property list uchar float uv\nproperty double quality\nproperty int id\n"
      "property float nx\nproperty float ny\nproperty float nz\nproperty uint64 big\n"
      "element edge 1\nproperty int vertex1\nproperty int vertex2\n"
      "element face 2\nproperty double area\n" +
      kList + "property list uchar float texcoord\nproperty short group\n";
  const std::string data =
      "1 2 3 4\nnan 0\n"
      "7 0 0 0 2 .5 .5 nan 1 0 0 1 1\n8 1 0 0 0 0.25 -2 0 0 2 2\n9 0 1 0 1 x 3 3 0 0 3 4\n"
      "0 1\n"
      "0.5 3 0 1 2 0 -5\n1.5 4 0 1 2 1 2 8 9 6\n";
  const Soup soup = soup_of("a.ply", text(elements, data), {true, ""});
  CHECK(counts(soup) == "3 points, 1 of type 5, 1 of type 9");
  CHECK(field_names(soup) ==
        "Normals 3*, red 1, uv 0, quality 1, id 1, big 1; cells: area 1, texcoord 0, group 1");
  const auto& fields = soup.point_fields;
  CHECK(numbers_of<std::int64_t>(fields, "red") == std::vector<std::int64_t>{7, 8, 9});
  CHECK(numbers_of<std::int64_t>(fields, "id") == std::vector<std::int64_t>{1, -2, 3});
  CHECK(numbers_of<std::uint64_t>(fields, "big") == std::vector<std::uint64_t>{1, 2, 4});
  CHECK(numbers_of<double>(fields, "Normals") == std::vector<double>{0, 0, 1, 0, 0, 2, 0, 0, 3});
  CHECK(std::isnan(numbers_of<double>(fields, "quality")[0]));
  CHECK(numbers_of<double>(fields, "quality")[1] == 0.25);
  CHECK(numbers_of<double>(soup.cell_fields, "area") == std::vector<double>{0.5, 1.5});
  CHECK(numbers_of<std::int64_t>(soup.cell_fields, "group") == std::vector<std::int64_t>{-5, 6});

  // Only what is asked for is read: 'x' is no number, but nobody wants it.
  const Soup one = soup_of("a.ply", text(elements, data), {true, "id"});
  CHECK(field_names(one) == field_names(soup));
  CHECK(numbers_of<std::int64_t>(one.point_fields, "id").size() == 3);
  CHECK(numbers_of<double>(one.point_fields, "quality").empty());
  const Soup normals = soup_of("a.ply", text(elements, data), {.normals = true});
  CHECK(numbers_of<double>(normals.point_fields, "Normals").size() == 9);
  CHECK(soup_of("a.ply", text(elements, data)).point_fields[0].size() == 0);
}

TEST_CASE("binary rows with and without lists give the same fields", "[io]") {
  constexpr int rows = 1500;  // more than a block
  for (const Storage storage : {Storage::little, Storage::big, Storage::text}) {
    Soup soups[2];
    for (const bool list : {false, true}) {
      Data data(storage);
      for (int i = 0; i < rows; ++i) {
        data.add(kFloat, i);
        data.add(kInt, -i);
        data.add(kFloat, 0.5 * i);
        if (list) {
          data.add(kUchar, 1);
          data.add(kFloat, 7);
        }
        data.add(kTypes[2], i);
        data.add(kTypes[9], 0.125 * i);
      }
      data.add(kUchar, 3);
      for (const int v : {0, 1, 2}) data.add(kInt, v);
      soups[list] =
          soup_of("a.ply",
                  header(storage,
                         "element vertex 1500\nproperty float x\nproperty int y\nproperty float "
                         "z\n" +
                             std::string(list ? "property list uchar float uv\n" : "") +
                             "property short s\nproperty double d\nelement face 1\n" + kList) +
                      data.bytes,
                  {true, ""});
    }
    CHECK(soups[0].points == soups[1].points);
    CHECK(soups[0].points[1400] == crest::kernel::Vec3{1400, -1400, 700});
    CHECK(numbers_of<std::int64_t>(soups[0].point_fields, "s")[1499] == 1499);
    for (const char* name : {"s", "d"}) {
      CHECK(numbers_of<double>(soups[0].point_fields, name) ==
            numbers_of<double>(soups[1].point_fields, name));
      CHECK(numbers_of<std::int64_t>(soups[0].point_fields, name) ==
            numbers_of<std::int64_t>(soups[1].point_fields, name));
    }
  }
}

TEST_CASE("strips of PLY are separated by -1", "[io]") {
  const std::string strips = "element tristrips 2\nproperty list int int vertex_indices\n";
  const std::string vertices = "element vertex 4\n" + kXyz, points = kTriangle + "0 0 1\n";
  const Soup soup =
      soup_of("a.ply", text(vertices + strips, points + "10 -1 0 1 2 3 -1 -1 1 2 3\n3 3 2 1\n"));
  CHECK(counts(soup) == "4 points, 3 of type 6");
  CHECK(nodes_of(soup, 0) == Nodes{0, 1, 2, 3});
  CHECK(nodes_of(soup, 2) == Nodes{3, 2, 1});
  // Faces beside them have their values, strips none.
  const Soup both =
      soup_of("a.ply",
              text(vertices + strips + "element face 1\n" + kList + "property int id\n",
                   points + "3 0 1 2\n3 3 2 1\n3 1 2 3 77\n"),
              {true, "id"});
  CHECK(counts(both) == "4 points, 1 of type 5, 2 of type 6");
  CHECK(numbers_of<std::int64_t>(both.cell_fields, "id") == std::vector<std::int64_t>{0, 0, 77});
  CHECK(both.cell_fields[0].missing == std::vector<bool>{true, true, false});
  CHECK(soup_error("a.ply", text(vertices + strips, points + "3 0 1 -2\n3 3 2 1\n"))
            .starts_with("strip 0 (line 14): vertex -2 does not exist"));
}

TEST_CASE("faults of PLY files are named with their element", "[io]") {
  const std::string faces = "element face 1\n" + kList;
  std::string cut = tetrahedron(Storage::little, kFloat, kUchar, kInt);
  cut.resize(cut.size() - 1);
  std::string in_vertices = header(
      Storage::big, kVertices + "element face 0\n" + kList + "element strip 1\nproperty uchar a\n");
  const std::pair<std::string, std::string> faults[] = {
      {"header (line 1): does not start with 'ply'", "plx\n"},
      {"header: has no 'format' line", "ply\n" + kVertices + faces + "end_header\n"},
      {"header: has no 'end_header'; the file is truncated", "ply\nformat ascii 1.0\n"},
      {"header (line 2): unknown format 'utf8'", "ply\nformat utf8 1.0\n"},
      {"header (line 4): unknown type 'half'", text("element vertex 1\nproperty half x\n", "")},
      {"header (line 3): property without an element", text("property int x\n", "")},
      {"header (line 3): bad element count", text("element vertex -1\n", "")},
      {"header (line 3): unknown keyword 'elements'", text("elements vertex 1\n", "")},
      {"header: element 'vertex' is there twice",
       text(kVertices + "element vertices 3\n" + kXyz + faces, kTriangle)},
      {"header: vertices have no number 'z'",
       text("element vertex 1\nproperty int x\nproperty int y\n" + faces, "1 2\n")},
      {"header: faces have no list of integers 'vertex_indices'",
       text(kVertices + "element face 1\nproperty list uchar float vertex_indices\n", kTriangle)},
      {"faces: there are none; export the mesh with its faces", text(kVertices, kTriangle)},
      {"faces: there are none, only elements 'edge'",
       text(kVertices + "element edge 1\nproperty int a\n", kTriangle + "1\n")},
      {"header: announces 99999999999 of element 'vertex', more than the file holds",
       text("element vertex 99999999999\n" + kXyz + faces, kTriangle)},
      {"face 0 (line 13): vertex 3 does not exist; the file has 3 vertices, numbered from 0",
       text(kVertices + faces, kTriangle + "3 0 1 3\n")},
      {"face 0 (line 13): a list has a negative length",
       text(kVertices + faces, kTriangle + "-3 0 1 3\n")},
      {"face 0 (line 13): 'x' is not an integer", text(kVertices + faces, kTriangle + "3 0 x 3\n")},
      {"vertex 1 (line 11): '1,0' is not a number",
       text(kVertices + faces, "0 0 0\n1,0 0 0\n0 1 0\n3 0 1 2\n")},
      {"face 0 (line 14): the file ends before or in it",
       text(kVertices + faces, kTriangle + "4000000000 1 2 0\n")},
      {"face 3: the file ends before or in it; the file is truncated", cut},
  };
  for (const auto& [expected, file] : faults) {
    const std::string message = soup_error("a.ply", file);
    INFO(message << "\nexpected " << expected);
    CHECK(message.find(expected) == 0);
  }
}
