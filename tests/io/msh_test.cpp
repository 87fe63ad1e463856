// SPDX-License-Identifier: GPL-3.0-or-later
// Gmsh files, text and binary.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/io/bytes.hpp"
#include "tests/io/soups.hpp"

namespace {

using namespace crest::io;
using namespace crest::tests;
using Nodes = std::vector<Cells::Node>;

enum class Storage { text, little, big };

/// Numbers of a section, in a text with blanks between them.
class Writer {
 public:
  Writer(Storage storage, bool four) : storage_(storage), four_(four) {
    line("$MeshFormat");
    line(std::string(four ? "4.1 " : "2.2 ") + (storage == Storage::text ? "0 8" : "1 8"));
    if (storage != Storage::text) {
      put(bytes, 1, storage == Storage::big);
      bytes += "\n";
    }
    line("$EndMeshFormat\n$PhysicalNames\n1\n2 5 \"skin\"\n$EndPhysicalNames");
  }
  void line(const std::string& text) { bytes += text + "\n"; }
  void integer(int x) { number(x, std::to_string(x)); }
  /// Eight bytes in version 4.1.
  void size(std::int64_t x) { number(x, std::to_string(x)); }
  void real(double x) {
    std::ostringstream text;
    text.precision(17);
    text << x;
    number(x, text.str());
  }
  void end() {
    if (storage_ == Storage::text) bytes += "\n";
  }
  bool text() const { return storage_ == Storage::text; }

  void nodes(const std::vector<std::array<double, 3>>& points, bool parametric = false) {
    line("$Nodes");
    const auto count = static_cast<std::int64_t>(points.size());
    if (!four_) {
      line(std::to_string(count));
      for (std::size_t i = 0; i < points.size(); ++i) {
        integer(tag(i));
        for (const double x : points[i]) real(x);
        end();
      }
    } else {
      for (const std::int64_t x : {std::int64_t{1}, count, std::int64_t{1}, count}) size(x);
      end();
      for (const int x : {2, 1, parametric ? 1 : 0}) integer(x);
      size(count);
      end();
      for (std::size_t i = 0; i < points.size(); ++i) {
        size(tag(i));
        end();
      }
      for (const auto& point : points) {
        for (const double x : point) real(x);
        for (int k = 0; k < 2 && parametric; ++k) real(0.25);
        end();
      }
    }
    line("\n$EndNodes");
  }

  /// Each a block of its own: type, tag, positions of nodes.
  void element(int type, int tag_of_it, const std::vector<int>& positions) {
    if (!four_) {
      if (text())
        for (const int x : {tag_of_it, type, 2, 5, 1}) integer(x);
      else
        for (const int x : {type, 1, 2, tag_of_it, 5, 1}) integer(x);
    } else {
      for (const int x : {2, 1, type}) integer(x);
      size(1);
      end();
      size(tag_of_it);
    }
    for (const int position : positions) {
      const int node = tag(static_cast<std::size_t>(position));
      four_ ? size(node) : integer(node);
    }
    end();
  }
  void begin_elements(std::int64_t count) {
    line("$Elements");
    if (!four_) return line(std::to_string(count));
    for (const std::int64_t x : {count, count, std::int64_t{1}, count}) size(x);
    end();
  }

  void data(const char* section, const std::string& name, int step, int components,
            const std::vector<std::pair<int, std::vector<double>>>& values) {
    line(std::string("$") + section + "\n1\n\"" + name + "\"\n1\n0.5\n3\n" + std::to_string(step) +
         "\n" + std::to_string(components) + "\n" + std::to_string(values.size()));
    for (const auto& [t, numbers] : values) {
      integer(t);
      for (const double x : numbers) real(x);
      end();
    }
    line(std::string("\n$End") + section);
  }
  static int tag(std::size_t i) { return 10 + 3 * static_cast<int>(i); }
  std::string bytes;

 private:
  template <class T>
  void number(T x, const std::string& word) {
    if (text())
      bytes += word + " ";
    else if (sizeof x == 8 && std::is_integral_v<T> && !four_)
      put(bytes, static_cast<int>(x), storage_ == Storage::big);
    else
      put(bytes, x, storage_ == Storage::big);
  }
  Storage storage_;
  bool four_;
};

const std::vector<std::array<double, 3>> kPoints = {{0, 0, 0},   {1, 0, 0}, {0, 1, 0},
                                                    {0, 0, 0.1}, {1, 1, 0}, {2, 0, 0}};

template <class Check>
void for_all_forms(const Check& check) {
  for (const Storage storage : {Storage::text, Storage::little, Storage::big}) {
    for (const bool four : {false, true}) {
      INFO((storage == Storage::text ? "text " : "binary ") << (four ? "4.1" : "2.2"));
      Writer file(storage, four);
      check(file);
    }
  }
}

}  // namespace

TEST_CASE("Gmsh elements of every kind are kept with their tags", "[io]") {
  for (const bool parametric : {false, true}) {
    for_all_forms([&](Writer& file) {
      file.nodes(kPoints, parametric);
      file.begin_elements(6);
      file.element(2, 3, {0, 2, 1});
      file.element(15, 4, {0});
      file.element(1, 5, {0, 1});
      file.element(4, 6, {0, 1, 2, 3});
      file.element(3, 7, {0, 1, 4, 2});
      file.element(9, 8, {0, 1, 2, 3, 4, 5});
      file.line("\n$EndElements");
      const Soup soup = soup_of("a.msh", file.bytes);
      CHECK(counts(soup) ==
            "6 points, 1 of type 1, 1 of type 3, 1 of type 5, 1 of type 9, 1 of type 10, 1 of type "
            "22");
      CHECK(soup.points[3][2] == 0.1);
      CHECK(soup.point_tag(2) == 16);
      CHECK(soup.cell_tag(4) == 7);
      CHECK(nodes_of(soup, 4) == Nodes{0, 1, 4, 2});
      CHECK(soup.warnings.empty());
    });
  }
}

TEST_CASE("Gmsh fields are of nodes or elements, of any number of components", "[io]") {
  for_all_forms([](Writer& file) {
    file.nodes(kPoints);
    file.begin_elements(2);
    file.element(2, 7, {0, 2, 1});
    file.element(2, 9, {1, 2, 4});
    file.line("\n$EndElements");
    file.data("NodeData", "T", 0, 1, {{10, {1.5}}, {13, {2}}, {16, {3}}, {25, {-0.1}}});
    file.data("NodeData", "v", 0, 3, {{13, {1, 2, 3}}});
    file.data("ElementData", "p", 0, 1, {{9, {8}}, {7, {6}}});
    const Soup soup = soup_of("a.msh", file.bytes, {true, ""});
    CHECK(field_names(soup) == "T 1, v 3; cells: p 1");
    CHECK(numbers_of<double>(soup.point_fields, "T") == std::vector<double>{1.5, 2, 3, 0, 0, -0.1});
    CHECK(soup.point_fields[0].missing ==
          std::vector<bool>{false, false, false, true, true, false});
    CHECK(numbers_of<double>(soup.point_fields, "v")[5] == 3);
    CHECK(numbers_of<double>(soup.cell_fields, "p") == std::vector<double>{6, 8});
    CHECK(soup.cell_fields[0].missing.empty());
    const Soup one = soup_of("a.msh", file.bytes, {true, "p"});
    CHECK(field_names(one) == "T 1, v 3; cells: p 1");
    CHECK(one.point_fields[0].size() == 0);
  });
}

TEST_CASE("one time step of a Gmsh field is taken, by default the last", "[io]") {
  for_all_forms([](Writer& file) {
    file.nodes(kPoints);
    for (const int step : {2, 5, 3}) file.data("NodeData", "u", step, 1, {{10, {step + 0.5}}});
    file.data("NodeData", "w", 2, 1, {{10, {7}}});
    const auto first = [&](const char* name, const FieldRequest& request) {
      const auto numbers =
          numbers_of<double>(soup_of("a.msh", file.bytes, request).point_fields, name);
      return numbers.empty() ? -1 : numbers[0];
    };
    CHECK(first("u", {true, "u"}) == 5.5);
    CHECK(first("w", {true, "w"}) == 7);
    for (const int step : {2, 3, 5})
      CHECK(first("u", {.wanted = true, .name = "u", .step = step}) == step + 0.5);
    CHECK(first("w", {.wanted = true, .step = 3}) == -1);
    CHECK(soup_error("a.msh", file.bytes, {.wanted = true, .name = "u", .step = 4}) ==
          "time step 4: is not there; the file has 2, 3, 5");
    CHECK(soup_of("a.msh", file.bytes, {true, ""}).warnings ==
          std::vector<std::string>{
              "took time step 5 of field 'u', its last; --step chooses another of 2, 3, 5"});
    CHECK(soup_of("a.msh", file.bytes, {true, "w"}).warnings.empty());
    CHECK(soup_of("a.msh", file.bytes).warnings.empty());
  });
  for (const char* other : {"a.off", "a.obj", "a.ply", "a.stl", "a.vtp", "a.vtu", "a.vtk"})
    CHECK(soup_error(other, "x", {.wanted = true, .step = 1}).starts_with("time step: "));
}

TEST_CASE("faults of Gmsh files are named in the file's numbers", "[io]") {
  const std::string head = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
  const std::string nodes = "$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n$EndNodes\n";
  const auto elements = [&](const std::string& line) {
    return head + nodes + "$Elements\n1\n" + line + "\n$EndElements\n";
  };
  const std::pair<const char*, std::string> faults[] = {
      {"file: has no $MeshFormat; save it from Gmsh", "hello\n"},
      {"$NOD: is of Gmsh's format 1; save as 4.1", "$NOD\n1\n1 0 0 0\n$ENDNOD\n$ELM\n0\n$ENDELM\n"},
      {"$MeshFormat: is neither 2.2 nor 4.1", "$MeshFormat\n4 0 8\n$EndMeshFormat\n"},
      {"$MeshFormat: has numbers of another size", "$MeshFormat\n2.2 0 4\n$EndMeshFormat\n"},
      {"$MeshFormat: has no mark of the byte order",
       "$MeshFormat\n2.2 1 8\nabcd\n$EndMeshFormat\n"},
      {"line 5: 'nine' is not an integer", head + "$Nodes\nnine\n"},
      {"$Nodes: ends early (line 7)", head + "$Nodes\n99999999999\n1 0 0 0\n$EndNodes\n"},
      {"line 6: 'x' is not a number", head + "$Nodes\n1\n1 0 x 0\n$EndNodes\n"},
      {"node 2: is there twice", head + "$Nodes\n2\n2 0 0 0\n2 1 0 0\n$EndNodes\n"},
      {"$Elements: does not end; the file is truncated", head + nodes + "$Elements\n0\n"},
      {"element 7 (line 12): node 4 does not exist", elements("7 2 0 1 2 4")},
      {"element 7 (line 12): has the unknown type 77", elements("7 77 0 1 2 3")},
      {"element 7 (line 12): has 2 nodes instead of 3", elements("7 2 0 1 2")},
      {"element 7 (line 12): has more than 3 nodes", elements("7 2 0 1 2 3 1")},
      {"line 12: has a bad number of tags", elements("7 2 -1 1 2 3")},
  };
  for (const auto& [expected, text] : faults) {
    const std::string message = soup_error("a.msh", text);
    INFO(message << "\nexpected " << expected);
    CHECK(message.find(expected) == 0);
  }
  const std::string field = "$NodeData\n1\n\"T\"\n0\n3\n0\n1\n1\n9 1\n$EndNodeData\n";
  CHECK(soup_error("a.msh", head + nodes + field, {true, "T"})
            .starts_with("field 'T': node 9 does not exist"));
  const Soup bad = soup_of("a.msh", head + "$Nodes\n2\n1 0 0 0\n5 nan 0 0\n$EndNodes\n");
  CHECK(bad.point_name(1) == "vertex 5 (line 7)");
  for (const bool four : {false, true}) {
    Writer file(Storage::little, four);
    file.nodes(kPoints);
    file.begin_elements(1);
    file.element(2, 7, {0, 2, 1});
    file.bytes.resize(file.bytes.size() - 3);
    CHECK(soup_error("a.msh", file.bytes).starts_with("$Elements: ends early"));
  }
}
