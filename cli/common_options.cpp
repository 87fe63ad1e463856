// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/common_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <map>

namespace crest::cli {
namespace {

/// In single quotes if a shell would read anything into it.
std::string quoted(const std::string& word) {
  constexpr const char* kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./-+=:,@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

std::string command_line(const CLI::App& app) {
  std::string line = "crest " + app.get_name();
  std::map<const CLI::Option*, std::size_t> seen;
  for (const CLI::Option* option : app.parse_order()) {
    const std::string name = option->get_name();
    const std::size_t number = seen[option]++;
    if (name == "--threads" || name == "--quiet" || number >= option->results().size()) continue;
    if (!option->get_positional()) line += " " + name;
    if (option->get_expected_max() > 0) line += " " + quoted(option->results()[number]);
  }
  return line;
}

}  // namespace

CLI::Validator finite_number(double least) {
  return {[least](std::string& text) -> std::string {
            double x = 0;
            if (!CLI::detail::lexical_cast(text, x) || !std::isfinite(x))
              return fmt::format("{} is not a finite number", text);
            return x < least ? fmt::format("{} is less than {}", text, least) : std::string();
          },
          ""};
}

void add_clean_options(CLI::App& app, io::CleanOptions& clean, bool oriented) {
  app.add_option("--weld", clean.weld,
                 "vertices within T of a lower one that stays become one (0: equal ones)")
      ->check(finite_number(0))
      ->type_name("T")
      ->group(kMeshGroup);
  app.add_flag("--split", clean.split,
               "cut at edges with three or more faces" +
                   std::string(oriented ? ", one-sided components open" : ""))
      ->group(kMeshGroup);
  if (!oriented) return;
  app.add_flag("--outward", clean.outward, "turn closed components of negative volume")
      ->group(kMeshGroup);
}

void add_step_option(CLI::App& app, CommonOptions& options) {
  app.add_option("--step", options.step, "time step of the field (.msh; default: the last)")
      ->type_name("N")
      ->group(kMeshGroup);
}

void add_page_option(CLI::App& app, CommonOptions& options) {
  app.add_option("--page", options.page, "scene to turn in a browser, in one file (.html)")
      ->type_name("FILE");
  app.parse_complete_callback([&app, &options] { options.command_line = command_line(app); });
}

void add_view_options(CLI::App& app, io::Viewpoint& viewpoint) {
  const auto add = [&app](const char* name, std::optional<kernel::Vec3>& direction,
                          const char* help) {
    const auto take = [name, &direction](const std::string& text) {
      kernel::Vec3 v{};
      const std::vector<std::string> words = CLI::detail::split(text, ',');
      for (std::size_t k = 0; k < 3; ++k)
        if (words.size() != 3 || !CLI::detail::lexical_cast(words[k], v[k]))
          throw CLI::ValidationError(name, text + " is not three numbers X,Y,Z");
      direction = v;
    };
    app.add_option_function<std::string>(name, take, help)->type_name("X,Y,Z");
  };
  add("--view", viewpoint.view, "of pictures: from the eye into the scene (--view=-1,0,0)");
  add("--up", viewpoint.up, "of pictures: what points up (default: the way the shape stands)");
}

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
  add_page_option(app, options);
  add_view_options(app, options.viewpoint);
  add_run_options(app, options);
  app.add_flag("--cite", options.cite, "print the references this run used (BibTeX)");
}

}  // namespace crest::cli
