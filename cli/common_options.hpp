// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The options every command has, in the same words.
#include <string>

namespace CLI {
class App;
}

namespace crest::cli {

struct CommonOptions {
  std::string input;        ///< INPUT; a file
  std::string output;       ///< -o; geometry, by extension
  std::string report;       ///< --report; JSON
  std::string certificate;  ///< --certificate; certify/SPEC.md
  std::string picture;      ///< --picture; .svg or .png
  int threads = 0;          ///< --threads; 0: as many as the machine has
  bool quiet = false;       ///< --quiet; no summary, no progress
  bool cite = false;        ///< --cite; BibTeX of what the run used
};

/// --threads and --quiet, which every command has.
void add_run_options(CLI::App& app, CommonOptions& options);

/// Adds INPUT (checked by the reader, not by the parser: a missing file is bad input, exit code 3)
/// and the common options.
void add_common_options(CLI::App& app, CommonOptions& options, const std::string& input_help,
                        const std::string& output_help);

}  // namespace crest::cli
