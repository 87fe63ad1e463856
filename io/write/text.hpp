// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The text of an output file: the one way there for numbers.
#include <fmt/format.h>

#include <iterator>
#include <string>
#include <type_traits>
#include <utility>

#include "io/write/finite.hpp"

namespace crest::io {

/// Numbers are the shortest decimals that read back as the same doubles, unless the format says
/// otherwise.
class Text {
 public:
  /// Appends what fmt::format makes of these. Throws: std::runtime_error if a number among them, or
  /// in a range that is joined, is not finite.
  template <class... Args>
  void add(fmt::format_string<Args...> format, Args&&... args) {
    (check(args), ...);
    fmt::format_to(std::back_inserter(buffer_), format, std::forward<Args>(args)...);
  }
  void add(const Text& other) {
    buffer_.append(other.buffer_.data(), other.buffer_.data() + other.buffer_.size());
  }

  std::string text() const { return fmt::to_string(buffer_); }

 private:
  template <class T>
  static void check([[maybe_unused]] const T& x) {
    if constexpr (std::is_floating_point_v<T>)
      require_finite(x, "number");
    else if constexpr (requires { *x.begin; })  // fmt::join
      for (auto i = x.begin; i != x.end; ++i) check(*i);
  }

  fmt::memory_buffer buffer_;
};

}  // namespace crest::io
