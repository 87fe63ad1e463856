// SPDX-License-Identifier: GPL-3.0-or-later
// Medit's text formats: keywords, each with a number of entries; the last number of an entry is a
// reference, which is left out. Words may stand on any line.
#include <fmt/format.h>

#include <map>

#include "io/formats/files.hpp"
#include "io/formats/remedy.hpp"
#include "io/formats/solid_readers.hpp"
#include "io/formats/text_scan.hpp"

namespace crest::io {
namespace {

class Source {
 public:
  explicit Source(std::string_view bytes) : scan_(check_text(bytes), '#') {}

  /// Takes the next keyword; false at the end.
  bool next() {
    if (!scan_.more()) return false;
    keyword_ = std::string(scan_.peek(60));
    line_ = scan_.line();
    scan_.skip_word();
    return keyword_ != "End";
  }
  const std::string& keyword() const { return keyword_; }
  std::string where() const { return fmt::format("{} (line {})", keyword_, line_); }

  std::int64_t integer() {
    std::int64_t x = 0;
    require_word();
    if (!scan_.take(x)) refuse("an integer");
    return x;
  }
  double real() {
    double x = 0;
    require_word();
    if (!scan_.take(x)) refuse("a number");
    return x;
  }
  /// A count of entries of so many words each, which the bytes must have room for.
  std::size_t count(std::size_t words) {
    const std::int64_t n = integer();
    if (n < 0 || static_cast<std::uint64_t>(n) > scan_.room() / (2 * words) + 1)
      fail(where(), fmt::format("announces {} entries, more than the file holds", n), kExportMesh);
    return static_cast<std::size_t>(n);
  }
  std::size_t line() const { return scan_.line(); }

 private:
  void require_word() {
    if (!scan_.more()) fail(where(), "ends early", kExportMesh);
  }
  [[noreturn]] void refuse(const char* what) {
    fail(fmt::format("{}, line {}", keyword_, scan_.line()),
         fmt::format("{} is not {}", quoted(scan_.peek()), what), kExportMesh);
  }

  TextScan scan_;
  std::string keyword_;
  std::size_t line_ = 0;
};

void require_three_dimensions(Source& source) {
  const std::int64_t dimension = source.integer();
  if (dimension != 3)
    fail(source.where(), fmt::format("is {}", dimension), "give a mesh of dimension 3");
}

}  // namespace

Soup read_medit(std::string_view bytes) {
  struct List {
    CellType type;
    std::size_t corners;
  };
  static const std::map<std::string, List> lists = {
      {"Edges", {CellType::line, 2}},          {"Triangles", {CellType::triangle, 3}},
      {"Quadrilaterals", {CellType::quad, 4}}, {"Tetrahedra", {CellType::tetrahedron, 4}},
      {"Pyramids", {CellType::pyramid, 5}},    {"Prisms", {CellType::wedge, 6}},
      {"Hexahedra", {CellType::hexahedron, 8}}};
  // Words of the entries of what is passed over.
  static const std::map<std::string, std::size_t> others = {
      {"Corners", 1},           {"RequiredVertices", 1},        {"Ridges", 1},
      {"RequiredEdges", 1},     {"RequiredTriangles", 1},       {"RequiredTetrahedra", 1},
      {"Normals", 3},           {"NormalAtVertices", 2},        {"Tangents", 3},
      {"TangentAtVertices", 2}, {"NormalAtTriangleVertices", 3}};
  Source source(bytes);
  Soup soup;
  if (!source.next() || source.keyword() != "MeshVersionFormatted")
    fail("header", "has no MeshVersionFormatted",
         "is it a text mesh of Medit? " + std::string(kExportMesh));
  source.integer();
  while (source.next()) {
    if (source.keyword() == "Dimension") {
      require_three_dimensions(source);
    } else if (source.keyword() == "Vertices") {
      soup.points.resize(source.count(4));
      for (std::size_t v = 0; v < soup.points.size(); ++v) {
        for (double& x : soup.points[v]) x = source.real();
        source.integer();
        soup.point_tags.push_back(static_cast<std::int64_t>(v) + 1);
      }
    } else if (const auto list = lists.find(source.keyword()); list != lists.end()) {
      const auto [type, corners] = list->second;
      const std::size_t count = source.count(corners + 1);
      std::vector<Cells::Node> nodes(corners);
      for (std::size_t c = 0; c < count; ++c) {
        for (Cells::Node& node : nodes) node = source.integer() - 1;
        source.integer();
        soup.cells.add(type, nodes);
        soup.cell_tags.push_back(static_cast<std::int64_t>(c) + 1);
      }
    } else if (const auto other = others.find(source.keyword()); other != others.end()) {
      const std::size_t count = source.count(other->second);
      for (std::size_t i = 0; i < other->second * count; ++i) source.real();
    } else {
      fail(source.where(), "is an unknown keyword", kExportMesh);
    }
  }
  return soup;
}

void read_medit_solution(std::string_view bytes, Soup& soup) {
  // Medit's symmetric tensors: xx xy yy xz yz zz.
  constexpr std::size_t place[6] = {0, 3, 1, 5, 4, 2};
  constexpr int components[4] = {0, 1, 3, 6};
  Source source(bytes);
  while (source.next()) {
    if (source.keyword() == "MeshVersionFormatted") {
      source.integer();
    } else if (source.keyword() == "Dimension") {
      require_three_dimensions(source);
    } else if (source.keyword() == "SolAtVertices") {
      const std::size_t points = source.count(1);
      if (points != soup.points.size())
        fail(source.where(),
             fmt::format("is about {} points, the mesh has {}", points, soup.points.size()),
             kExportMesh);
      const std::size_t fields = source.count(1);
      const std::size_t first = soup.point_fields.size();
      for (std::size_t f = 0; f < fields; ++f) {
        const std::int64_t type = source.integer();
        if (type < 1 || type > 3)
          fail(source.where(), fmt::format("has a field of the unknown type {}", type),
               kExportMesh);
        soup.point_fields.push_back(
            {.name = fmt::format("solution{}", f + 1), .components = components[type]});
      }
      std::vector<std::vector<double>> numbers(fields);
      for (std::size_t v = 0; v < points; ++v)
        for (std::size_t f = 0; f < fields; ++f) {
          const int n = soup.point_fields[first + f].components;
          std::array<double, 6> x{};
          for (int k = 0; k < n; ++k) {
            const auto i = static_cast<std::size_t>(k);
            x[n == 6 ? place[i] : i] = source.real();
          }
          numbers[f].insert(numbers[f].end(), x.begin(), x.begin() + n);
        }
      for (std::size_t f = 0; f < fields; ++f)
        soup.point_fields[first + f].numbers = std::move(numbers[f]);
    } else {
      fail(source.where(), "is not read", "give the solution at vertices as text");
    }
  }
}

}  // namespace crest::io
