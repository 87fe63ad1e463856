// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the tests share: the multiplier, the seed, and the data a user may not have.
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

namespace crest::tests {

/// CREST_TEST_MULTIPLIER scales the number of random cases (default 1).
inline double multiplier() {
  const char* text = std::getenv("CREST_TEST_MULTIPLIER");
  return text ? std::atof(text) : 1.0;
}
inline std::uint64_t scaled(std::uint64_t n) {
  const double m = static_cast<double>(n) * multiplier();
  return m < 1 ? 1 : static_cast<std::uint64_t>(m);
}

/// Fixed and printed with a failing case; random tests derive their generators from it.
inline constexpr std::uint64_t kSeed = 20041;

/// A file of the shared data set, or nothing where it is not installed: the test then skips with a
/// message (WARN) and returns.
inline std::optional<std::string> shared_data(const std::string& relative) {
  const auto path = std::filesystem::path(CREST_SOURCE_DIR) / ".." / "shared" / "data" / relative;
  if (!std::filesystem::exists(path)) return std::nullopt;
  return path.string();
}

}  // namespace crest::tests
