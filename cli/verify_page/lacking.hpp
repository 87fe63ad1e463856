// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#ifdef __EMSCRIPTEN__
// Before any header of the library: an index beyond a list, a value that is not there, end the
// checker, where size_t has but 32 bits.
#define _LIBCPP_ASSERT(condition, message) ((condition) ? (void)0 : __builtin_trap())
#endif

// What the checkers use of C++20's library and emscripten's libc++ (13) lacks: algorithms on whole
// ranges and bit_cast. Force-included (CMakeLists.txt); in crest::lacking so that the tests compare
// them with libstdc++'s. Each is its standard's namesake for the arguments that the checkers give,
// by way of the algorithm on iterators.
#include <algorithm>
#include <cstring>
#include <functional>
#include <iterator>
#include <type_traits>
#include <utility>

namespace crest::lacking {

template <class Compare, class Projection>
auto compared(Compare& compare, Projection& projection) {
  return [&](const auto& a, const auto& b) -> bool {
    return std::invoke(compare, std::invoke(projection, a), std::invoke(projection, b));
  };
}
template <class Predicate, class Projection>
auto asked(Predicate& predicate, Projection& projection) {
  return [&](const auto& x) -> bool { return std::invoke(predicate, std::invoke(projection, x)); };
}

/// std::identity, which is lacking, too.
struct Same {
  template <class T>
  constexpr T&& operator()(T&& x) const noexcept {
    return std::forward<T>(x);
  }
};

template <class Range, class Compare = std::less<>, class Projection = Same>
constexpr void sort(Range&& range, Compare compare = {}, Projection projection = {}) {
  std::sort(std::begin(range), std::end(range), compared(compare, projection));
}
template <class Range, class Compare = std::less<>, class Projection = Same>
constexpr bool is_sorted(Range&& range, Compare compare = {}, Projection projection = {}) {
  return std::is_sorted(std::begin(range), std::end(range), compared(compare, projection));
}
template <class Range, class Compare = std::less<>, class Projection = Same>
constexpr auto max_element(Range&& range, Compare compare = {}, Projection projection = {}) {
  return std::max_element(std::begin(range), std::end(range), compared(compare, projection));
}
template <class T>
struct Ends {
  T min, max;
};
template <class Range>
constexpr auto minmax(const Range& range) {
  const auto [low, high] = std::minmax_element(std::begin(range), std::end(range));
  return Ends<std::decay_t<decltype(*low)>>{*low, *high};
}

template <class Range, class Value, class Compare = std::less<>, class Projection = Same>
constexpr auto lower_bound(Range&& range, const Value& value, Compare compare = {},
                           Projection projection = {}) {
  return std::lower_bound(std::begin(range), std::end(range), value,
                          [&](const auto& a, const Value& b) -> bool {
                            return std::invoke(compare, std::invoke(projection, a), b);
                          });
}
template <class Range, class Value>
constexpr bool binary_search(Range&& range, const Value& value) {
  return std::binary_search(std::begin(range), std::end(range), value);
}
template <class Range, class Value>
constexpr auto equal_range(Range&& range, const Value& value) {
  return std::equal_range(std::begin(range), std::end(range), value);
}

template <class Range, class Predicate, class Projection = Same>
constexpr bool all_of(Range&& range, Predicate predicate, Projection projection = {}) {
  return std::all_of(std::begin(range), std::end(range), asked(predicate, projection));
}
template <class Range, class Predicate, class Projection = Same>
constexpr bool any_of(Range&& range, Predicate predicate, Projection projection = {}) {
  return std::any_of(std::begin(range), std::end(range), asked(predicate, projection));
}
template <class Range, class Predicate, class Projection = Same>
constexpr bool none_of(Range&& range, Predicate predicate, Projection projection = {}) {
  return std::none_of(std::begin(range), std::end(range), asked(predicate, projection));
}
template <class Range, class Predicate, class Projection = Same>
constexpr auto count_if(Range&& range, Predicate predicate, Projection projection = {}) {
  return std::count_if(std::begin(range), std::end(range), asked(predicate, projection));
}
template <class Range, class Value, class Projection = Same>
constexpr auto count(Range&& range, const Value& value, Projection projection = {}) {
  return lacking::count_if(
      range, [&](const auto& x) { return x == value; }, projection);
}
template <class Range, class Predicate, class Projection = Same>
constexpr auto find_if(Range&& range, Predicate predicate, Projection projection = {}) {
  return std::find_if(std::begin(range), std::end(range), asked(predicate, projection));
}
template <class Range, class Value, class Projection = Same>
constexpr auto find(Range&& range, const Value& value, Projection projection = {}) {
  return lacking::find_if(
      range, [&](const auto& x) { return x == value; }, projection);
}
template <class Range, class Predicate = std::equal_to<>>
constexpr auto adjacent_find(Range&& range, Predicate predicate = {}) {
  return std::adjacent_find(std::begin(range), std::end(range), predicate);
}
template <class A, class B, class Predicate = std::equal_to<>, class First = Same,
          class Second = Same>
constexpr bool equal(A&& a, B&& b, Predicate predicate = {}, First first = {}, Second second = {}) {
  return std::equal(std::begin(a), std::end(a), std::begin(b), std::end(b),
                    [&](const auto& x, const auto& y) -> bool {
                      return std::invoke(predicate, std::invoke(first, x), std::invoke(second, y));
                    });
}

template <class Range, class Out>
constexpr void copy(Range&& range, Out out) {
  std::copy(std::begin(range), std::end(range), out);
}
template <class Range>
constexpr void reverse(Range&& range) {
  std::reverse(std::begin(range), std::end(range));
}
template <class Range, class Iterator>
constexpr void rotate(Range&& range, Iterator middle) {
  std::rotate(std::begin(range), middle, std::end(range));
}
template <class Range, class Old, class New>
constexpr void replace(Range&& range, const Old& old, const New& value) {
  for (auto& x : range)
    if (x == old) x = value;
}
template <class Iterator>
struct Rest {
  Iterator first, last;
  Iterator begin() const { return first; }
  Iterator end() const { return last; }
};
/// What is left over, as std::ranges::unique does.
template <class Range>
constexpr auto unique(Range&& range) {
  return Rest<decltype(std::begin(range))>{std::unique(std::begin(range), std::end(range)),
                                           std::end(range)};
}

template <class To, class From>
constexpr To bit_cast(const From& from) {
  static_assert(sizeof(To) == sizeof(From) && std::is_trivially_copyable_v<To> &&
                std::is_trivially_copyable_v<From>);
  return __builtin_bit_cast(To, from);
}

}  // namespace crest::lacking

#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 14000
namespace std {
using crest::lacking::bit_cast;
namespace ranges {
using namespace crest::lacking;
}
}  // namespace std
#endif
