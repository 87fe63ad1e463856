// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Running the built programs as a user does: a shell line in a folder of its own.
#include <sys/wait.h>

#include <cstdlib>
#include <string>

#include "tests/support/temporary_folder.hpp"

namespace crest::tests {

struct ProgramResult {
  int exit_code;  ///< -1 when it was killed by a signal
  std::string out, err;
};

/// Runs a shell line in `folder`, with the folders of `programs` first on PATH.
inline ProgramResult run_shell(const std::string& line, const fs::path& folder,
                               const std::string& programs) {
  const TemporaryFolder streams;
  const std::string command = "cd '" + folder.string() + "' && export PATH='" + programs +
                              "':\"$PATH\" && { " + line + "\n} >'" + (streams / "out").string() +
                              "' 2>'" + (streams / "err").string() + "'";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_text(streams / "out"),
          read_text(streams / "err")};
}

}  // namespace crest::tests
