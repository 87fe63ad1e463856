// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A sub-command of `crest`: one file cli/<name>_command.cpp defines `const Command <name>_command`.
// CMake generates the table from the file names (objects that only register themselves would be
// dropped by the linker).
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace crest::cli {

/// Exit codes of the programs (docs/conventions.md).
enum ExitCode {
  kDone = 0,
  kNotCertified = 1,
  kUsage = 2,
  kBadInput = 3,
  kExhausted = 4,
  kInternal = 70
};

/// Options that contradict each other; reported as a usage error (exit code 2).
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct Command {
  const char* name;
  const char* summary;  ///< one line of `crest --help`
  /// Adds the options to the command's parser and returns what runs after parsing; its result is
  /// the exit code. Called once, before parsing.
  std::function<int()> (*add)(CLI::App& app);
  std::vector<std::string> examples;  ///< two or more command lines that run as they stand
};

/// In the order of their names (generated).
std::span<const Command* const> commands();

}  // namespace crest::cli
