// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <catch2/catch.hpp>
#include <filesystem>
#include <optional>
#include <string>

#include "tests/support/skip.hpp"

namespace crest::tests {

/// A file or folder of the shared data set. Nothing where there is no ../shared at all: the case
/// then returns and counts as skipped. Fails where ../shared is there without the file.
inline std::optional<std::string> shared_data(const std::string& relative) {
  const auto shared = std::filesystem::path(CREST_SOURCE_DIR) / ".." / "shared";
  if (!std::filesystem::exists(shared)) {
    skipped.push_back(Catch::getResultCapture().getCurrentTestName() +
                      ": ../shared is not there, nor its data/" + relative);
    return std::nullopt;
  }
  const auto path = shared / "data" / relative;
  INFO("../shared is there, but not its data/" << relative);
  REQUIRE(std::filesystem::exists(path));
  return path.string();
}

}  // namespace crest::tests
