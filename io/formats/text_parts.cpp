// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/text_parts.hpp"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

#include "io/formats/text_scan.hpp"

namespace crest::io {
namespace {

/// Calls read(part) for all parts side by side until one is false; whether all were true.
template <class Read>
bool all_parts(std::size_t parts, const Read& read) {
  std::atomic<bool> good = true;
  tbb::parallel_for(std::size_t{0}, parts, [&](std::size_t p) {
    if (good.load(std::memory_order_relaxed) && !read(p)) good = false;
  });
  return good;
}

bool take_finite(TextScan& scan, kernel::Vec3& point) {
  for (double& x : point)
    if (!scan.in_line() || !scan.take(x)) return false;
  return std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]);
}

bool skip_words(TextScan& scan, std::optional<std::size_t> words) {
  if (!words) return true;
  for (std::size_t i = 0; i < *words; ++i) {
    if (!scan.in_line()) return false;
    scan.skip_word();
  }
  return !scan.in_line();
}

constexpr std::int64_t kMost = 0xffffffff;  ///< of vertices: their numbers stand in 32 bits here

/// Whose nodes are counted from `first`.
void add_triangles(const std::vector<std::uint32_t>& nodes, Cells::Node first, Cells& cells) {
  for (std::size_t i = 0; i + 2 < nodes.size(); i += 3) {
    const std::array<Cells::Node, 3> triangle = {nodes[i] - first, nodes[i + 1] - first,
                                                 nodes[i + 2] - first};
    cells.add(CellType::triangle, triangle);
  }
}

class RowReader {
 public:
  RowReader(std::string_view text, const TriangleRows& rows, Soup& soup, std::size_t part_size)
      : text_(text), rows_(rows), soup_(soup), parts_(text_parts(text, rows.begin, part_size)) {}

  bool read() {
    count_lines();
    const std::size_t all = rows_.vertices + rows_.faces;
    if (first_.back() < all || rows_.vertices > std::size_t{kMost}) return false;
    // The shortest lines are "0 0 0" and "3 0 1 2": no room for more than the bytes may hold.
    if (6 * rows_.vertices + 8 * rows_.faces > text_.size() - rows_.begin + 1) return false;
    points_.resize(rows_.vertices);
    nodes_.resize(3 * rows_.faces);
    if (!all_parts(parts_.size(), [&](std::size_t p) { return read_part(p); })) return false;
    soup_.points = std::move(points_);
    soup_.cells.reserve(rows_.faces, nodes_.size());
    add_triangles(nodes_, 0, soup_.cells);
    return true;
  }

 private:
  /// first_[p]: lines before part p.
  void count_lines() {
    first_.assign(parts_.size() + 1, 0);
    tbb::parallel_for(std::size_t{0}, parts_.size(), [&](std::size_t p) {
      const std::string_view part = text_.substr(parts_[p].begin, parts_[p].end - parts_[p].begin);
      first_[p + 1] = static_cast<std::size_t>(std::count(part.begin(), part.end(), '\n')) +
                      (part.ends_with('\n') ? 0 : 1);
    });
    for (std::size_t p = 0; p < parts_.size(); ++p) first_[p + 1] += first_[p];
  }

  bool read_part(std::size_t p) {
    TextScan scan(text_, rows_.comment);
    scan.move_to(parts_[p].begin);
    const std::size_t all = rows_.vertices + rows_.faces, end = std::min(all, first_[p + 1]);
    for (std::size_t row = std::min(all, first_[p]); row < end; ++row) {
      if (!(row < rows_.vertices ? read_vertex(scan, row) : read_face(scan, row - rows_.vertices)))
        return false;
      scan.next_line();
    }
    // Carriage returns alone would have made more lines.
    return end == all || scan.position() == parts_[p].end;
  }

  bool read_vertex(TextScan& scan, std::size_t v) {
    return take_finite(scan, points_[v]) && skip_words(scan, rows_.behind_vertex);
  }

  bool read_face(TextScan& scan, std::size_t f) {
    std::int64_t corners = 0;
    if (!scan.in_line() || !scan.take(corners) || corners != 3) return false;
    for (std::size_t k = 0; k < 3; ++k) {
      Cells::Node node = 0;
      if (!scan.in_line() || !scan.take(node)) return false;
      if (node < 0 || node >= static_cast<Cells::Node>(rows_.vertices)) return false;
      nodes_[3 * f + k] = static_cast<std::uint32_t>(node);
    }
    return skip_words(scan, rows_.behind_face);
  }

  std::string_view text_;
  const TriangleRows& rows_;
  Soup& soup_;
  std::vector<TextPart> parts_;
  std::vector<std::size_t> first_;
  std::vector<kernel::Vec3> points_;
  std::vector<std::uint32_t> nodes_;
};

/// What a part of an OBJ file holds.
class ObjPart {
 public:
  bool read(std::string_view text, TextPart part) {
    TextScan scan(text, '#');
    for (scan.move_to(part.begin); scan.position() < part.end; scan.next_line()) {
      if (!scan.in_line()) continue;
      const std::string_view keyword = scan.word();
      if (keyword == "v" ? !read_vertex(scan) : keyword == "f" ? !read_face(scan) : thin(keyword))
        return false;
    }
    return true;
  }

  std::vector<kernel::Vec3> points;
  std::vector<std::uint32_t> nodes;
  std::uint32_t highest = 0;

 private:
  static bool thin(std::string_view keyword) { return keyword == "l" || keyword == "p"; }

  bool read_vertex(TextScan& scan) { return take_finite(scan, points.emplace_back()); }

  bool read_face(TextScan& scan) {
    for (int k = 0; k < 3; ++k) {
      std::int64_t index = 0;
      if (!scan.in_line() || !scan.take_prefix(index) || index < 1 || index > kMost) return false;
      if (!scan.after_word() && !scan.take('/')) return false;
      scan.skip_word();
      nodes.push_back(static_cast<std::uint32_t>(index));
      highest = std::max(highest, nodes.back());
    }
    return !scan.in_line();
  }
};

}  // namespace

bool reads_parts() {
  return tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism) > 1;
}

std::vector<TextPart> text_parts(std::string_view text, std::size_t begin, std::size_t size) {
  std::vector<TextPart> parts;
  while (begin < text.size()) {
    const std::size_t feed = text.find('\n', std::min(text.size(), begin + size) - 1);
    const std::size_t end = feed == text.npos ? text.size() : feed + 1;
    parts.push_back({begin, end});
    begin = end;
  }
  return parts;
}

bool read_triangle_rows(std::string_view text, const TriangleRows& rows, Soup& soup,
                        std::size_t part_size) {
  return RowReader(text, rows, soup, part_size).read();
}

bool read_obj_triangles(std::string_view text, Soup& soup, std::size_t part_size) {
  // From behind a byte order mark.
  const auto parts = text_parts(text, TextScan(text, '#').position(), part_size);
  std::vector<ObjPart> read(parts.size());
  if (!all_parts(parts.size(), [&](std::size_t p) { return read[p].read(text, parts[p]); }))
    return false;
  std::size_t points = 0, nodes = 0;
  for (const ObjPart& part : read) {
    points += part.points.size();
    nodes += part.nodes.size();
  }
  for (const ObjPart& part : read)
    if (part.highest > points) return false;
  soup.points.reserve(points);
  soup.cells.reserve(nodes / 3, nodes);
  for (ObjPart& part : read) {
    soup.points.insert(soup.points.end(), part.points.begin(), part.points.end());
    add_triangles(part.nodes, 1, soup.cells);
    part = {};
  }
  return true;
}

}  // namespace crest::io
