// SPDX-License-Identifier: GPL-3.0-or-later
// Wavefront OBJ: vertices, faces, lines, points and the normals of face corners; texture
// coordinates and the vertices' colours where they are asked for. Weights, groups, materials are
// passed over.
#include <fmt/format.h>

#include <algorithm>

#include "io/formats/files.hpp"
#include "io/formats/readers.hpp"
#include "io/formats/text_parts.hpp"
#include "io/formats/text_scan.hpp"

namespace crest::io {
namespace {

/// The first backslash at a line's end from `from` on.
std::size_t continuation(std::string_view text, std::size_t from) {
  std::size_t at = text.find('\\', from);
  while (at != text.npos &&
         (at + 1 == text.size() || (text[at + 1] != '\n' && text[at + 1] != '\r')))
    at = text.find('\\', at + 1);
  return at;
}

/// A backslash at a line's end continues it: both become blanks that still count as a line's end.
void join_continued_lines(std::string& text) {
  for (std::size_t at = continuation(text, 0); at != text.npos; at = continuation(text, at)) {
    const std::size_t end = at + 1;
    if (text.compare(end, 2, "\r\n") == 0) text[end + 1] = ' ';
    text[at] = ' ';
    text[end] = '\v';
  }
}

/// Of vertices, as face corners name them. A vertex whose corners have different normals has none
/// of its own: their mean would be an estimate.
class CornerNormals {
 public:
  void add(const kernel::Vec3& normal) { normals_.push_back(normal); }
  std::int64_t size() const { return static_cast<std::int64_t>(normals_.size()); }
  void corner(Cells::Node vertex, std::int64_t normal) { corners_.emplace_back(vertex, normal); }

  /// Of a file without faces, if there are as many as vertices: one each, in their order.
  void finish_points(Soup& soup) {
    if (soup.points.size() != normals_.size()) return;
    for (std::int64_t v = 0; v < size(); ++v) corner(v, v);
  }

  void finish(Soup& soup) const {
    if (corners_.empty()) return;
    std::vector<const kernel::Vec3*> of(soup.points.size(), nullptr);
    std::vector<bool> missing(soup.points.size(), true);
    std::vector<bool> several(soup.points.size(), false);
    for (const auto& [vertex, number] : corners_) {
      if (number < 0 || number >= size()) continue;
      const auto v = static_cast<std::size_t>(vertex);
      const kernel::Vec3& normal = normals_[static_cast<std::size_t>(number)];
      if (of[v] && *of[v] != normal) several[v] = true;
      of[v] = &normal;
      missing[v] = several[v];
    }
    std::vector<double> numbers;
    numbers.reserve(3 * of.size());
    for (std::size_t v = 0; v < of.size(); ++v)
      for (std::size_t k = 0; k < 3; ++k) numbers.push_back(missing[v] ? 0 : (*of[v])[k]);
    Field& field = soup.point_fields.emplace_back(
        Field{.name = "Normals", .components = 3, .numbers = std::move(numbers), .normals = true});
    if (std::find(missing.begin(), missing.end(), true) != missing.end())
      field.missing = std::move(missing);
    const auto left_out = std::count(several.begin(), several.end(), true);
    if (left_out > 0) {
      soup.warnings.push_back(fmt::format(
          "left out the normals of {} vertices, at which faces have different ones", left_out));
    }
  }

 private:
  std::vector<kernel::Vec3> normals_;
  std::vector<std::pair<Cells::Node, std::int64_t>> corners_;  ///< vertex, normal
};

/// Up to three numbers that corners of faces name.
class CornerNumbers {
 public:
  /// Of corners that name none, and of those whose index is no integer or before the first.
  static constexpr std::int64_t kNoNumber = -1, kWrong = -2;

  explicit CornerNumbers(const char* name) : name_(name) {}
  void add(const kernel::Vec3& numbers, int count) {
    pool_.push_back(numbers);
    components_ = std::max(components_, count);
  }
  std::int64_t size() const { return static_cast<std::int64_t>(pool_.size()); }
  /// The next corner's, kNoNumber or kWrong.
  void corner(std::int64_t number) { corners_.push_back(number); }

  void finish(Soup& soup) const {
    const auto is_there = [&](std::int64_t i) { return i >= 0 && i < size(); };
    const auto wrong = std::count_if(corners_.begin(), corners_.end(), [&](std::int64_t i) {
      return i != kNoNumber && !is_there(i);
    });
    if (wrong > 0)
      soup.warnings.push_back(
          fmt::format("left out {} at {} corners, whose indices are no integers or out of range",
                      name_, wrong));
    if (std::none_of(corners_.begin(), corners_.end(), is_there)) return;
    std::vector<double> numbers;
    std::vector<bool> missing;
    for (const std::int64_t i : corners_) {
      missing.push_back(!is_there(i));
      for (int k = 0; k < components_; ++k)
        numbers.push_back(
            missing.back() ? 0 : pool_[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)]);
    }
    Field& field = soup.corner_fields.emplace_back(
        Field{.name = name_, .components = components_, .numbers = std::move(numbers)});
    if (std::find(missing.begin(), missing.end(), true) != missing.end())
      field.missing = std::move(missing);
  }

 private:
  const char* name_;
  int components_ = 1;
  std::vector<kernel::Vec3> pool_;
  std::vector<std::int64_t> corners_;  ///< in the pool
};

/// Just three numbers behind a vertex' place are its colour; the first of four is a weight.
class VertexColours {
 public:
  /// Of the soup's last point. Cost: nothing where the one before has none.
  void take(TextScan& scan, const Soup& soup) {
    if (numbers_.size() + 3 < 3 * soup.points.size()) return;
    kernel::Vec3 colour{};
    std::size_t count = 0;
    while (count < 3 && scan.in_line() && scan.take(colour[count])) ++count;
    if (count == 3 && !scan.in_line())
      numbers_.insert(numbers_.end(), colour.begin(), colour.end());
  }
  /// All vertices have one, or none has.
  void finish(Soup& soup) {
    if (numbers_.empty() || numbers_.size() != 3 * soup.points.size()) return;
    soup.point_fields.push_back(
        Field{.name = "RGB", .components = 3, .numbers = std::move(numbers_)});
  }

 private:
  std::vector<double> numbers_;
};

class ObjReader {
 public:
  ObjReader(std::string_view text, const FieldRequest& request)
      : scan_(text, '#'),
        with_normals_(!request.corners && (request.normals || request.asks_for("Normals"))),
        with_corners_(request.corners),
        points_(request.points) {}

  Soup read() {
    while (scan_.more()) {
      const std::string_view keyword = scan_.word();
      if (keyword == "v")
        read_vertex();
      else if (keyword == "f")
        read_face();
      else if (keyword == "vn" && (with_normals_ || with_corners_))
        read_normal();
      else if (keyword == "vt" && with_corners_)
        read_texture();
      else if (keyword == "l" || keyword == "p")
        read_thin(keyword == "l" ? CellType::poly_line : CellType::poly_vertex);
      scan_.next_line();
    }
    if (highest_ > soup_.points.size()) {
      fail(numbered(highest_is_face_ ? "face" : "line", highest_cell_, highest_line_),
           fmt::format("index {} is out of range", highest_),
           fmt::format("the file has {} vertices, numbered from 1", soup_.points.size()));
    }
    // After the faces, which thus keep their numbers.
    for (std::size_t c = 0; c < thin_.size(); ++c) soup_.cells.add(thin_.type(c), thin_.nodes(c));
    if (points_ && soup_.cells.empty()) normals_.finish_points(soup_);
    normals_.finish(soup_);
    textures_.finish(soup_);
    corner_normals_.finish(soup_);
    colours_.finish(soup_);
    return std::move(soup_);
  }

 private:
  void read_vertex() {
    take_point(scan_, "vertex", soup_);
    if (with_corners_) colours_.take(scan_, soup_);
  }

  void read_texture() {
    kernel::Vec3 numbers{};
    int count = 0;
    while (count < 3 && scan_.in_line() && scan_.take(numbers[static_cast<std::size_t>(count)]))
      ++count;
    if (count == 0)
      fail(numbered("texture", static_cast<std::size_t>(textures_.size()), scan_.line()),
           "has no numbers", "correct it");
    textures_.add(numbers, count);
  }

  void read_normal() {
    kernel::Vec3 normal{};
    for (double& x : normal) {
      if (!scan_.in_line() || !scan_.take(x))
        fail(numbered("normal", static_cast<std::size_t>(normals_.size()), scan_.line()),
             "is not three numbers", "correct it");
    }
    with_corners_ ? corner_normals_.add(normal, 3) : normals_.add(normal);
  }

  /// The vertex that a corner "7", "7/1", "7//3" or "7/1/3" starts with.
  Cells::Node take_vertex(bool face) {
    const std::size_t cell = face ? soup_.cells.size() : thin_.size();
    const auto name = [&] { return numbered(face ? "face" : "line", cell, scan_.line()); };
    std::int64_t index = 0;
    const std::size_t begin = scan_.position();
    if (!scan_.take_prefix(index) || !(scan_.after_word() || scan_.take('/'))) {
      scan_.move_to(begin);
      fail(name(), "index " + quoted(scan_.peek()) + " is not an integer", "correct it");
    }
    const auto vertices = static_cast<std::int64_t>(soup_.points.size());
    if (index == 0) fail(name(), "index 0 does not exist", "OBJ counts from 1");
    if (index < -vertices)
      fail(name(), fmt::format("index {} is out of range", index), "correct it");
    if (index > vertices && static_cast<std::size_t>(index) > highest_) {
      highest_ = static_cast<std::size_t>(index);
      highest_cell_ = cell;
      highest_line_ = scan_.line();
      highest_is_face_ = face;
    }
    return index > 0 ? index - 1 : vertices + index;
  }

  /// The rest of a corner.
  void take_normal(Cells::Node vertex) {
    std::int64_t number = 0;
    scan_.take_prefix(number);  // of the texture
    if (!scan_.take('/') || !scan_.take_prefix(number) || number == 0) return;
    normals_.corner(vertex, number > 0 ? number - 1 : normals_.size() + number);
  }

  /// The rest of a corner, or nothing of it: its texture and its normal.
  void take_numbers(bool rest) {
    const auto index = [&](const CornerNumbers& of) {
      const auto at_end = [&] { return scan_.after_word() || scan_.peek(1) == "/"; };
      if (!rest || at_end()) return CornerNumbers::kNoNumber;
      std::int64_t number = 0;
      if (!scan_.take_prefix(number) || !at_end() || number == 0 || number < -of.size())
        return CornerNumbers::kWrong;
      return number > 0 ? number - 1 : of.size() + number;
    };
    textures_.corner(index(textures_));
    rest = rest && scan_.take('/');
    corner_normals_.corner(index(corner_normals_));
  }

  void read_face() {
    corners_.clear();
    while (scan_.in_line()) {
      corners_.push_back(take_vertex(true));
      const bool rest = !scan_.after_word();
      if (with_corners_) take_numbers(rest);
      if (rest && with_normals_) take_normal(corners_.back());
      scan_.skip_word();
    }
    soup_.cells.add(face_type(corners_.size()), corners_);
  }

  void read_thin(CellType type) {
    corners_.clear();
    while (scan_.in_line()) {
      corners_.push_back(take_vertex(false));
      scan_.skip_word();
    }
    thin_.add(type, corners_);
  }

  TextScan scan_;
  bool with_normals_, with_corners_, points_;
  Soup soup_;
  Cells thin_;
  CornerNormals normals_;
  CornerNumbers textures_{"TCoords"}, corner_normals_{"Normals"};
  VertexColours colours_;
  std::vector<Cells::Node> corners_;
  /// The highest index beyond the vertices before it, and where it stands.
  std::size_t highest_ = 0, highest_cell_ = 0, highest_line_ = 0;
  bool highest_is_face_ = false;
};

}  // namespace

Soup read_obj(std::string_view bytes, const FieldRequest& request) {
  bytes = check_text(bytes);
  if (continuation(bytes, 0) == bytes.npos) {
    const bool plain =
        reads_parts() && !request.corners && !request.normals && !request.asks_for("Normals");
    Soup soup;
    if (plain && read_obj_triangles(bytes, soup)) return soup;
    return ObjReader(bytes, request).read();
  }
  std::string joined(bytes);
  join_continued_lines(joined);
  return ObjReader(joined, request).read();
}

}  // namespace crest::io
