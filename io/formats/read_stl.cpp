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
/// Corners are added in batches, so that their slots and points come from memory side by side.
class Corners {
 public:
  /// Room for as many facets; most surfaces have half as many points.
  Corners(Soup& soup, std::size_t facets)
      : soup_(soup), slots_(std::bit_ceil(1024 + facets + facets / 4), kFree) {
    soup.cells.reserve(facets, 3 * facets);
    soup.points.reserve(facets / 2);
  }

  /// A facet. Adds what is pending, now and then.
  void add_facet(std::span<const kernel::Vec3> corners) {
    pending_.insert(pending_.end(), corners.begin(), corners.end());
    sizes_.push_back(corners.size());
    if (pending_.size() >= kBatch) flush();
  }
  std::size_t facets() const { return soup_.cells.size() + sizes_.size(); }

  /// Each corner becomes a new point or an equal one before it (-0 is 0; not for NaN).
  void flush() {
    while (2 * (soup_.points.size() + pending_.size()) > slots_.size()) grow();
    hashes_.clear();
    for (const kernel::Vec3& p : pending_) {
      hashes_.push_back(hash(p));
      __builtin_prefetch(&slots_[hashes_.back() & mask()]);
    }
    for (const std::uint64_t h : hashes_) {
      const std::uint32_t v = slots_[h & mask()];
      if (v != kFree) __builtin_prefetch(&soup_.points[v]);
    }
    nodes_.clear();
    for (std::size_t i = 0; i < pending_.size(); ++i) nodes_.push_back(number(i));
    const Cells::Node* node = nodes_.data();
    for (const std::size_t size : sizes_) {
      soup_.cells.add(face_type(size), {node, size});
      node += size;
    }
    pending_.clear();
    sizes_.clear();
  }

 private:
  static constexpr std::uint32_t kFree = ~std::uint32_t{0};
  static constexpr std::size_t kBatch = 96;

  static std::uint64_t hash(const kernel::Vec3& point) {
    std::uint64_t hash = 0;
    for (const double x : point) {
      hash ^= std::bit_cast<std::uint64_t>(x + 0.0);  // of -0: 0
      hash *= 0x9e3779b97f4a7c15;
      hash ^= hash >> 32;
    }
    return hash;
  }
  std::size_t mask() const { return slots_.size() - 1; }

  Cells::Node number(std::size_t i) {
    std::vector<kernel::Vec3>& points = soup_.points;
    std::size_t at = hashes_[i] & mask();
    for (; slots_[at] != kFree; at = (at + 1) & mask())
      if (points[slots_[at]] == pending_[i]) return slots_[at];
    if (points.size() == kFree) fail("file", "has too many corners", "split the mesh");
    slots_[at] = static_cast<std::uint32_t>(points.size());
    points.push_back(pending_[i]);
    return slots_[at];
  }

  void grow() {
    slots_.assign(4 * slots_.size(), kFree);
    for (std::size_t v = 0; v < soup_.points.size(); ++v) {
      std::size_t at = hash(soup_.points[v]) & mask();
      while (slots_[at] != kFree) at = (at + 1) & mask();
      slots_[at] = static_cast<std::uint32_t>(v);
    }
  }

  Soup& soup_;
  std::vector<std::uint32_t> slots_;
  std::vector<kernel::Vec3> pending_;  ///< corners
  std::vector<std::size_t> sizes_;     ///< of pending facets
  std::vector<std::uint64_t> hashes_;
  std::vector<Cells::Node> nodes_;
};

bool is_finite(const kernel::Vec3& p) {
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

Soup read_binary(std::string_view bytes, std::size_t facets) {
  Soup soup;
  Corners corners(soup, facets);
  for (std::size_t f = 0; f < facets; ++f) {
    const char* at = bytes.data() + kHeader + f * kFacet + 12;
    std::array<kernel::Vec3, 3> facet;
    for (std::size_t k = 0; k < 3; ++k) {
      for (double& x : facet[k]) {
        x = static_cast<double>(load_number<float>(at, false));
        at += 4;
      }
      if (!is_finite(facet[k])) {
        fail(fmt::format("face {}", f),
             fmt::format("a coordinate of its corner {} is not finite", k),
             "remove or repair the face");
      }
    }
    corners.add_facet(facet);
  }
  corners.flush();
  return soup;
}

/// Keywords in any case, lines broken anywhere, any number of solids.
class TextStl {
 public:
  /// A facet of a usual file has 200 bytes or more.
  explicit TextStl(std::string_view text) : scan_(text), facets_(soup_, text.size() / 200) {}

  Soup read() {
    bool solid = false;  // open
    while (scan_.more()) {
      const Keyword keyword = take_keyword();
      if (keyword == Keyword::vertex) {
        read_vertex();
      } else if (keyword == Keyword::facet) {
        if (open_) fail(face(), "is not closed", "end it with 'endfacet'");
        open_ = true;
        corners_.clear();
      } else if (keyword == Keyword::end_facet) {
        end_facet();
      } else if (keyword == Keyword::solid || keyword == Keyword::end_solid) {
        solid = keyword == Keyword::solid;
        scan_.next_line();  // a name may hold any word
      }
    }
    if (open_) fail_truncated();
    facets_.flush();
    if (solid) soup_.warnings.emplace_back("the file ends without 'endsolid'");
    return std::move(soup_);
  }

 private:
  enum class Keyword { none, vertex, facet, solid, end_facet, end_solid };

  std::string face() const { return numbered("face", facets_.facets(), scan_.line()); }

  [[noreturn]] void fail_truncated() const {
    fail(face(), "the file ends in it", "the file is truncated; export the mesh again");
  }

  static Keyword keyword_of(std::string_view word) {
    // Of the words of a facet most are numbers, "outer" and "loop".
    switch (word[0]) {
      case 'v':
      case 'V':
        return is_keyword(word, "vertex") ? Keyword::vertex : Keyword::none;
      case 'f':
      case 'F':
        return is_keyword(word, "facet") ? Keyword::facet : Keyword::none;
      case 's':
      case 'S':
        return is_keyword(word, "solid") ? Keyword::solid : Keyword::none;
      default:
        return Keyword::none;
    }
  }

  /// "end facet" is "endfacet".
  Keyword take_keyword() {
    std::string_view word = scan_.word();
    if (word[0] != 'e' && word[0] != 'E') return keyword_of(word);
    if (!is_keyword(word.substr(0, 3), "end")) return Keyword::none;
    word.remove_prefix(3);
    if (word.empty()) {
      if (!scan_.in_line()) return Keyword::none;
      word = scan_.word();
    }
    const Keyword begun = keyword_of(word);
    return begun == Keyword::facet   ? Keyword::end_facet
           : begun == Keyword::solid ? Keyword::end_solid
                                     : Keyword::none;
  }

  void read_vertex() {
    if (!open_) fail(face(), "has a vertex outside of a facet", "correct the file");
    kernel::Vec3 point{};
    for (std::size_t k = 0; k < 3; ++k) {
      if (!scan_.more()) fail_truncated();
      if (!scan_.take(point[k]))
        fail(face(), fmt::format("coordinate {} is not a number", quoted(scan_.peek())),
             "give x y z");
    }
    if (!is_finite(point)) {
      fail(face(), fmt::format("a coordinate of its corner {} is not finite", corners_.size()),
           "remove or repair the face");
    }
    corners_.push_back(point);
  }

  void end_facet() {
    if (!open_) fail(face(), "has 'endfacet' without 'facet'", "correct the file");
    open_ = false;
    facets_.add_facet(corners_);
  }

  TextScan scan_;
  Soup soup_;
  Corners facets_;
  bool open_ = false;
  std::vector<kernel::Vec3> corners_;  ///< of the open facet
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

Soup read_stl(std::string_view bytes, const FieldRequest&) {
  const std::string_view text = without_zeros_behind(bytes);
  if (is_text(text)) return TextStl(text).read();
  if (bytes.size() < kHeader) fail("file", "is too short for STL", "export the mesh again");
  const std::size_t facets = load_number<std::uint32_t>(bytes.data() + 80, false);
  const std::size_t whole = (bytes.size() - kHeader) / kFacet;
  if (whole >= facets) return read_binary(bytes, facets);
  // A text with a zero somewhere: its letters would be a count that no file has.
  if (is_keyword(bytes.substr(0, 5), "solid") && facets >= std::size_t{1} << 24) check_text(bytes);
  fail(fmt::format("face {}", whole),
       fmt::format("is missing or cut, the header announces {} faces", facets),
       "the file is truncated; export the mesh again");
}

}  // namespace crest::io
