// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// JSON as the report needs it: values are put together here, only json.cpp reads a JSON library.
#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace crest::cli {

/// A value; the members of an object keep the order in which they were added.
class Json {
 public:
  using Member = std::pair<std::string, Json>;

  Json() = default;  ///< null
  Json(bool x) : value_(x) {}
  Json(double x) : value_(x) {}
  Json(const char* text) : value_(std::string(text)) {}
  Json(std::string text) : value_(std::move(text)) {}
  template <std::integral Integer>
  Json(Integer x) {
    if constexpr (std::signed_integral<Integer>)
      value_ = std::int64_t{x};
    else
      value_ = std::uint64_t{x};
  }
  /// An array of what the range holds.
  template <class Range>
  requires requires(const Range& range) { range.begin(), range.end(); }
  Json(const Range& range) : Json(array()) {
    for (const auto& x : range) push_back(x);
  }
  Json(std::initializer_list<Member> members);

  static Json array();
  static Json object();

  /// The member of this name, added as null if there is none. Requires: an object or null.
  Json& operator[](const std::string& name);
  /// Requires: an array.
  void push_back(Json item);

  /// Two spaces a level, one final newline; bytes that are not UTF-8 are replaced.
  /// Throws std::runtime_error naming the member for a number that is not finite: what is undefined
  /// is null.
  std::string text() const;

  using Items = std::vector<Json>;
  using Members = std::vector<Member>;
  using Value = std::variant<std::nullptr_t, bool, std::int64_t, std::uint64_t, double, std::string,
                             Items, Members>;
  const Value& value() const { return value_; }

 private:
  Value value_ = nullptr;
};

}  // namespace crest::cli
