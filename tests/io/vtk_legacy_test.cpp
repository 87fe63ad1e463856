// SPDX-License-Identifier: GPL-3.0-or-later
// VTK's legacy files.
#include <catch2/catch.hpp>

#include "tests/io/bytes.hpp"
#include "tests/io/soups.hpp"

namespace {

using namespace crest::io;
using namespace crest::tests;
using Nodes = std::vector<Cells::Node>;

/// Writes a file as text or binary, of version 4.2 or 5.1.
class Writer {
 public:
  Writer(bool binary, bool offsets, const std::string& dataset)
      : binary_(binary), offsets_(offsets) {
    bytes = std::string("# vtk DataFile Version ") + (offsets ? "5.1" : "4.2") + "\n\n" +
            (binary ? "BINARY" : "ASCII") + "\nDATASET " + dataset + "\n";
  }
  void line(const std::string& text) { bytes += text + "\n"; }
  template <class T>
  void numbers(const std::vector<T>& xs) {
    for (const T x : xs)
      if (binary_)
        put(bytes, x, true);
      else
        bytes += std::to_string(x) + (&x == &xs.back() ? "" : " ");
    bytes += "\n";
  }
  void cells(const std::string& name, const std::vector<Nodes>& lists) {
    std::vector<std::int64_t> offsets = {0}, nodes;
    std::vector<std::int32_t> counted;
    for (const Nodes& list : lists) {
      nodes.insert(nodes.end(), list.begin(), list.end());
      offsets.push_back(static_cast<std::int64_t>(nodes.size()));
      counted.push_back(static_cast<std::int32_t>(list.size()));
      for (const auto v : list) counted.push_back(static_cast<std::int32_t>(v));
    }
    if (!offsets_) {
      line(name + " " + std::to_string(lists.size()) + " " + std::to_string(counted.size()));
      return numbers(counted);
    }
    line(name + " " + std::to_string(offsets.size()) + " " + std::to_string(nodes.size()));
    line("OFFSETS vtktypeint64");
    numbers(offsets);
    line("CONNECTIVITY vtktypeint64");
    numbers(nodes);
  }
  std::string bytes;

 private:
  bool binary_, offsets_;
};

const std::vector<double> kPoints = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 0};

template <class Check>
void for_all_forms(const std::string& dataset, const Check& check) {
  for (const bool binary : {false, true}) {
    for (const bool offsets : {false, true}) {
      INFO(dataset << (binary ? " binary" : " text") << (offsets ? " 5.1" : " 4.2"));
      Writer file(binary, offsets, dataset);
      file.line("FIELD FieldData 1");
      file.line("TIME 1 1 double");
      file.numbers<double>({2.5});
      file.line("POINTS 5 double");
      file.numbers(kPoints);
      check(file, binary);
    }
  }
}

}  // namespace

TEST_CASE("legacy polygonal data keep every list of cells in VTK's order", "[io]") {
  for_all_forms("POLYDATA", [](Writer& file, bool) {
    file.line("METADATA\nINFORMATION 1\nNAME L2_NORM_RANGE LOCATION vtkDataArray\nDATA 2 0 1\n");
    file.cells("POLYGONS", {{0, 2, 1}, {0, 1, 4, 2}, {0, 1, 2, 3, 4}});
    file.cells("TRIANGLE_STRIPS", {{0, 1, 2, 4}});
    file.cells("VERTICES", {{3}, {0, 1}});
    file.cells("LINES", {{0, 1}, {0, 1, 2}});
    file.line("CELL_DATA 8\nSCALARS number int 1\nLOOKUP_TABLE default");
    file.numbers<std::int32_t>({0, 1, 2, 3, 4, 5, 6, 7});
    const Soup soup = soup_of("a.vtk", file.bytes, {true, ""});
    REQUIRE(counts(soup) ==
            "5 points, 1 of type 1, 1 of type 2, 1 of type 3, 1 of type 4, 1 of type 5, 1 of type "
            "6, 1 of type 7, 1 of type 9");
    CHECK(nodes_of(soup, 0) == Nodes{3});
    CHECK(nodes_of(soup, 3) == Nodes{0, 1, 2});
    CHECK(nodes_of(soup, 5) == Nodes{0, 1, 4, 2});
    CHECK(nodes_of(soup, 7) == Nodes{0, 1, 2, 4});
    CHECK(soup.points[4] == crest::kernel::Vec3{1, 1, 0});
    CHECK(numbers_of<std::int64_t>(soup.cell_fields, "number")[7] == 7);
  });
}

TEST_CASE("legacy grids keep the types of their cells", "[io]") {
  for_all_forms("UNSTRUCTURED_GRID", [](Writer& file, bool) {
    file.cells("CELLS", {{0, 1, 2, 3}, {0, 1, 2, 4}, {0, 1, 2}, {0, 1, 4, 2}, {3}});
    file.line("CELL_TYPES 5");
    file.numbers<std::int32_t>({10, 8, 5, 9, 1});
    const Soup soup = soup_of("a.vtk", file.bytes);
    CHECK(counts(soup) ==
          "5 points, 1 of type 1, 1 of type 5, 1 of type 8, 1 of type 9, 1 of type 10");
    CHECK(nodes_of(soup, 3) == Nodes{0, 1, 4, 2});
  });
}

TEST_CASE("legacy fields of every kind", "[io]") {
  for_all_forms("POLYDATA", [](Writer& file, bool binary) {
    file.cells("POLYGONS", {{0, 2, 1}, {0, 1, 4, 2}});
    file.line("POINT_DATA 5\nSCALARS height double\nLOOKUP_TABLE mine");
    file.numbers<double>({1, 2, 3, 4, 5});
    file.line("LOOKUP_TABLE mine 2");
    binary ? file.numbers<std::uint8_t>({1, 2, 3, 4, 5, 6, 7, 8}) : file.line("0 0 0 1 1 1 1 1");
    file.line("VECTORS v float");
    file.numbers<float>({0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14});
    file.line("NORMALS n float");
    file.numbers<float>({0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0, 4, 0, 0, 5});
    file.line("TEXTURE_COORDINATES uv 2 float");
    file.numbers<float>({0, 0, 0, 0, 0, 0, 0, 0, 0, 1});
    file.line("COLOR_SCALARS rgb 1");
    binary ? file.numbers<std::uint8_t>({0, 0, 0, 0, 255}) : file.line("0 0 0 0 1");
    file.line("TENSORS t double");
    file.numbers(std::vector<double>(45, 7));
    file.line("FIELD FieldData 4\nlong%20name 1 5 vtktypeint64");
    file.numbers<std::int64_t>({1, 2, 3, 4, -9007199254740993});
    file.line("METADATA\nCOMPONENT_NAMES\nx\n");
    file.line("natural 1 5 unsigned_long");
    file.numbers<std::uint64_t>({1, 2, 3, 4, 18446744073709551615u});
    file.line("other_size 1 2 float");
    file.numbers<float>({1, 2});
    file.line("id 1 5 vtkIdType");
    file.numbers<std::int32_t>({5, 4, 3, 2, 1});
    file.line("CELL_DATA 2\nSCALARS mask bit\nLOOKUP_TABLE default");
    binary ? file.numbers<std::uint8_t>({0x40}) : file.line("0 1");
    const Soup soup = soup_of("a.vtk", file.bytes, {true, ""});
    CHECK(field_names(soup) ==
          "height 1, v 3, n 3*, uv 2, rgb 1, t 9, long name 1, natural 1, id 1; cells: mask 1");
    const auto& fields = soup.point_fields;
    CHECK(numbers_of<double>(fields, "height")[4] == 5);
    CHECK(numbers_of<double>(fields, "v")[14] == 14);
    CHECK(numbers_of<double>(fields, "n")[11] == 4);
    CHECK(numbers_of<double>(fields, "t").size() == 45);
    CHECK(numbers_of<std::int64_t>(fields, "long name")[4] == -9007199254740993);
    CHECK(numbers_of<std::uint64_t>(fields, "natural")[4] == 18446744073709551615u);
    CHECK(numbers_of<std::int64_t>(fields, "id")[0] == 5);
    CHECK(numbers_of<std::int64_t>(soup.cell_fields, "mask") == std::vector<std::int64_t>{0, 1});
    const Soup one = soup_of("a.vtk", file.bytes, {true, "id"});
    CHECK(field_names(one) == field_names(soup));
    CHECK(one.point_fields[0].size() == 0);
    CHECK(one.point_fields[8].size() == 5);
    const Soup normals = soup_of("a.vtk", file.bytes, {.normals = true});
    CHECK(normals.point_fields[2].size() == 15);
  });
}

TEST_CASE("texts of VTK are not narrowed to float", "[io]") {
  const std::string text =
      "# vtk DataFile Version 3.0\ntitle\nascii\ndataset polydata\npoints 3 float\n0.1 "
      "1.00000000001 0 1 0 0 0 1 nan\npolygons 1 4\n3 0 1 2\npoint_data 3\nscalars s float\n"
      "0.1 2 3\nfield f 1\nwords 1 2 string\na b\nc\nscalars t double 1\nlookup_table default\n"
      "1 2 3\n";
  const Soup soup = soup_of("a.vtk", text, {true, ""});
  CHECK(soup.points[0][0] == 0.1);
  CHECK(soup.points[0][1] == 1.00000000001);
  CHECK(field_names(soup) == "s 1, t 1");
  CHECK(numbers_of<double>(soup.point_fields, "s")[0] == 0.1);
}

TEST_CASE("faults of legacy files are named with their section", "[io]") {
  const std::string head = "# vtk DataFile Version 4.2\nt\nASCII\nDATASET POLYDATA\n";
  const std::string points = "POINTS 3 double\n0 0 0 1 0 0 0 1 0\n";
  const std::string binary = "# vtk DataFile Version 4.2\nt\nBINARY\nDATASET POLYDATA\n";
  const std::pair<const char*, std::string> faults[] = {
      {"header (line 1): does not start with '# vtk DataFile Version'", "vtk\n"},
      {"header (line 1): has no version from 1.0 to 5.1", "# vtk DataFile Version 9\n"},
      {"header (line 3): is neither ASCII nor BINARY", "# vtk DataFile Version 4.2\nt\nx\n"},
      {"header: has no DATASET", "# vtk DataFile Version 4.2\nt\nASCII\n"},
      {"dataset (line 4): 'STRUCTURED_POINTS' is not read; convert it to POLYDATA",
       "# vtk DataFile Version 4.2\nt\nASCII\nDATASET STRUCTURED_POINTS\n"},
      {"points (line 5): has a bad count 'many'", head + "POINTS many double\n"},
      {"points (line 5): has the type 'half'", head + "POINTS 3 half\n"},
      {"points: the file ends in it; the file is truncated", head + "POINTS 99999999999 float\n0"},
      {"points (line 5): has a bad count", head + "POINTS 9223372036854775807 float\n0"},
      {"points: the file ends in it", binary + "POINTS 99999999999 double\n0000"},
      {"points (line 6): '1,5' is not a number", head + "POINTS 1 double\n1,5 0 0\n"},
      {"polygons: cell 0 of it does not fit its size 4", head + points + "POLYGONS 1 4\n7 0 1 2\n"},
      {"polygons: the file ends in it", head + points + "POLYGONS 1 4\n3 0 1\n"},
      {"cells: have not one type each", head + points + "CELLS 1 4\n3 0 1 2\nCELL_TYPES 2\n5 5\n"},
      {"cell 0: has the type 300", head + points + "CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n300\n"},
      {"POINT_DATA: is of 2, the file has 3", head + points + "POINT_DATA 2\n"},
      {"scalars (line 7): is neither of POINT_DATA nor of CELL_DATA",
       head + points + "SCALARS a int\n1 2 3\n"},
      {"things (line 7): is an unknown keyword", head + points + "THINGS 1\n"},
      {"field (line 9): has an array of strings",
       binary + "POINT_DATA 0\nFIELD f 1\n\n\nnames 1 1 string\n"},
  };
  for (const auto& [expected, text] : faults) {
    const std::string message = soup_error("a.vtk", text);
    INFO(message << "\nexpected " << expected);
    CHECK(message.find(expected) == 0);
  }
  Writer file(false, true, "POLYDATA");
  file.line(
      "POINTS 3 double\n0 0 0 1 0 0 0 1 0\nPOLYGONS 2 3\nOFFSETS vtktypeint64\n0 4\n"
      "CONNECTIVITY vtktypeint64\n0 1 2\n");
  CHECK(soup_error("a.vtk", file.bytes).starts_with("polygons 0: its offsets are wrong"));
}
