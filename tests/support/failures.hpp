// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How a loop over many cases explains its failures.
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/random.hpp"
#include "tests/support/words.hpp"

namespace crest::tests {

/// Counts failures and keeps the first one's operands, for loops where a Catch assertion would cost
/// more than the case: CHECK(failures.report() == "") at the end.
class Failures {
 public:
  template <class... Operands>
  void expect(bool holds, const char* what, const Operands&... operands) {
    ++cases_;
    if (holds) return;
    if (++count_ == 1)
      first_ = std::string(what) + " " + in_braces(operands...) + " (" + random_origin() + ")";
  }
  std::uint64_t count() const { return count_; }
  /// Empty without a failure.
  std::string report() const {
    if (count_ == 0) return "";
    return std::to_string(count_) + " of " + std::to_string(cases_) +
           " are not so, the first: " + first_;
  }

 private:
  std::uint64_t cases_ = 0, count_ = 0;
  std::string first_;
};

/// What the living objects of class OnFailure say.
inline thread_local std::vector<std::function<std::string()>> said_on_failure;

/// As Catch's INFO, but the words are made only when an assertion fails: for hot loops.
class OnFailure {
 public:
  explicit OnFailure(std::function<std::string()> words) {
    said_on_failure.push_back(std::move(words));
  }
  ~OnFailure() { said_on_failure.pop_back(); }
  OnFailure(const OnFailure&) = delete;
  OnFailure& operator=(const OnFailure&) = delete;
};

}  // namespace crest::tests
