// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How a check says no; verify() turns it into the verdict.
#include <fmt/format.h>

#include <stdexcept>
#include <string>

namespace crest::certify {

/// A claim that is false, or not in canonical form.
class Reject : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};
/// A number that could not be enclosed well enough to tell.
class Undecided : public Reject {
 public:
  using Reject::Reject;
};

/// Throws Reject with the formatted text unless the condition holds.
template <class... Arguments>
void require(bool condition, fmt::format_string<Arguments...> text, Arguments&&... arguments) {
  if (!condition) throw Reject(fmt::format(text, std::forward<Arguments>(arguments)...));
}

/// Requires a stated number to be the one found.
template <class Stated, class Found>
void require_equal(Stated stated, Found found, const char* what) {
  require(std::int64_t{stated} == static_cast<std::int64_t>(found), "{}: {} stated, {} found", what,
          stated, found);
}

}  // namespace crest::certify
