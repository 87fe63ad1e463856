// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The generator of every random test. It notes where its numbers come from, and a failing test
// prints the last note (tests/support/main.cpp).
#include <cstdint>
#include <random>
#include <string>

#include "tests/support/environment.hpp"

namespace crest::tests {

/// The latest generator of this thread in words, as it is written in a test.
inline thread_local std::string latest_generator;

class Random : public std::mt19937_64 {
 public:
  explicit Random(std::uint64_t seed) : std::mt19937_64(seed) {
    is_random = true;
    latest_generator = "Random(" + std::to_string(seed) + ")";
  }
};

/// The seed, the multiplier and the latest generator: what makes a failing case again.
inline std::string random_origin() {
  const std::string generator = latest_generator.empty() ? "" : ", latest " + latest_generator;
  return "kSeed " + std::to_string(kSeed) + ", CREST_TEST_MULTIPLIER " +
         std::to_string(multiplier()) + generator;
}

}  // namespace crest::tests
