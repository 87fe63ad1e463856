// SPDX-License-Identifier: GPL-3.0-or-later
// OFF: [ST][C][N]OFF [BINARY], counts, vertices, faces.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "io/formats/files.hpp"
#include "io/formats/off_binary.hpp"
#include "io/formats/readers.hpp"
#include "io/formats/remedy.hpp"
#include "io/formats/text_parts.hpp"
#include "io/formats/text_scan.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::io {
namespace {

const std::string kStart = "start the file with 'OFF' and the line 'vertices faces edges'";
/// A colour after a face's corners has no mark of its own and lines may be wrapped, so a file is
/// read by the first of these rules that it obeys to its end; the message is that of the first.
enum class Layout {
  /// Vertices and faces have a line each. What follows on it is a colour and the like.
  lines,
  /// Geomview's rule: a vertex has as many numbers as the keyword says, which may be on several
  /// lines, as may a face's corners; what follows them on their last line is a colour.
  wrapped,
  /// A sequence of words without colours of faces, wherever lines end.
  words,
  words_without_edges  ///< the same, with two counts
};

struct Keyword {
  OffVertex vertex = {};
  bool binary = false;
};

Keyword take_keyword(TextScan& scan) {
  if (!scan.more()) fail("header", "is missing", kStart);
  std::string_view word = scan.peek();
  std::int64_t count = 0;
  const std::size_t begin = scan.position();
  Keyword keyword;
  if (scan.take(count)) {  // it may be left out
    scan.move_to(begin);
    return keyword;
  }
  for (const std::string_view prefix : {"ST", "C", "N"}) {
    if (!word.starts_with(prefix)) continue;
    word.remove_prefix(prefix.size());
    keyword.vertex.normals = prefix == "N";
    keyword.vertex.numbers_behind += prefix == "ST" ? 2 : prefix == "C" ? 4 : 0;
  }
  if (word != "OFF" && word != "off")
    fail(fmt::format("header (line {})", scan.line()), quoted(scan.peek()) + " is not read",
         kStart);
  scan.skip_word();
  keyword.binary = scan.in_line() && scan.peek(7) == "BINARY";
  return keyword;
}

std::size_t take_count(TextScan& scan, const char* what) {
  std::int64_t count = 0;
  const bool given = scan.more();
  const std::string line = fmt::format("header (line {})", scan.line());
  if (!given) fail(line, fmt::format("has no number of {}", what), kStart);
  const std::string_view word = scan.peek();
  if (!scan.take(count) || count < 0)
    fail(line, fmt::format("has a bad count {}", quoted(word)), kStart);
  return static_cast<std::size_t>(count);
}

/// A word that ends the line of the two counts is a third one, no coordinate.
void refuse_third_count(TextScan& scan) {
  if (!scan.in_line()) return;
  const std::size_t third = scan.position();
  scan.skip_word();
  if (!scan.in_line()) fail("header", "has three counts", kStart);
  scan.move_to(third);
}

class OffReader {
 public:
  /// `scan` is behind the keyword.
  OffReader(std::string_view text, const TextScan& scan, OffVertex vertex, bool normals)
      : text_(text),
        scan_(scan),
        vertex_(vertex),
        normals_(normals && vertex.normals),
        start_(scan.position()) {}

  Soup read() {
    try {
      return read_by(Layout::lines);
    } catch (const kernel::InputError&) {
      for (const Layout layout : {Layout::wrapped, Layout::words, Layout::words_without_edges}) {
        try {
          return read_by(layout);
        } catch (const kernel::InputError&) {
        }
      }
      throw;
    }
  }

 private:
  void read_counts(Layout layout) {
    vertices_ = take_count(scan_, "vertices");
    faces_ = take_count(scan_, "faces");
    // A file that is not hopelessly short names the first element that is missing.
    const std::size_t bytes = scan_.position() + scan_.room();
    if (vertices_ > bytes || faces_ > bytes) {
      fail(fmt::format("header (line {})", scan_.line()),
           fmt::format("announces {} vertices and {} faces, more than the file holds", vertices_,
                       faces_),
           "the file is truncated or its header wrong; export the mesh again");
    }
    if (layout == Layout::words) take_count(scan_, "edges");
    if (layout == Layout::words_without_edges) return refuse_third_count(scan_);
    if (layout == Layout::words) return;
    if (scan_.in_line()) take_count(scan_, "edges");
    scan_.next_line();
  }

  Soup read_by(Layout layout) {
    scan_.move_to(start_);
    read_counts(layout);
    Soup soup;
    if (layout == Layout::lines && !vertex_.normals && reads_parts() && scan_.more() &&
        read_triangle_rows(text_, {scan_.position(), vertices_, faces_, {}, {}, '#'}, soup))
      return soup;
    // The shortest vertex is "0 0 0", the shortest face "1 0", each with a line end.
    const std::size_t room = scan_.room() + 1, faces = std::min(faces_, room / 4);
    soup.points.reserve(std::min(vertices_, room / 6));
    soup.cells.reserve(faces, 3 * faces);
    of_normals_.clear();
    missing_.assign(normals_ ? vertices_ : 0, false);
    bool any_normal = false;
    for (std::size_t v = 0; v < vertices_; ++v)
      any_normal = (layout == Layout::lines ? read_vertex_line(soup) : read_vertex_words(soup)) ||
                   any_normal;
    if (vertex_.normals && vertices_ > 0 && !any_normal)
      fail("vertices", "have no normals", "start the file with 'OFF' or add them");
    for (std::size_t f = 0; f < faces_; ++f) read_face(f, layout, soup.cells);
    if (layout != Layout::lines && scan_.more()) fail("faces", "are too many", kStart);
    if (normals_) {
      soup.point_fields.emplace_back(Field{
          .name = "Normals", .components = 3, .numbers = std::move(of_normals_), .normals = true});
      if (std::find(missing_.begin(), missing_.end(), true) != missing_.end())
        soup.point_fields.back().missing = std::move(missing_);
    }
    return soup;
  }

  void require_more(const char* what, std::size_t number) {
    if (scan_.more()) return;
    fail(fmt::format("{} {}", what, number), "is missing, the file ends before it", kTruncated);
  }

  /// Whether it has a normal.
  bool read_vertex_line(Soup& soup) {
    require_more("vertex", soup.points.size());
    take_point(scan_, "vertex", soup);
    std::array<double, 3> normal{};
    bool given = vertex_.normals;
    for (double& x : normal) given = given && scan_.in_line() && scan_.take(x);
    if (!given) normal = {};
    if (normals_) {
      of_normals_.insert(of_normals_.end(), normal.begin(), normal.end());
      missing_[soup.points.size() - 1] = !given;
    }
    scan_.next_line();
    return given;
  }

  /// A number on this line or a later one.
  double take_wrapped(std::size_t vertex) {
    require_more("vertex", vertex);
    double value = 0;
    if (!scan_.take(value))
      fail(numbered("vertex", vertex, scan_.line()), quoted(scan_.peek()) + " is not a number",
           "correct it");
    return value;
  }

  bool read_vertex_words(Soup& soup) {
    const std::size_t v = soup.points.size();
    kernel::Vec3 point{};
    for (double& x : point) x = take_wrapped(v);
    soup.points.push_back(point);
    note_not_finite(soup, v, scan_);
    for (std::size_t k = 0; k < 3 && vertex_.normals; ++k) {
      const double x = take_wrapped(v);
      if (normals_) of_normals_.push_back(x);
    }
    for (std::size_t k = 0; k < vertex_.numbers_behind; ++k) take_wrapped(v);
    return vertex_.normals;
  }

  void read_face(std::size_t f, Layout layout, Cells& cells) {
    const auto name = [&] { return numbered("face", f, scan_.line()); };
    require_more("face", f);
    std::int64_t corners = 0;
    if (!scan_.take(corners) || corners < 0)
      fail(name(), "does not start with a number of vertices", "correct it");
    if (corners < (layout == Layout::lines ? 1 : 3))
      fail(name(), fmt::format("has {} corners", corners), "remove it");
    face_.clear();
    for (std::int64_t k = 0; k < corners; ++k) {
      if (layout == Layout::lines ? !scan_.in_line() : !scan_.more())
        scan_.room() == 0 ? fail(name(), "the file ends in it", kTruncated)
                          : fail(name(), "has fewer indices than it announces", "correct it");
      std::int64_t index = 0;
      if (!scan_.take(index))
        fail(name(), "index " + quoted(scan_.peek()) + " is not an integer", "correct it");
      if (index < 0 || index >= static_cast<std::int64_t>(vertices_))
        fail_vertex(name(), index, vertices_);
      face_.push_back(index);
    }
    cells.add(face_type(face_.size()), face_);
    if (layout == Layout::lines || layout == Layout::wrapped) scan_.next_line();
  }

  std::string_view text_;
  TextScan scan_;
  OffVertex vertex_;
  bool normals_;       ///< they are in the file and asked for
  std::size_t start_;  ///< of the counts
  std::size_t vertices_ = 0, faces_ = 0;
  std::vector<double> of_normals_;
  std::vector<bool> missing_;
  std::vector<Cells::Node> face_;
};

}  // namespace

Soup read_off(std::string_view bytes, const FieldRequest& request) {
  const bool normals = request.normals || request.asks_for("Normals");
  TextScan start(bytes, '#');
  const auto [vertex, binary] = take_keyword(start);
  if (binary) {
    start.next_line();
    return read_binary_off(start.peek_bytes(start.room()), vertex, normals);
  }
  const std::string_view text = check_text(bytes);
  TextScan scan(text, '#');
  scan.move_to(std::min(start.position(), text.size()));  // the zeros may be in a comment
  return OffReader(text, scan, vertex, normals).read();
}

}  // namespace crest::io
