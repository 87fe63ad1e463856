// SPDX-License-Identifier: GPL-3.0-or-later
// STL, text or binary. Corners that are exactly equal become one point, in order of first
// appearance: the format has no other way to say that facets meet.
#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "io/formats/binary.hpp"
#include "io/formats/files.hpp"
#include "io/formats/readers.hpp"
#include "io/formats/text_scan.hpp"

namespace crest::io {
namespace {

constexpr std::size_t kHeader = 84, kFacet = 50;

/// The points of a soup by their coordinates: a hash table of numbers of points, open addressing.
class Corners {
 public:
  explicit Corners(std::vector<kernel::Vec3>& points) : points_(points), slots_(1024, kFree) {}

  /// The number of the point, which is new or equal to one before (-0 is 0). Not for NaN.
  Cells::Node add(const kernel::Vec3& point) {
    std::size_t at = slot(point);
    for (; slots_[at] != kFree; at = (at + 1) & (slots_.size() - 1))
      if (points_[slots_[at]] == point) return static_cast<Cells::Node>(slots_[at]);
    slots_[at] = points_.size();
    points_.push_back(point);
    if (2 * points_.size() > slots_.size()) grow();
    return static_cast<Cells::Node>(points_.size() - 1);
  }

 private:
  static constexpr std::size_t kFree = ~std::size_t{0};

  std::size_t slot(const kernel::Vec3& point) const {
    std::uint64_t hash = 0;
    for (const double x : point) {
      hash ^= std::bit_cast<std::uint64_t>(x + 0.0);  // of -0: 0
      hash *= 0x9e3779b97f4a7c15;
      hash ^= hash >> 32;
    }
    return hash & (slots_.size() - 1);
  }

  void grow() {
    slots_.assign(4 * slots_.size(), kFree);
    for (std::size_t v = 0; v < points_.size(); ++v) {
      std::size_t at = slot(points_[v]);
      while (slots_[at] != kFree) at = (at + 1) & (slots_.size() - 1);
      slots_[at] = v;
    }
  }

  std::vector<kernel::Vec3>& points_;
  std::vector<std::size_t> slots_;
};

bool is_finite(const kernel::Vec3& p) {
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

Soup read_binary(std::string_view bytes, std::size_t facets) {
  Soup soup;
  Corners corners(soup.points);
  soup.cells.reserve(facets, 3 * facets);
  for (std::size_t f = 0; f < facets; ++f) {
    const char* at = bytes.data() + kHeader + f * kFacet + 12;
    std::array<Cells::Node, 3> facet;
    for (std::size_t k = 0; k < 3; ++k) {
      kernel::Vec3 point;
      for (double& x : point) {
        x = static_cast<double>(load_number<float>(at, false));
        at += 4;
      }
      if (!is_finite(point)) {
        fail(fmt::format("face {}", f),
             fmt::format("a coordinate of its corner {} is not finite", k),
             "remove or repair the face");
      }
      facet[k] = corners.add(point);
    }
    soup.cells.add(CellType::triangle, facet);
  }
  return soup;
}

/// Keywords in any case, lines broken anywhere, any number of solids.
class TextStl {
 public:
  explicit TextStl(std::string_view text) : scan_(text) {
    // A facet has at least "facet vertex 0 0 0" with two more vertices and "endfacet".
    soup_.cells.reserve(text.size() / 200, 3 * (text.size() / 200));
  }

  Soup read() {
    bool solid = false;  // open
    while (scan_.more()) {
      const std::string_view word = take_keyword();
      if (is_keyword(word, "vertex")) {
        read_vertex();
      } else if (is_keyword(word, "facet")) {
        if (open_) fail(face(), "is not closed", "end it with 'endfacet'");
        open_ = true;
        corners_.clear();
      } else if (is_keyword(word, "endfacet")) {
        end_facet();
      } else if (is_keyword(word, "solid") || is_keyword(word, "endsolid")) {
        solid = is_keyword(word, "solid");
        scan_.next_line();  // a name may hold any word
      }
    }
    if (open_) fail(face(), "the file ends in it", "the file is truncated; export the mesh again");
    if (solid) soup_.warnings.emplace_back("the file ends without 'endsolid'");
    return std::move(soup_);
  }

 private:
  std::string face() const { return numbered("face", soup_.cells.size(), scan_.line()); }

  /// "end facet" is "endfacet".
  std::string_view take_keyword() {
    const std::string_view word = scan_.word();
    if (!is_keyword(word, "end") || !scan_.in_line()) return word;
    const std::string_view next = scan_.word();
    return is_keyword(next, "facet") ? "endfacet" : is_keyword(next, "solid") ? "endsolid" : word;
  }

  void read_vertex() {
    if (!open_) fail(face(), "has a vertex outside of a facet", "correct the file");
    kernel::Vec3 point{};
    for (std::size_t k = 0; k < 3; ++k) {
      if (!scan_.more() || !scan_.take(point[k]))
        fail(face(), fmt::format("coordinate {} is not a number", quoted(scan_.peek())),
             "give x y z");
    }
    if (!is_finite(point)) {
      fail(face(), fmt::format("a coordinate of its corner {} is not finite", corners_.size()),
           "remove or repair the face");
    }
    corners_.push_back(points_.add(point));
  }

  void end_facet() {
    if (!open_) fail(face(), "has 'endfacet' without 'facet'", "correct the file");
    open_ = false;
    soup_.cells.add(face_type(corners_.size()), corners_);
  }

  TextScan scan_;
  Soup soup_;
  Corners points_{soup_.points};
  bool open_ = false;
  std::vector<Cells::Node> corners_;
};

/// A text starts with a keyword and has no zero byte, which every header of a binary file with
/// fewer than 2^24 facets has.
bool is_text(std::string_view bytes) {
  TextScan scan(bytes);
  if (!scan.more()) return false;
  const std::string_view word = scan.peek(8);
  return (is_keyword(word, "solid") || is_keyword(word, "facet")) && bytes.find('\0') == bytes.npos;
}

}  // namespace

Soup read_stl(std::string bytes, const FieldRequest&) {
  if (is_text(bytes)) return TextStl(bytes).read();
  if (bytes.size() < kHeader) fail("file", "is too short for STL", "export the mesh again");
  const std::size_t facets = load_number<std::uint32_t>(bytes.data() + 80, false);
  const std::size_t whole = (bytes.size() - kHeader) / kFacet;
  if (whole >= facets) return read_binary(bytes, facets);
  if (is_keyword(std::string_view(bytes).substr(0, 5), "solid")) check_text(bytes);
  fail(fmt::format("face {}", whole),
       fmt::format("is missing or cut, the header announces {} faces", facets),
       "the file is truncated; export the mesh again");
}

}  // namespace crest::io
