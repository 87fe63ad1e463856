// SPDX-License-Identifier: GPL-3.0-or-later
// Help texts, examples, the README: what a newcomer types first.
#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "tests/cli/run_crest.hpp"

using namespace crest::tests;

TEST_CASE("crest --help has one line a command") {
  const TemporaryFolder folder;
  const auto result = run_crest("crest --help", folder.path());
  CHECK(result.exit_code == 0);
  CHECK(result.err.empty());
  const auto names = command_names(result.out);
  CHECK(std::count(names.begin(), names.end(), "ridges") == 1);
  CHECK(std::count(names.begin(), names.end(), "sample") == 1);
  CHECK(std::set<std::string>(names.begin(), names.end()).size() == names.size());
}

TEST_CASE("crest --cite alone cites Crest, in the version that runs") {
  const TemporaryFolder folder;
  const auto result = run_crest("crest --cite", folder.path());
  CHECK(result.exit_code == 0);
  CHECK(result.out.find("@software{crest,") == 0);
  const std::string version = run_crest("crest --version", folder.path()).out.substr(6);
  CHECK(result.out.find("{" + version.substr(0, version.find('\n')) + "}") != std::string::npos);
  const std::string citation = read_text(fs::path(CREST_SOURCE_DIR) / "CITATION.cff");
  CHECK(citation.find("version: " + version) != std::string::npos);
}

TEST_CASE("crest --version names the version") {
  const TemporaryFolder folder;
  const auto result = run_crest("crest --version", folder.path());
  CHECK(result.exit_code == 0);
  CHECK(result.out.rfind("crest ", 0) == 0);
}

TEST_CASE("every command's help ends with examples and they run") {
  const TemporaryFolder folder;
  auto names = command_names(run_crest("crest --help", folder.path()).out);
  REQUIRE(names.size() >= 2);
  // What `sample` and `encode` write is what the other commands' examples read.
  for (const char* first : {"encode", "sample"})
    std::stable_partition(names.begin(), names.end(),
                          [&](const std::string& name) { return name == first; });
  for (const std::string& name : names) {
    const auto help = run_crest("crest " + name + " --help", folder.path());
    CHECK(help.exit_code == 0);
    const auto examples = examples_of(help.out);
    INFO(help.out);
    const auto is_control = [](unsigned char c) { return c < ' ' && c != '\n'; };
    CHECK(std::ranges::none_of(help.out, is_control));
    CHECK(help.out.find("->") == std::string::npos);
    REQUIRE(examples.size() >= 2);
    const auto lines = split_lines(help.out);
    CHECK(lines.back() == "  " + examples.back());
    for (const std::string& example : examples) {
      CHECK(example.rfind("crest " + name + " ", 0) == 0);
      const auto run = run_crest(example, folder.path());
      INFO(example << "\n" << run.err);
      CHECK(run.exit_code == 0);
    }
  }
}

TEST_CASE("every command of the README runs as it stands") {
  const TemporaryFolder folder;
  const fs::path root = CREST_SOURCE_DIR;
  bool shell = false;
  std::size_t ran = 0;
  for (const std::string& line : split_lines(read_text(root / "README.md"))) {
    if (line.rfind("```", 0) == 0) {
      shell = !shell && line == "```sh";
      continue;
    }
    if (!shell || line.empty() || line[0] == '#') continue;
    INFO(line);
    if (line.rfind("./scripts/", 0) == 0) {
      // They build: too long to run from a test, but they must be there.
      const fs::path script = root / line.substr(2, line.find(' ') - 2);
      REQUIRE(fs::exists(script));
      CHECK((fs::status(script).permissions() & fs::perms::owner_exec) != fs::perms::none);
      continue;
    }
    if (line.rfind("printf ", 0) == 0) {  // an input
      CHECK(std::system(("cd '" + std::string(folder.path()) + "' && " + line).c_str()) == 0);
      continue;
    }
    REQUIRE((line.rfind("crest ", 0) == 0 || line.rfind("crest-verify ", 0) == 0));
    const auto run = run_crest(line, folder.path());
    INFO(run.err);
    CHECK(run.exit_code == 0);
    ++ran;
  }
  CHECK(ran >= 3);
}

TEST_CASE("citing prints the BibTeX of what the run used and only that") {
  const TemporaryFolder folder;
  REQUIRE(run_crest("crest sample ellipsoid --vertices 600 -o e.off", folder.path()).exit_code ==
          0);
  const auto plain = run_crest("crest ridges e.off --quiet --cite", folder.path());
  CHECK(plain.exit_code == 0);
  CHECK(plain.out.rfind("@", 0) == 0);
  CHECK(plain.out.find("{cazals2004ridges,") != std::string::npos);
  CHECK(plain.out.find("{mcconnell2011certifying,") == std::string::npos);
  CHECK(plain.out.find("{hildebrandt2005smooth,") == std::string::npos);
  const auto more = run_crest("crest ridges e.off --quiet --cite --smooth 2 --certificate e.crest",
                              folder.path());
  CHECK(more.out.find("{mcconnell2011certifying,") != std::string::npos);
  CHECK(more.out.find("{hildebrandt2005smooth,") != std::string::npos);
  // Entries are closed: as many as begin.
  const auto lines = split_lines(more.out);
  const auto begun = std::count_if(lines.begin(), lines.end(),
                                   [](const std::string& line) { return line[0] == '@'; });
  CHECK(begun >= 5);
  CHECK(std::count(lines.begin(), lines.end(), "}") == begun);
}
