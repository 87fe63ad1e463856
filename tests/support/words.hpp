// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Values in words that can be pasted into a test: numbers as hexadecimal floats, arrays and plain
// structs in braces.
#include <array>
#include <cmath>
#include <cstdio>
#include <ostream>
#include <ranges>
#include <sstream>
#include <string>
#include <type_traits>

namespace crest::tests {

/// Converts to whatever a struct's member is: only to count the members.
struct AnyMember {
  template <class T>
  operator T&() const;
};

template <class T, class... Members>
constexpr std::size_t member_count() {
  if constexpr (requires { T{Members{}..., AnyMember{}}; })
    return member_count<T, Members..., AnyMember>();
  else
    return sizeof...(Members);
}

template <class T>
std::string in_words(const T& x);

template <class... Ts>
std::string in_braces(const Ts&... xs) {
  std::string text;
  ((text += (text.empty() ? "{" : ", ") + in_words(xs)), ...);
  return text.empty() ? "{}" : text + "}";
}

template <class T>
std::string members_in_words(const T& x) {
  constexpr std::size_t count = member_count<T>();
  static_assert(1 <= count && count <= 7, "a case for this many members is missing");
  const auto words = [](const auto&... members) { return in_braces(members...); };
  if constexpr (count == 1) {
    const auto& [a] = x;
    return words(a);
  } else if constexpr (count == 2) {
    const auto& [a, b] = x;
    return words(a, b);
  } else if constexpr (count == 3) {
    const auto& [a, b, c] = x;
    return words(a, b, c);
  } else if constexpr (count == 4) {
    const auto& [a, b, c, d] = x;
    return words(a, b, c, d);
  } else if constexpr (count == 5) {
    const auto& [a, b, c, d, e] = x;
    return words(a, b, c, d, e);
  } else if constexpr (count == 6) {
    const auto& [a, b, c, d, e, f] = x;
    return words(a, b, c, d, e, f);
  } else {
    const auto& [a, b, c, d, e, f, g] = x;
    return words(a, b, c, d, e, f, g);
  }
}

inline std::string number_in_words(double x) {
  if (std::isnan(x)) return "NAN";
  if (std::isinf(x)) return x > 0 ? "HUGE_VAL" : "-HUGE_VAL";
  char text[32];
  std::snprintf(text, sizeof text, "%a", x);
  return text;
}

template <class T>
std::string in_words(const T& x) {
  if constexpr (std::is_same_v<T, bool>) {
    return x ? "true" : "false";
  } else if constexpr (std::is_floating_point_v<T>) {
    return number_in_words(static_cast<double>(x));
  } else if constexpr (std::is_integral_v<T>) {
    return std::to_string(x);
  } else if constexpr (std::is_enum_v<T>) {
    return std::to_string(static_cast<long long>(x));
  } else if constexpr (!std::is_array_v<T> && requires(std::ostream & out) { out << x; }) {
    std::ostringstream out;
    out << x;
    return out.str();
  } else if constexpr (std::ranges::range<T>) {
    std::string text;
    for (const auto& element : x) text += (text.empty() ? "" : ", ") + in_words(element);
    // An array of arrays or structs needs a pair for the array itself.
    const bool numbers = std::is_arithmetic_v<std::ranges::range_value_t<T>>;
    return numbers ? "{" + text + "}" : "{{" + text + "}}";
  } else {
    return members_in_words(x);
  }
}

}  // namespace crest::tests
