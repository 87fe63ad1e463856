// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The project's own files, for tests that read the source.
#include <algorithm>
#include <string>
#include <vector>

#include "tests/support/program.hpp"

namespace crest::tests {

/// Paths relative to the root, sorted: everything in the project's folders, no build products.
inline std::vector<std::string> project_files() {
  const fs::path root = CREST_SOURCE_DIR;
  std::vector<std::string> files;
  for (const char* folder :
       {"kernel", "certify", "algorithms", "io", "cli", "bindings", "distributed", "examples",
        "experiments", "tests", "cmake", "scripts", "docs", ".ci"}) {
    if (!fs::exists(root / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root / folder))
      if (entry.is_regular_file()) files.push_back(fs::relative(entry.path(), root).string());
  }
  for (const auto& entry : fs::directory_iterator(root))
    if (entry.is_regular_file()) files.push_back(entry.path().filename().string());
  std::sort(files.begin(), files.end());
  return files;
}

inline bool has_suffix(const std::string& text, const std::string& suffix) {
  return text.size() >= suffix.size() &&
         text.compare(text.size() - suffix.size(), suffix.size(), suffix) == 0;
}
inline bool has_prefix(const std::string& text, const std::string& prefix) {
  return text.compare(0, prefix.size(), prefix) == 0;
}
inline bool is_cpp(const std::string& path) {
  return has_suffix(path, ".cpp") || has_suffix(path, ".hpp");
}

inline std::vector<std::string> lines_of(const std::string& path) {
  std::vector<std::string> lines;
  std::ifstream file(fs::path(CREST_SOURCE_DIR) / path);
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

}  // namespace crest::tests
