// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/text_scan.hpp"

#include <fmt/format.h>
#include <locale.h>
#include <stdlib.h>

#include <algorithm>
#include <charconv>

#include "io/formats/files.hpp"

namespace crest::io {
namespace {

/// What from_chars does not know: overflow as infinity, underflow as an istream rounds it, and the
/// spellings of Fortran (1.5D+00) and of old Windows libraries (-1.#IND).
std::optional<double> rare_number(std::string word) {
  const std::size_t sign = word.find(".#");
  if (sign != word.npos && word.find_first_not_of("+-01") == sign) {
    const std::string_view name = std::string_view(word).substr(sign + 2);
    const double size = name.starts_with("INF") ? HUGE_VAL : NAN;
    const bool known = name.starts_with("INF") || name.starts_with("IND") ||
                       name.starts_with("QNAN") || name.starts_with("SNAN");
    if (known) return word[0] == '-' ? -size : size;
  }
  if (word.find_first_not_of("+-.0123456789eEdD") != word.npos) return std::nullopt;
  std::replace_if(
      word.begin(), word.end(), [](char c) { return c == 'd' || c == 'D'; }, 'e');
  static const locale_t plain = newlocale(LC_ALL_MASK, "C", nullptr);
  char* end = nullptr;
  const double value = strtod_l(word.c_str(), &end, plain);
  if (word.empty() || end != word.c_str() + word.size()) return std::nullopt;
  return value;
}

}  // namespace

TextScan::TextScan(std::string_view text, char comment)
    : begin_(text.data()),
      at_(begin_),
      end_(begin_ + text.size()),
      comment_(comment),
      counted_(begin_) {
  if (text.starts_with("\xef\xbb\xbf")) at_ += 3;
}

bool TextScan::next_line() {
  skip_to_line_end();
  if (at_ == end_) return false;
  const bool pair = *at_ == '\r' && at_ + 1 != end_ && at_[1] == '\n';
  at_ += pair ? 2 : 1;
  return at_ != end_;
}

std::string_view TextScan::rest_of_line() {
  while (at_ != end_ && is_blank(*at_)) ++at_;
  const char* const begin = at_;
  skip_to_line_end();
  const char* end = at_;
  while (end != begin && is_blank(end[-1])) --end;
  return {begin, static_cast<std::size_t>(end - begin)};
}

template <class Integer>
bool TextScan::take_any(Integer& value) {
  const std::string_view w = peek();
  const auto [end, error] = std::from_chars(w.data(), w.data() + w.size(), value);
  if (w.empty() || error != std::errc{} || end != w.data() + w.size()) return false;
  at_ = end;
  return true;
}

bool TextScan::take_long(std::int64_t& value) {
  return take_any(value);
}
bool TextScan::take(std::uint64_t& value) {
  return take_any(value);
}

bool TextScan::take_long(double& value) {
  // from_chars refuses a leading plus, an istream does not.
  const bool plus = room() > 1 && *at_ == '+' && at_[1] != '-' && at_[1] != '+';
  const auto [end, error] = std::from_chars(at_ + (plus ? 1 : 0), end_, value);
  // "1.#INF" of old Windows libraries, even where # starts a comment.
  const bool windows = end != end_ && *end == '#' && end != at_ && end[-1] == '.';
  if (error != std::errc{} || windows || (end != end_ && !ends_word(*end))) return take_rare(value);
  at_ = end;
  return true;
}

bool TextScan::take_rare(double& value) {
  const char* end = at_;
  while (end != end_ && !is_blank(*end) && !is_line_end(*end)) ++end;
  for (const std::string_view w :
       {std::string_view(at_, static_cast<std::size_t>(end - at_)), peek()}) {
    const auto rare = rare_number(std::string(w));
    if (!rare) continue;
    value = *rare;
    at_ += w.size();
    return true;
  }
  return false;
}

std::size_t TextScan::line() const {
  if (at_ < counted_) {
    counted_ = begin_;
    lines_ = 0;
  }
  for (; counted_ != at_; ++counted_) {
    const bool first_of_pair = *counted_ == '\r' && counted_ + 1 != end_ && counted_[1] == '\n';
    lines_ += (is_line_end(*counted_) && !first_of_pair) || *counted_ == '\v' ? 1 : 0;
  }
  return lines_ + 1;
}

std::string quoted(std::string_view word) {
  return fmt::format("'{}'", word.substr(0, 40));
}

bool is_keyword(std::string_view word, std::string_view lower) {
  return std::equal(word.begin(), word.end(), lower.begin(), lower.end(), [](char a, char b) {
    return a == b || (a >= 'A' && a <= 'Z' && a - 'A' + 'a' == b);
  });
}

std::string numbered(const char* what, std::size_t index, std::size_t line) {
  return fmt::format("{} {} (line {})", what, index, line);
}

void take_point(TextScan& scan, const char* what, Soup& soup) {
  kernel::Vec3 point{};
  for (std::size_t k = 0; k < 3; ++k) {
    const bool given = scan.in_line();
    if (given && scan.take(point[k])) continue;
    const std::string name = numbered(what, soup.points.size(), scan.line());
    if (!given && scan.room() == 0)
      fail(name, "the file ends in it", "the file is truncated; export the mesh again");
    if (!given) fail(name, fmt::format("has {} coordinates", k), "give x y z");
    const bool comma = scan.peek().find(',') != std::string_view::npos;
    fail(name, fmt::format("coordinate {} is not a number", quoted(scan.peek())),
         comma ? "write numbers with a point, not a comma" : "correct it");
  }
  soup.points.push_back(point);
  note_not_finite(soup, soup.points.size() - 1, scan);
}

void fail_vertex(const std::string& face, std::int64_t index, std::size_t vertices) {
  fail(face, fmt::format("vertex {} does not exist", index),
       fmt::format("the file has {} vertices, numbered from 0", vertices));
}

std::string_view without_zeros_behind(std::string_view bytes) {
  while (bytes.ends_with('\0')) bytes.remove_suffix(1);
  return bytes;
}

std::string_view check_text(std::string_view bytes) {
  bytes = without_zeros_behind(bytes);
  const std::size_t zero = bytes.find('\0');
  if (zero != std::string_view::npos)
    fail(fmt::format("byte {}", zero), "is zero in a text format", "export the mesh again as text");
  return bytes;
}

}  // namespace crest::io
