// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/text_scan.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdlib>

#include "io/formats/files.hpp"

namespace crest::io {
namespace {

bool is_space(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

/// from_chars refuses a leading plus, istream does not.
std::string_view without_plus(std::string_view word) {
  const bool plus = word.size() > 1 && word[0] == '+' && word[1] != '-' && word[1] != '+';
  return plus ? word.substr(1) : word;
}

template <class T>
std::optional<T> whole_word(std::string_view word) {
  word = without_plus(word);
  T value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size()) return std::nullopt;
  if constexpr (std::is_floating_point_v<T>) {
    // Too large reads as infinity, too small as zero or subnormal, as with an istream.
    if (error == std::errc::result_out_of_range)
      return std::strtod(std::string(word).c_str(), nullptr);
  }
  if (error != std::errc{}) return std::nullopt;
  return value;
}

}  // namespace

bool LineScanner::next(char comment) {
  while (next_ < text_.size()) {
    begin_ = next_;
    const std::size_t end = std::min(text_.find('\n', begin_), text_.size());
    next_ = end + 1;
    ++number_;
    line_ = text_.substr(begin_, end - begin_);
    if (comment != '\0') line_ = line_.substr(0, line_.find(comment));
    words_.clear();
    for (std::size_t i = 0; i < line_.size();) {
      if (is_space(line_[i])) {
        ++i;
        continue;
      }
      std::size_t j = i;
      while (j < line_.size() && !is_space(line_[j])) ++j;
      words_.push_back(line_.substr(i, j - i));
      i = j;
    }
    if (!words_.empty()) return true;
  }
  return false;
}

std::optional<double> number_of(std::string_view word) {
  return whole_word<double>(word);
}
std::optional<std::int64_t> integer_of(std::string_view word) {
  return whole_word<std::int64_t>(word);
}

std::string numbered(const char* what, std::size_t index, std::size_t line) {
  return fmt::format("{} {} (line {})", what, index, line);
}

void fail_coordinates(const std::vector<std::string_view>& words, std::size_t first,
                      const std::string& element) {
  if (words.size() < first + 3) {
    fail(element, fmt::format("has {} coordinates", words.size() - std::min(first, words.size())),
         "give x y z");
  }
  std::size_t k = first;
  while (k + 1 < first + 3 && number_of(words[k]) && std::isfinite(*number_of(words[k]))) ++k;
  const std::string quoted(words[k].substr(0, 40));
  if (!number_of(words[k]))
    fail(element, "coordinate '" + quoted + "' is not a number", "correct it");
  fail(element, "coordinate '" + quoted + "' is not finite", "remove or repair the vertex");
}

void check_corner_count(std::int64_t corners, const std::string& element) {
  if (corners == 3) return;
  const std::string problem = fmt::format("has {} vertices", corners);
  if (corners > 3) fail(element, problem, "triangulate it first");
  fail(element, problem, "remove it or give it 3");
}

void check_text(std::string_view bytes) {
  const std::size_t zero = bytes.find('\0');
  if (zero != std::string_view::npos)
    fail(fmt::format("byte {}", zero), "is zero in a text format", "export the mesh again as text");
}

}  // namespace crest::io
