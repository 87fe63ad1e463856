// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Files of the shared data that are packed.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace crest::tests {

/// The file itself, or its unpacked copy in the build directory.
inline std::string unpacked(const std::string& path) {
  if (!path.ends_with(".xz")) return path;
  const auto stem = std::filesystem::path(path).stem();
  const auto folder = std::filesystem::path(CREST_BINARY_DIR) / "unpacked";
  std::filesystem::create_directories(folder);
  const std::string copy = (folder / stem).string();
  const std::string command = "xz -dc '" + path + "' > '" + copy + "'";
  REQUIRE(std::system(command.c_str()) == 0);
  return copy;
}

}  // namespace crest::tests
