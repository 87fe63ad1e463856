// SPDX-License-Identifier: GPL-3.0-or-later
// STL, text and binary.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/io/bytes.hpp"
#include "tests/io/soups.hpp"

namespace {

using namespace crest::io;
using namespace crest::tests;
using Nodes = std::vector<Cells::Node>;

std::string facet(const std::string& a, const std::string& b, const std::string& c) {
  return "facet normal 0 0 1\n outer loop\n  vertex " + a + "\n  vertex " + b + "\n  vertex " + c +
         "\n endloop\nendfacet\n";
}
const std::string kTwo = facet("0 0 0", "1 0 0", "0 1 0") + facet("1 0 0", "0 1 0", "1 1 0");

std::string binary(const std::string& head, const std::vector<std::array<float, 9>>& facets,
                   std::uint32_t announced) {
  std::string bytes = head;
  bytes.resize(80, ' ');
  put(bytes, announced);
  for (const auto& corners : facets) {
    for (int k = 0; k < 3; ++k) put(bytes, 0.f);
    for (const float x : corners) put(bytes, x);
    put(bytes, std::uint16_t{0});
  }
  return bytes;
}
const std::vector<std::array<float, 9>> kFacets = {{0, 0, 0, 1, 0, 0, 0, 1, 0},
                                                   {1, 0, 0, 0, 1, 0, 1, 1, 0}};

std::string upper(std::string text) {
  for (char& c : text)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return text;
}

std::string with_blanks(std::string text, const std::string& blank) {
  std::string result;
  for (const char c : text) c == '\n' ? result += blank : result += c;
  return result;
}

}  // namespace

TEST_CASE("spellings of one STL file give one soup", "[io]") {
  const std::string texts[] = {
      "solid a\n" + kTwo + "endsolid a\n",
      "solid\n" + kTwo + "end solid\n",
      upper("solid a\n" + kTwo + "endsolid a\n"),
      "  Solid facet solid vertex\n" + kTwo + "EndSolid solid\n",
      "solid a\n" + kTwo.substr(0, kTwo.size() / 2) + "endsolid\nsolid b\n" +
          kTwo.substr(kTwo.size() / 2) + "endsolid",
      with_blanks("solid a\n" + kTwo + "endsolid a\n", "\r\n"),
      with_blanks("solid a\n" + kTwo + "endsolid a\n", "\r"),
      "solid a\n" + with_blanks(kTwo, " ") + "\nendsolid a\n",  // on one line
      "\xef\xbb\xbfsolid a\n" + kTwo + "endsolid a\n",
      kTwo,  // no solid around them
      "solid a\n" + with_blanks(kTwo, "\n\n") + "endsolid",
      binary("made for a test", kFacets, 2),
      binary("solid x", kFacets, 2),
      binary("solid x", kFacets, 2) + "trailing bytes",
  };
  for (const std::string& text : texts) {
    INFO(text);
    const Soup soup = soup_of("a.stl", text);
    CHECK(counts(soup) == "4 points, 2 of type 5");
    CHECK(nodes_of(soup, 0) == Nodes{0, 1, 2});
    CHECK(nodes_of(soup, 1) == Nodes{1, 2, 3});
    CHECK(soup.warnings.empty());
  }
  const Soup open = soup_of("a.stl", "solid a\n" + kTwo);
  CHECK(counts(open) == "4 points, 2 of type 5");
  CHECK(open.warnings == std::vector<std::string>{"the file ends without 'endsolid'"});
}

TEST_CASE("corners of STL are merged where they are equal, zero facets kept", "[io]") {
  const Soup soup =
      soup_of("a.stl", "solid\n" + facet("0 0 -0", "1 0 0", "1.0 0e5 0") +
                           facet("-0.0 0 0", "1 0 0", "1.0000000000000002 0 0") + "endsolid\n");
  CHECK(counts(soup) == "3 points, 2 of type 5");
  CHECK(nodes_of(soup, 0) == Nodes{0, 1, 1});
  CHECK(nodes_of(soup, 1) == Nodes{0, 1, 2});
  // Many points, so that the table of points grows.
  std::vector<std::array<float, 9>> facets;
  for (int i = 0; i < 5000; ++i) {
    const auto x = static_cast<float>(i);
    facets.push_back({x, 0, 0, x + 1, 0, 0, x, 1, 0});
  }
  const Soup strip = soup_of("a.stl", binary("", facets, 5000));
  CHECK(counts(strip) == "10001 points, 5000 of type 5");
  CHECK(nodes_of(strip, 4999) == Nodes{9997, 9999, 10000});
}

TEST_CASE("faults of STL files are named with their facet", "[io]") {
  auto nan = kFacets;
  nan[1][7] = std::nanf("");
  const std::pair<const char*, std::string> faults[] = {
      {"file: is too short for STL", "abc"},
      {"face 2: is missing or cut, the header announces 3 faces", binary("", kFacets, 3)},
      {"face 1: a coordinate of its corner 2 is not finite", binary("", nan, 2)},
      {"face 0 (line 5): a coordinate of its corner 1 is not finite",
       "solid\n" + facet("0 0 0", "inf 0 0", "0 1 0")},
      {"face 0 (line 4): coordinate 'x' is not a number", "solid\n" + facet("0 0 x", "1 0 0", "")},
      {"face 1 (line 15): the file ends in it", "solid\n" + kTwo.substr(0, kTwo.size() - 9)},
      {"face 0 (line 2): has a vertex outside of a facet", "solid\nvertex 0 0 0\n"},
      {"face 0 (line 2): has 'endfacet' without 'facet'", "solid\nendfacet\n"},
      {"face 0 (line 3): is not closed", "solid\nfacet\nfacet\n"},
  };
  for (const auto& [expected, text] : faults) {
    const std::string message = soup_error("a.stl", text);
    INFO(message << "\nexpected " << expected);
    CHECK(message.find(expected) == 0);
  }
  const std::string zero = "solid\n" + kTwo + std::string(1, '\0') + kTwo;
  CHECK(soup_error("a.stl", zero).find("is zero in a text format") != std::string::npos);
  CHECK(
      counts(soup_of("a.stl", "solid\nfacet\nvertex 0 0 0\nvertex 1 0 0\nendfacet\nendsolid\n")) ==
      "2 points, 1 of type 7");
}
