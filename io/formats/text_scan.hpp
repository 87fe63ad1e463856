// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The scanner of all text formats: it walks over the bytes once, and a number is checked and
// converted where it stands. Own code: stream readers take ten times as long, and those of VTK and
// assimp narrow to float.
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "io/formats/short_number.hpp"
#include "io/formats/soup.hpp"

namespace crest::io {

/// A place in a text that holds still. A word ends at a blank, a line's end or a comment; a line
/// ends with LF, CR LF or CR. A vertical tab is a blank that counts as a line's end.
class TextScan {
 public:
  /// Past a byte order mark. `comment`: what starts a comment up to the line's end; 0: nothing.
  explicit TextScan(std::string_view text, char comment = '\0');

  /// Moves to the next word of the line; false at its end.
  bool in_line() {
    while (at_ != end_ && is_blank(*at_)) ++at_;
    if (at_ == end_ || is_line_end(*at_)) return false;
    if (*at_ != comment_ || comment_ == '\0') return true;
    skip_to_line_end();
    return false;
  }
  /// Moves to the next word of the text; false at its end.
  bool more() {
    while (!in_line())
      if (!next_line()) return false;
    return true;
  }
  /// Moves past the line's end; false at the end of the text.
  bool next_line();

  /// The word here, up to `limit` characters of it; empty at the end of a line.
  std::string_view peek(std::size_t limit = std::string_view::npos) const {
    const char* const most = at_ + (limit < room() ? limit : room());
    const char* end = at_;
    while (end != most && !ends_word(*end)) ++end;
    return {at_, static_cast<std::size_t>(end - at_)};
  }
  /// Takes the word here.
  std::string_view word() {
    const std::string_view w = peek();
    at_ += w.size();
    return w;
  }
  /// Takes what is left of the line, comments included, without blanks around it.
  std::string_view rest_of_line();
  void skip_word() {
    while (at_ != end_ && !ends_word(*at_)) ++at_;
  }

  /// Takes the word here as a number, correctly rounded, NaN and infinities included; stays where
  /// it is none.
  bool take(double& value) {
    const char* const end = take_short_number(at_, end_, value);
    if (end) at_ = end;
    return end || take_long(value);
  }
  bool take(std::int64_t& value) {
    const char* const before = at_;
    if (take_prefix(value) && (at_ == end_ || ends_word(*at_))) return true;
    at_ = before;
    return take_long(value);
  }
  bool take(std::uint64_t& value);
  /// Takes the integer that the word here starts with.
  bool take_prefix(std::int64_t& value) {
    const char* p = at_;
    const bool negative = p != end_ && *p == '-';
    if (negative || (p != end_ && *p == '+')) ++p;
    const char* const first = p;
    std::int64_t sum = 0;
    constexpr std::ptrdiff_t most = 18;  // digits of which an int64 holds any
    for (; p != end_ && *p >= '0' && *p <= '9'; ++p) {
      if (p - first == most) return false;
      sum = 10 * sum + (*p - '0');
    }
    if (p == first) return false;
    value = negative ? -sum : sum;
    at_ = p;
    return true;
  }
  /// Takes the character if it stands here.
  bool take(char c) {
    const bool here = at_ != end_ && *at_ == c;
    at_ += here ? 1 : 0;
    return here;
  }
  /// Whether a word has just ended.
  bool after_word() const { return at_ == end_ || ends_word(*at_); }

  /// The bytes from here on, up to `limit`.
  std::string_view peek_bytes(std::size_t limit) const {
    return {at_, limit < room() ? limit : room()};
  }
  /// Takes bytes. Requires: no more than room().
  std::string_view take_bytes(std::size_t count) {
    at_ += count;
    return {at_ - count, count};
  }
  std::size_t room() const { return static_cast<std::size_t>(end_ - at_); }

  std::size_t position() const { return static_cast<std::size_t>(at_ - begin_); }
  void move_to(std::size_t position) { at_ = begin_ + position; }
  /// The number of this line, from 1. Cost: the text since the last call.
  std::size_t line() const;

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
  static bool is_line_end(char c) { return c == '\n' || c == '\r'; }
  bool ends_word(char c) const {
    return (c <= ' ' && (is_blank(c) || is_line_end(c))) || (c == comment_ && c != '\0');
  }
  void skip_to_line_end() {
    while (at_ != end_ && !is_line_end(*at_)) ++at_;
  }
  template <class Integer>
  bool take_any(Integer& value);
  bool take_long(std::int64_t& value);
  bool take_long(double& value);
  bool take_rare(double& value);

  const char *begin_, *at_, *end_;
  char comment_;
  mutable const char* counted_;  ///< the lines before it: lines_
  mutable std::size_t lines_ = 0;
};

/// A word in quotation marks, cut if it is long.
std::string quoted(std::string_view word);

/// Whether a word is `lower`, whatever its case.
bool is_keyword(std::string_view word, std::string_view lower);

/// "vertex 7 (line 12)".
std::string numbered(const char* what, std::size_t index, std::size_t line);

/// Takes three coordinates of a line as the next point of the soup, in which a line is noted if
/// they are not finite. Throws: kernel::InputError unless they are numbers.
void take_point(TextScan& scan, const char* what, Soup& soup);

/// Notes the line if the soup's point is not finite.
inline void note_not_finite(Soup& soup, std::size_t point, const TextScan& scan) {
  const kernel::Vec3& p = soup.points[point];
  // The sum of finite coordinates may overflow, hence the second look.
  if (std::isfinite(p[0] + p[1] + p[2])) return;
  if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
    soup.lines_not_finite.emplace_back(point, scan.line());
}

/// Throws for an index that is no vertex's.
[[noreturn]] void fail_vertex(const std::string& face, std::int64_t index, std::size_t vertices);

/// Without the zeros that some programs write behind a text.
std::string_view without_zeros_behind(std::string_view bytes);

/// The bytes as a text. Throws when they are none.
std::string_view check_text(std::string_view bytes);

}  // namespace crest::io
