// SPDX-License-Identifier: GPL-3.0-or-later
// experiments/README.md lists every numbered figure and table of the papers once, with a state, and
// what it shows as done is there.
#include <catch2/catch.hpp>
#include <regex>
#include <set>

#include "tests/architecture/source_tree.hpp"

namespace {

using namespace crest::tests;

/// "001 figure 3.1" of the numbers in experiments/paper_items.txt.
std::set<std::string> items_of_papers() {
  static const std::regex line(R"((\d+) (figure|table) (?:(\d+)\.)?(\d+)-(?:\d+\.)?(\d+))");
  std::set<std::string> items;
  for (const std::string& text : lines_of("experiments/paper_items.txt")) {
    if (has_prefix(text, "#")) continue;
    std::smatch m;
    INFO(text);
    REQUIRE(std::regex_match(text, m, line));
    const std::string chapter = m[3].matched ? m[3].str() + "." : "";
    for (int n = std::stoi(m[4]); n <= std::stoi(m[5]); ++n)
      items.insert(m[1].str() + " " + m[2].str() + " " + chapter + std::to_string(n));
  }
  return items;
}

void check_links(const std::string& text) {
  static const std::regex link(R"(\]\(([^)]+)\))");
  for (std::sregex_iterator at(text.begin(), text.end(), link), end; at != end; ++at) {
    INFO(text);
    CHECK(fs::exists(fs::path(CREST_SOURCE_DIR) / "experiments" / (*at)[1].str()));
  }
}

}  // namespace

TEST_CASE("every figure and table of the papers has one row and a state") {
  static const std::set<std::string> states = {"done", "stand-in", "sketch", "missing",
                                               "not built"};
  static const std::regex row(R"(\| (\d+ (?:figure|table) [\d.]+) \| ([^|]+) \| (.*) \|)");
  std::set<std::string> open = items_of_papers();
  CHECK(open.size() > 120);
  for (const std::string& text : lines_of("experiments/README.md")) {
    std::smatch m;
    if (!std::regex_match(text, m, row)) continue;
    INFO(text);
    CHECK(open.erase(m[1]) == 1);
    CHECK(states.count(m[2]) == 1);
    check_links(text);
  }
  for (const std::string& item : open) FAIL_CHECK(item << " has no row");
}
