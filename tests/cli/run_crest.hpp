// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the tests of the programs share.
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/program.hpp"

namespace crest::tests {

/// Runs a shell line that may call `crest` and `crest-verify` by name.
inline ProgramResult run_crest(const std::string& line, const fs::path& folder) {
  const std::string programs = fs::path(CREST_PROGRAM).parent_path().string() + "':'" +
                               fs::path(CREST_VERIFY_PROGRAM).parent_path().string();
  return run_shell(line, folder, programs);
}

inline std::vector<std::string> split_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

inline nlohmann::json read_json(const fs::path& path) {
  return nlohmann::json::parse(read_text(path));
}

/// One line, ended, and nothing that looks like a crash.
inline bool is_one_line(const std::string& text) {
  return text.size() > 1 && text.find('\n') == text.size() - 1;
}

/// "  name   description" lines of `crest --help` after "Subcommands:".
inline std::vector<std::string> command_names(const std::string& help) {
  std::vector<std::string> names;
  bool inside = false;
  for (const std::string& line : split_lines(help))
    if (line == "Subcommands:")
      inside = true;
    else if (inside && line.rfind("  ", 0) == 0)
      names.push_back(line.substr(2, line.find(' ', 2) - 2));
    else
      inside = false;
  return names;
}

/// The lines after "Examples:", without their indentation.
inline std::vector<std::string> examples_of(const std::string& help) {
  std::vector<std::string> examples;
  bool inside = false;
  for (const std::string& line : split_lines(help))
    if (line == "Examples:")
      inside = true;
    else if (inside && line.rfind("  ", 0) == 0)
      examples.push_back(line.substr(2));
  return examples;
}

}  // namespace crest::tests
