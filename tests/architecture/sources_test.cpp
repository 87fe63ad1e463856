// SPDX-License-Identifier: GPL-3.0-or-later
// What every source file of the project has in common.
#include <catch2/catch.hpp>
#include <cctype>
#include <map>
#include <regex>

#include "tests/architecture/source_tree.hpp"

namespace {

using namespace crest::tests;

bool needs_licence_line(const std::string& path) {
  return is_cpp(path) || has_suffix(path, ".cmake") || has_suffix(path, ".sh") ||
         has_suffix(path, ".in") || has_suffix(path, "CMakeLists.txt") || path == ".ci/run" ||
         path == ".clang-tidy";
}

}  // namespace

TEST_CASE("every source names its licence in the first two lines") {
  // In two parts, lest `reuse` takes it for this file's own.
  const std::string tag =
      "SPDX-License-"
      "Identifier: GPL-3.0-or-later";
  std::size_t sources = 0;
  for (const std::string& path : project_files()) {
    if (!needs_licence_line(path)) continue;
    const auto lines = lines_of(path);
    INFO(path);
    REQUIRE(lines.size() >= 2);
    // Shell scripts have their interpreter first.
    CHECK((lines[0].find(tag) != std::string::npos || lines[1].find(tag) != std::string::npos));
    ++sources;
  }
  CHECK(sources > 40);
}

TEST_CASE("names of source files are snake_case") {
  for (const std::string& path : project_files()) {
    if (!is_cpp(path)) continue;
    const std::string name = fs::path(path).stem().string();
    INFO(path);
    CHECK(std::all_of(name.begin(), name.end(), [](unsigned char c) {
      return std::islower(c) || std::isdigit(c) || c == '_';
    }));
  }
}

TEST_CASE("loops of systems on all cores have stop points") {
  std::size_t loops = 0;
  for (const std::string& path : project_files()) {
    if (!is_cpp(path) || !has_prefix(path, "algorithms/")) continue;
    for (const std::string& line : lines_of(path)) {
      INFO(path << ": " << line);
      for (const char* loop : {"parallel_for(", "parallel_reduce(", "parallel_invoke("}) {
        CHECK(line.find("tbb::" + std::string(loop)) == std::string::npos);
        loops += line.find("kernel::" + std::string(loop)) != std::string::npos ? 1 : 0;
      }
    }
  }
  CHECK(loops > 40);
}

TEST_CASE("no class is defined in two headers") {
  // A program that includes both has undefined behaviour, and no tool of the build says so.
  const std::regex opens("^namespace ([\\w:]+) \\{"), closes("^\\}  // namespace"),
      defines("^(?:class|struct|enum class) (\\w+)(?: final)?(?: :[^;]*)? \\{$");
  std::map<std::string, std::string> first;
  for (const std::string& path : project_files()) {
    if (!has_suffix(path, ".hpp")) continue;
    std::vector<std::string> spaces;
    for (const std::string& line : lines_of(path)) {
      std::smatch found;
      if (std::regex_search(line, found, opens)) {
        spaces.push_back(found[1]);
      } else if (std::regex_search(line, closes)) {
        if (!spaces.empty()) spaces.pop_back();
      } else if (std::regex_match(line, found, defines)) {
        std::string name = found[1];
        for (const std::string& space : spaces) name = space + "::" + name;
        const auto [at, is_new] = first.emplace(name, path);
        INFO(name << " stands in " << at->second << " and in " << path);
        CHECK(is_new);
      }
    }
  }
  CHECK(first.size() > 500);
}

TEST_CASE("names of test cases are read alike by CTest and Catch2") {
  // A semicolon splits a CMake list; the others mean something in a Catch2 test specification.
  std::size_t cases = 0;
  for (const std::string& path : project_files()) {
    if (!has_prefix(path, "tests/") || !has_suffix(path, ".cpp")) continue;
    const std::string text = read_text(fs::path(CREST_SOURCE_DIR) / path);
    const std::string macro = std::string("TEST_") + "CASE(";
    for (auto at = text.find(macro); at != std::string::npos; at = text.find(macro, at + 1)) {
      const auto quote = text.find_first_not_of(" \n", at + macro.size());
      if (quote == std::string::npos || text[quote] != '"') continue;
      const std::string name = text.substr(quote + 1, text.find('"', quote + 1) - quote - 1);
      INFO(path << ": " << name);
      CHECK(name.find_first_of(";[]\\*~") == std::string::npos);
      CHECK_FALSE(has_prefix(name, "-"));
      ++cases;
    }
  }
  CHECK(cases > 20);
}

TEST_CASE("every header is guarded by #pragma once") {
  for (const std::string& path : project_files()) {
    if (!has_suffix(path, ".hpp")) continue;
    const auto lines = lines_of(path);
    INFO(path);
    CHECK(std::count(lines.begin(), lines.end(), "#pragma once") == 1);
  }
}

TEST_CASE("no source depends on where somebody's copy lives") {
  // Put together here so that this file passes its own test.
  const std::string slash = "/";
  const std::vector<std::string> places = {slash + "home" + slash, slash + "root" + slash,
                                           slash + "work" + slash};
  for (const std::string& path : project_files()) {
    if (!needs_licence_line(path) && !has_suffix(path, ".md")) continue;
    std::size_t number = 0;
    for (const std::string& line : lines_of(path)) {
      ++number;
      for (const std::string& place : places) {
        INFO(path << ":" << number << ": " << line);
        CHECK(line.find(place) == std::string::npos);
      }
    }
  }
}
