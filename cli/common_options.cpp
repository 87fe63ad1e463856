// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/common_options.hpp"

#include <CLI/CLI.hpp>

namespace crest::cli {

void add_run_options(CLI::App& app, CommonOptions& options) {
  app.add_option("--threads", options.threads, "threads to use (default: all)")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
  app.add_flag("--quiet", options.quiet, "no summary, no progress");
}

void add_common_options(CLI::App& app, CommonOptions& options, const std::string& input_help,
                        const std::string& output_help) {
  app.add_option("INPUT", options.input, input_help)->required();
  app.add_option("-o,--output", options.output, output_help)->type_name("FILE");
  app.add_option("--report", options.report, "counts, times and the certificate's state (.json)")
      ->type_name("FILE");
  app.add_option("--certificate", options.certificate, "proof for crest-verify (.crest)")
      ->type_name("FILE");
  app.add_option("--picture", options.picture, "drawing, hidden parts removed (.svg, .png)")
      ->type_name("FILE");
  add_run_options(app, options);
  app.add_flag("--cite", options.cite, "print the references this run used (BibTeX)");
}

}  // namespace crest::cli
