// SPDX-License-Identifier: GPL-3.0-or-later
// Checks of OBJ and STL before CGAL reads them; OFF is read by its check.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "io/formats/files.hpp"
#include "io/formats/readers.hpp"
#include "io/formats/text_scan.hpp"

namespace crest::io {
namespace {

void blank(std::string& text, std::size_t begin, std::size_t length) {
  std::fill_n(text.begin() + static_cast<std::ptrdiff_t>(begin), length, ' ');
}

struct OffCounts {
  std::size_t vertices, faces;
};

/// Reads "[ST][C][N]OFF V F E", counts on the same line or the next.
OffCounts off_header(std::string_view text, LineScanner& scanner) {
  const std::string remedy = "start the file with 'OFF' and the line 'vertices faces edges'";
  if (!scanner.next('#')) fail("header", "is missing", remedy);
  std::string_view keyword = scanner.words()[0];
  for (const char* prefix : {"ST", "C", "N"})
    if (keyword.starts_with(prefix)) keyword.remove_prefix(std::strlen(prefix));
  if (keyword != "OFF") {
    const std::string problem =
        fmt::format("'{}' is not read", std::string(scanner.words()[0].substr(0, 20)));
    fail(fmt::format("header (line {})", scanner.number()), problem, remedy);
  }
  std::vector<std::string_view> counts(scanner.words().begin() + 1, scanner.words().end());
  if (!counts.empty() && counts[0] == "BINARY")
    fail("header", "binary OFF is not read", "convert the mesh to text or to PLY");
  if (counts.empty() && scanner.next('#')) counts = scanner.words();
  const std::string line = fmt::format("header (line {})", scanner.number());
  if (counts.size() < 3) fail(line, "has no three counts", remedy);
  std::int64_t value[2];
  for (std::size_t k = 0; k < 2; ++k) {
    const auto count = integer_of(counts[k]);
    if (!count || *count < 0) fail(line, "has a bad count", remedy);
    value[k] = *count;
  }
  if (!integer_of(counts[2])) fail(line, "has a bad count", remedy);
  // The shortest vertex is "0 0 0", the shortest face "3 0 0 0", each with a line end.
  const auto room = static_cast<std::int64_t>(text.size());
  if (value[0] > room / 6 + 1 || value[1] > room / 8 + 1) {
    fail(line,
         fmt::format("announces {} vertices and {} faces", value[0], value[1]) +
             ", more than the file holds",
         "the file is truncated or its header wrong; export the mesh again");
  }
  return {static_cast<std::size_t>(value[0]), static_cast<std::size_t>(value[1])};
}

template <class Name>
std::array<Cells::Node, 3> off_face(const std::vector<std::string_view>& words,
                                    std::size_t vertices, const Name& element) {
  const auto corners = integer_of(words[0]);
  if (!corners) fail(element(), "does not start with a number of vertices", "correct it");
  if (*corners != 3) check_corner_count(*corners, element());
  if (words.size() < 4) fail(element(), "has fewer indices than it announces", "correct it");
  std::array<Cells::Node, 3> face{};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto index = integer_of(words[k + 1]);
    if (!index) {
      fail(element(), "index '" + std::string(words[k + 1].substr(0, 40)) + "' is not an integer",
           "correct it");
    }
    if (*index < 0 || *index >= static_cast<std::int64_t>(vertices)) {
      fail(element(), fmt::format("vertex {} does not exist", *index),
           fmt::format("the file has {} vertices, numbered from 0", vertices));
    }
    face[k] = *index;
  }
  return face;
}

[[noreturn]] void fail_truncated(const char* what, std::size_t index) {
  fail(fmt::format("{} {}", what, index), "is missing, the file ends before it",
       "the file is truncated; export the mesh again");
}

}  // namespace

Soup parse_off(std::string_view text) {
  check_text(text);
  LineScanner scanner(text);
  const OffCounts counts = off_header(text, scanner);
  Soup soup;
  soup.points.reserve(counts.vertices);
  soup.cells.reserve(counts.faces, 3 * counts.faces);
  for (std::size_t v = 0; v < counts.vertices; ++v) {
    if (!scanner.next('#')) fail_truncated("vertex", v);
    soup.points.push_back(
        coordinates(scanner.words(), 0, [&] { return numbered("vertex", v, scanner.number()); }));
  }
  for (std::size_t f = 0; f < counts.faces; ++f) {
    if (!scanner.next('#')) fail_truncated("face", f);
    soup.cells.add(CellType::triangle, off_face(scanner.words(), counts.vertices, [&] {
                     return numbered("face", f, scanner.number());
                   }));
  }
  return soup;
}

namespace {

/// Counts corners up to a comment; each starts with an index that fits 32 bits.
template <class Name>
void check_obj_face(const std::vector<std::string_view>& words, std::size_t vertices,
                    const Name& element) {
  std::int64_t corners = 0;
  for (std::size_t k = 1; k < words.size() && words[k][0] != '#'; ++k, ++corners) {
    const std::string_view word = words[k].substr(0, words[k].find('/'));
    const auto index = integer_of(word);
    if (!index) {
      fail(element(), "index '" + std::string(words[k].substr(0, 40)) + "' is not an integer",
           "correct it");
    }
    if (*index == 0) fail(element(), "index 0 does not exist", "OBJ counts from 1");
    const auto limit = static_cast<std::int64_t>(vertices);
    if (*index > 0x7fffffff || *index < -limit)
      fail(element(), fmt::format("index {} is out of range", *index), "correct it");
  }
  if (corners != 3) check_corner_count(corners, element());
}

}  // namespace

void check_obj(std::string& text) {
  check_text(text);
  // CGAL separates corners at blanks only and does not know continued lines.
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\t' || text[i] == '\r' || text[i] == '\v' || text[i] == '\f') text[i] = ' ';
    if (text[i] == '\\' && i + 1 < text.size() && (text[i + 1] == '\n' || text[i + 1] == '\r'))
      blank(text, i, text[i + 1] == '\r' && i + 2 < text.size() && text[i + 2] == '\n' ? 3 : 2);
  }
  LineScanner scanner(text);
  std::size_t vertices = 0, faces = 0;
  while (scanner.next()) {
    const auto& words = scanner.words();
    if (words[0] == "v") {
      coordinates(words, 1, [&] { return numbered("vertex", vertices, scanner.number()); });
      ++vertices;
    } else if (words[0] == "f") {
      check_obj_face(words, vertices, [&] { return numbered("face", faces, scanner.number()); });
      ++faces;
    } else {
      blank(text, scanner.offset(), scanner.line().size());
    }
  }
}

namespace {

constexpr std::size_t kStlHeader = 84, kStlFacet = 50;

void check_binary_stl(std::string& bytes, std::size_t facets) {
  bytes[0] = '\0';  // a header may start with "solid"; CGAL would take the file for a text
  for (std::size_t f = 0; f < facets; ++f) {
    float corner[9];
    std::memcpy(corner, bytes.data() + kStlHeader + f * kStlFacet + 12, sizeof corner);
    for (std::size_t k = 0; k < 9; ++k) {
      if (!std::isfinite(corner[k])) {
        fail(fmt::format("face {}", f),
             fmt::format("a coordinate of its corner {} is not finite", k / 3),
             "remove or repair the face");
      }
    }
  }
}

void check_text_stl(std::string& text) {
  check_text(text);
  LineScanner scanner(text);
  std::size_t faces = 0, corners = 0;
  bool open = false, solid = false;
  while (scanner.next()) {
    const auto& words = scanner.words();
    const auto face = [&] { return numbered("face", faces, scanner.number()); };
    if (words[0] == "solid" || words[0] == "endsolid") {
      // A solid's name may hold any word, keywords too.
      solid = words[0] == "solid";
      const std::size_t at = static_cast<std::size_t>(words[0].data() - text.data());
      const std::size_t end = scanner.offset() + scanner.line().size();
      blank(text, at + words[0].size(), end - at - words[0].size());
    } else if (words[0] == "facet") {
      if (open) fail(face(), "is not closed", "end it with 'endfacet'");
      open = true;
      corners = 0;
      blank(text, scanner.offset(), scanner.line().size());
      text.replace(scanner.offset(), 5, "facet");
    } else if (words[0] == "vertex") {
      if (!open) fail(face(), "vertex outside of a facet", "correct the file");
      coordinates(words, 1, face);
      ++corners;
    } else if (words[0] == "endfacet") {
      if (!open) fail(face(), "'endfacet' without 'facet'", "correct the file");
      if (corners != 3) check_corner_count(static_cast<std::int64_t>(corners), face());
      open = false;
      ++faces;
    }
  }
  if (open || solid) {
    fail(fmt::format("face {}", faces), "the file ends before 'endsolid'",
         "the file is truncated; export the mesh again");
  }
}

}  // namespace

void check_stl(std::string& bytes) {
  std::size_t facets = 0;
  const bool has_count = bytes.size() >= kStlHeader;
  if (has_count) {
    std::uint32_t count;
    std::memcpy(&count, bytes.data() + 80, sizeof count);
    facets = count;
  }
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  const bool solid = first != std::string::npos && bytes.compare(first, 5, "solid") == 0;
  const std::size_t expected = kStlHeader + facets * kStlFacet;
  if (has_count && (bytes.size() == expected || (!solid && bytes.size() > expected)))
    return check_binary_stl(bytes, facets);
  if (solid) return check_text_stl(bytes);
  if (!has_count) fail("file", "is too short for STL", "export the mesh again");
  const std::size_t whole = (bytes.size() - kStlHeader) / kStlFacet;
  fail(fmt::format("face {}", whole),
       fmt::format("is missing or cut, the header announces {} faces", facets),
       "the file is truncated; export the mesh again");
}

}  // namespace crest::io
