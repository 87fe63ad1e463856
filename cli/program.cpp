// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/program.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <new>

#include "cli/command.hpp"
#include "cli/references.hpp"
#include "cli/version.hpp"
#include "kernel/geometry/input_error.hpp"

namespace {

using crest::cli::Command;

/// Examples end the help, after whatever the command has put there.
std::string examples_footer(const std::string& before, const Command& command) {
  std::string text = before + (before.empty() ? "" : "\n\n") + "Examples:";
  for (const std::string& example : command.examples) text += "\n  " + example;
  return text;
}

bool is_command(const std::string& name) {
  const auto all = crest::cli::commands();
  return std::any_of(all.begin(), all.end(),
                     [&](const Command* command) { return command->name == name; });
}

/// Errors in the command line: one line and where to look, exit code 2.
int usage_error(const CLI::App& app, const std::string& what) {
  const auto chosen = app.get_subcommands();
  const std::string command = chosen.empty() ? "" : " " + chosen.front()->get_name();
  std::fprintf(stderr, "crest%s: %s (see crest%s --help)\n", command.c_str(), what.c_str(),
               command.c_str());
  return crest::cli::kUsage;
}

int parse_and_run(CLI::App& app, int argc, char** argv) {
  std::vector<std::pair<CLI::App*, std::function<int()>>> runs;
  for (const Command* command : crest::cli::commands()) {
    CLI::App* sub = app.add_subcommand(command->name, command->summary);
    sub->footer("");  // not the one of the whole program
    runs.emplace_back(sub, command->add(*sub));
    sub->footer(examples_footer(sub->get_footer(), *command));
  }
  if (argc > 1 && argv[1][0] != '-' && !is_command(argv[1]))
    return usage_error(app, std::string("there is no command ") + argv[1]);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {  // --help, --version
    app.exit(help);
    return crest::cli::kDone;
  } catch (const CLI::ParseError& error) {
    return usage_error(app, error.what());
  }
  try {
    for (const auto& [sub, run] : runs)
      if (sub->parsed()) return run();
  } catch (const crest::cli::UsageError& error) {
    return usage_error(app, error.what());
  }
  return crest::cli::kInternal;
}

}  // namespace

int crest::cli::run_program(int argc, char** argv) {
  try {
    CLI::App app("Crest: certified extraction of surface topology", "crest");
    app.set_version_flag("--version", "crest " CREST_VERSION);
    app.add_flag_callback(
        "--cite",
        [] {
          std::fputs(crest::cli::bibtex({"crest"}).c_str(), stdout);
          throw CLI::Success();
        },
        "print how to cite Crest; crest COMMAND ... --cite: the papers behind a result");
    app.require_subcommand(1);
    app.footer("crest COMMAND --help shows a command's options and examples.");
    return parse_and_run(app, argc, argv);
  } catch (const crest::kernel::InputError& error) {
    std::fprintf(stderr, "crest: %s\n", error.what());
    return crest::cli::kBadInput;
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "crest: out of memory\n");
    return crest::cli::kExhausted;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "crest: internal error: %s\n", error.what());
    return crest::cli::kInternal;
  }
}
