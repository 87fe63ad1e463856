// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The words of an expression's text: numbers, names, exponents and single characters.
#include <cstdint>
#include <string>
#include <string_view>

#include "kernel/expressions/expression.hpp"

namespace crest::kernel {

/// How deep an expression may be nested: what recursion over it may cost in stack.
constexpr int kDeepestNesting = 200;

/// Walks over a text that holds still. Throws: ExpressionError with the column, from every member
/// that expects something.
class ExpressionText {
 public:
  explicit ExpressionText(std::string_view text) : text_(text) {}

  std::size_t at() const { return at_; }
  bool at_end() const { return at_ >= text_.size(); }
  /// The next character that is not blank; 0 at the end.
  char peek();
  /// Passes `c` if it is next.
  bool accept(char c);
  /// Where what comes next begins.
  std::size_t begin() {
    peek();
    return at_;
  }
  /// Where what has been passed ends: before the blanks that were looked past.
  std::size_t end() const;

  [[noreturn]] void fail(std::size_t at, const std::string& what) const {
    throw ExpressionError(at + 1, what);
  }
  /// Names what is there instead.
  [[noreturn]] void expected(const std::string& what);

  bool number_is_next();
  bool name_is_next();
  /// A number, exactly.
  Constant number();
  /// A name.
  std::string_view name();
  /// An integer of at most 1000 in magnitude, with signs, brackets and powers of its own.
  std::int64_t exponent();

  /// Counts how deep the recursion is, and stops it.
  class Level {
   public:
    explicit Level(ExpressionText& text) : text_(text) {
      if (++text_.level_ > kDeepestNesting) text_.fail(text_.at_, "is nested too deeply");
    }
    ~Level() { --text_.level_; }
    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;

   private:
    ExpressionText& text_;
  };

 private:
  std::string_view digits();
  std::int64_t scale();
  std::int64_t nested_exponent();

  std::string_view text_;
  std::size_t at_ = 0;
  int level_ = 0;
};

}  // namespace crest::kernel
