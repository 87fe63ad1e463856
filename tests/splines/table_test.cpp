// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of numbers.
#include "io/splines/table.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>

#include "kernel/geometry/input_error.hpp"
#include "tests/support/random.hpp"
#include "tests/support/shared_data.hpp"

using namespace crest;
using namespace crest::tests;

namespace {

io::Table read(const std::string& text, const std::vector<std::string>& columns) {
  return io::read_table_bytes("table.csv", text, columns);
}

void refused(const std::string& text, const std::string& message) {
  try {
    read(text, {"x", "y", "z", "value"});
    FAIL("not refused: " << text);
  } catch (const kernel::InputError& error) {
    CHECK(error.what() == "table.csv: " + message);
  }
}

}  // namespace

TEST_CASE("columns are found by their names, whatever stands between and around them") {
  const std::vector<double> first{1, -2.5e-3}, second{2, 1e300};
  for (const char* text : {
           "a,b\n1,2\n-2.5e-3,1e300\n",
           "\xef\xbb\xbf"
           "a,b\r\n1,2\r\n-.0025,1e300",
           "b;a\n2;1\n1e+300;-2.5E-3\n",
           "a\tc\tb\n1\tred\t2\n\n-0.0025\t\t1e300\n",
           " \"a\" , \"c\",\"b\" \n 1 ,\"x,y\", +2\n -0.0025 ,, 1e300 \n",
       }) {
    CAPTURE(text);
    const io::Table t = read(text, {"a", "b"});
    CHECK(t.rows == 2);
    CHECK(t.columns[0] == first);
    CHECK(t.columns[1] == second);
  }
}

TEST_CASE("tables that are not what they should be are refused in one line") {
  refused("", "file: is empty; write a row of names and rows of numbers");
  refused("x,y,z,value\n", "rows: there are none; write numbers below the row of names");
  refused("1,2,3,4\n5,6,7,8\n",
          "row of names: there is none; write the columns' names into the first line");
  refused("x,y,value\n1,2,3\n",
          "column 'z': does not exist; the table has 'x', 'y', 'value'; samples of the plane are "
          "not fitted, give those of space");
  refused("x,y,z,v\n1,2,3,4\n",
          "column 'value': does not exist; the table has 'x', 'y', 'z', 'v'; name the columns as "
          "asked for, or choose with --columns");
  refused("x,x,y,z,value\n1,1,2,3,4\n",
          "column 'x': is there several times; give them different names");
  refused("x,y,z,value\n1,2,3,4\n\n1,2,3\n",
          "row 1 (line 4): its 'value' is missing, no finite number; correct it or leave the row "
          "out");
  for (const char* word : {"nan", "inf", "-Infinity", "1e400", "two", "1 2", "0x10", "1,5"}) {
    CAPTURE(word);
    CHECK_THROWS_AS(read(std::string("x;y;z;value\n1;2;") + word + ";4\n", {"x", "y", "z"}),
                    kernel::InputError);
  }
}

TEST_CASE("written tables read back as the same numbers") {
  Random random(kSeed);
  std::vector<double> a, b;
  for (int i = 0; i < 1000; ++i) {
    a.push_back(
        std::ldexp(static_cast<double>(random()) - 0x1p63, static_cast<int>(random() % 400) - 250));
    b.push_back(static_cast<double>(i) / 7);
  }
  const std::string path = std::string(CREST_BINARY_DIR) + "/table_test.csv";
  const std::array<std::span<const double>, 2> columns{a, b};
  io::write_table(path, {"a", "b"}, columns);
  const io::Table t = io::read_table(path, {"b", "a"});
  CHECK(t.columns[1] == a);
  CHECK(t.columns[0] == b);
  a[3] = std::nan("");
  io::write_table(path, {"a", "b"}, columns);
  std::ifstream stream(path);
  std::string line;
  for (int i = 0; i < 5; ++i) std::getline(stream, line);
  CHECK(line == "nan,0.42857142857142855");
  std::remove(path.c_str());
}

TEST_CASE("the scattered tables of space are read, those of the plane refused") {
  const auto gravity = shared_data("scattered/gravi_topography_3d.csv");
  if (!gravity) return;
  CHECK(io::read_table(*gravity, {"x", "y", "z", "value"}).rows > 2000);
  for (const char* name : {"volcano.csv", "st_helens_20k.csv", "meuse.csv", "walker_lake.csv"}) {
    const auto plane = shared_data(std::string("scattered/") + name);
    REQUIRE(plane);
    CHECK_THROWS_AS(io::read_table(*plane, {"x", "y", "z", "value"}), kernel::InputError);
  }
}
