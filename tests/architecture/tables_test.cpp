// SPDX-License-Identifier: GPL-3.0-or-later
// Each stored table says in its first line how it was made: command, commit, kind of machine.
#include <catch2/catch.hpp>
#include <map>
#include <regex>

#include "tests/architecture/source_tree.hpp"

namespace {

using namespace crest::tests;

/// What the first line lacks, in words; empty: nothing.
std::string lacking(const std::string& line) {
  static const std::regex commit(R"(; (?:old: )?commit [0-9a-f]{8,40}\b)"),
      machine(R"(\b\d+ cores?, [A-Z])");
  std::string text;
  if (!has_prefix(line, "Command: ")) text += " command";
  if (!std::regex_search(line, commit)) text += " commit";
  if (!std::regex_search(line, machine)) text += " machine";
  return text;
}

/// Tables that are not made anew yet, and why.
const std::map<std::string, const char*> kExceptions = {};

}  // namespace

TEST_CASE("a table's first line has command, commit and kind of machine") {
  CHECK(lacking("Command: experiments/a/b --c 1; commit 0123456789ab; 2 cores, AMD EPYC").empty());
  CHECK(lacking("Command: experiments/a/b; commit not kept; 2 cores, AMD EPYC") == " commit");
  CHECK(lacking("experiments/a/b; commit 0123456789ab") == " command machine");
  std::size_t tables = 0, excepted = 0;
  for (const std::string& path : project_files()) {
    if (!has_prefix(path, "experiments/") || path.find("/tables/") == std::string::npos) continue;
    ++tables;
    INFO(path);
    const auto lines = lines_of(path);
    REQUIRE(!lines.empty());
    INFO("lacks" << lacking(lines[0]) << ": " << lines[0]);
    const bool open = kExceptions.count(path) == 1;
    excepted += open;
    CHECK(lacking(lines[0]).empty() != open);
  }
  CHECK(tables > 60);
  CHECK(excepted == kExceptions.size());
}
