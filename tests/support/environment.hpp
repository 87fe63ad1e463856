// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What all random tests share: the multiplier and the seed.
#include <cstdint>
#include <cstdlib>

namespace crest::tests {

/// CREST_TEST_MULTIPLIER scales the number of random cases (default 1).
inline double multiplier() {
  const char* text = std::getenv("CREST_TEST_MULTIPLIER");
  return text ? std::atof(text) : 1.0;
}
/// Whether this thread's test case has random numbers.
inline thread_local bool is_random = false;

inline std::uint64_t scaled(std::uint64_t n) {
  is_random = true;
  const double m = static_cast<double>(n) * multiplier();
  return m < 1 ? 1 : static_cast<std::uint64_t>(m);
}

/// Fixed, and printed with a failing case; random tests derive their generators from it.
inline constexpr std::uint64_t kSeed = 20041;

}  // namespace crest::tests
