// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Lines and words of text formats, for the checks that name a faulty element.
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace crest::io {

/// Walks over the lines of a text that holds still.
class LineScanner {
 public:
  explicit LineScanner(std::string_view text) : text_(text) {}
  /// Moves to the next line that has a word once everything after `comment` is cut off.
  bool next(char comment = '\0');
  std::size_t number() const { return number_; }  ///< of the current line, from 1
  std::string_view line() const { return line_; }
  std::size_t offset() const { return begin_; }  ///< of the current line in the text
  const std::vector<std::string_view>& words() const { return words_; }

 private:
  std::string_view text_, line_;
  std::size_t begin_ = 0, next_ = 0, number_ = 0;
  std::vector<std::string_view> words_;
};

/// The whole word as a number, nan and infinities included; nothing when it is none.
std::optional<double> number_of(std::string_view word);
std::optional<std::int64_t> integer_of(std::string_view word);

/// "vertex 7 (line 12)".
std::string numbered(const char* what, std::size_t index, std::size_t line);

/// Says which of words[first], .. [first + 2] is no finite coordinate.
[[noreturn]] void fail_coordinates(const std::vector<std::string_view>& words, std::size_t first,
                                   const std::string& element);

/// words[first], .. [first + 2], which must be finite coordinates of `element`, a function that is
/// called for its name only where they are not.
template <class Name>
std::array<double, 3> coordinates(const std::vector<std::string_view>& words, std::size_t first,
                                  const Name& element) {
  std::array<double, 3> result{};
  bool good = words.size() >= first + 3;
  for (std::size_t k = 0; good && k < 3; ++k) {
    const auto value = number_of(words[first + k]);
    good = value && std::isfinite(*value);
    if (good) result[k] = *value;
  }
  if (!good) fail_coordinates(words, first, element());
  return result;
}

/// Throws for a face whose number of corners is not 3.
void check_corner_count(std::int64_t corners, const std::string& element);

/// Throws when the bytes are not those of a text.
void check_text(std::string_view bytes);

}  // namespace crest::io
