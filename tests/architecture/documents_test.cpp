// SPDX-License-Identifier: GPL-3.0-or-later
// What the indexes name exists: kernel/README.md, the systems' READMEs, docs/glossary.md; and a
// named rule is found by one grep.
#include <catch2/catch.hpp>
#include <cctype>
#include <set>

#include "tests/architecture/source_tree.hpp"

namespace {

using namespace crest::tests;

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

bool is_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

/// grep -i of the phrase as words, a plural allowed: whether the line has it.
bool line_has(const std::string& line, const std::string& phrase) {
  const std::string text = lower(line) + "  ", words = lower(phrase);
  for (auto at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) {
    auto end = at + words.size();
    end += text[end] == 's' ? 1 : text.compare(end, 2, "es") == 0 ? 2 : 0;
    if ((at == 0 || !is_letter(text[at - 1])) && !is_letter(text[end])) return true;
  }
  return false;
}

bool any_line_has(const std::vector<std::string>& lines, const std::string& phrase) {
  return std::any_of(lines.begin(), lines.end(),
                     [&](const std::string& line) { return line_has(line, phrase); });
}

/// The comment that says what a header is about: the first one after its guard.
std::vector<std::string> first_comment(const std::string& path) {
  std::vector<std::string> comment;
  bool guarded = false;
  for (const std::string& line : lines_of(path)) {
    guarded |= line == "#pragma once";
    if (!guarded) continue;
    if (has_prefix(line, "//"))
      comment.push_back(line);
    else if (!comment.empty())
      break;
  }
  return comment;
}

/// Runs of path characters that end as C++ files do.
std::set<std::string> named_files(const std::string& text) {
  std::set<std::string> named;
  std::string word;
  for (const char c : text + " ") {
    if (std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '/' || c == '.') {
      word += c;
      continue;
    }
    if (is_cpp(word)) named.insert(word);
    word.clear();
  }
  return named;
}

bool exists(const std::string& path) {
  return fs::exists(fs::path(CREST_SOURCE_DIR) / path);
}

struct Row {
  std::string word, meaning, file;
};

/// The glossary's table.
std::vector<Row> glossary() {
  std::vector<Row> rows;
  for (const std::string& line : lines_of("docs/glossary.md")) {
    std::vector<std::string> cells;
    for (std::size_t at = 0, bar = line.find('|'); bar != std::string::npos;
         at = bar + 1, bar = line.find('|', at)) {
      std::string cell = line.substr(at, bar - at);
      cell.erase(0, cell.find_first_not_of(' '));
      cell.erase(cell.find_last_not_of(' ') + 1);
      cells.push_back(cell);
    }
    if (cells.size() == 4 && cells[1] != "word" && cells[1] != "---")
      rows.push_back({cells[1], cells[2], cells[3]});
  }
  return rows;
}

}  // namespace

TEST_CASE("the kernel's index names files that exist and every header of the kernel") {
  std::set<std::string> named;
  for (const std::string& path :
       named_files(read_text(fs::path(CREST_SOURCE_DIR) / "kernel/README.md")))
    named.insert(has_prefix(path, "kernel/") ? path.substr(7) : path);
  CHECK(named.size() >= 5);
  for (const std::string& path : named) {
    INFO("kernel/README.md names " << path);
    CHECK(exists("kernel/" + path));
  }
  for (const std::string& path : project_files()) {
    if (!has_prefix(path, "kernel/") || !has_suffix(path, ".hpp")) continue;
    INFO(path << " is not in kernel/README.md");
    CHECK(named.count(path.substr(7)) == 1);
  }
}

TEST_CASE("every system has a README that names all its headers, and files that exist") {
  std::set<std::string> systems;
  for (const std::string& path : project_files())
    if (has_prefix(path, "algorithms/") && path.find('/', 11) != std::string::npos)
      systems.insert(path.substr(0, path.find('/', 11)));
  CHECK(systems.size() >= 6);
  for (const std::string& system : systems) {
    INFO(system);
    REQUIRE(exists(system + "/README.md"));
    const auto named = named_files(read_text(fs::path(CREST_SOURCE_DIR) / system / "README.md"));
    for (const std::string& path : named) {
      INFO("its README names " << path);
      CHECK((exists(system + "/" + path) || exists(path) || exists("kernel/predicates/" + path)));
    }
    for (const std::string& path : project_files()) {
      if (!has_prefix(path, system + "/") || !has_suffix(path, ".hpp")) continue;
      INFO(path << " is not in the README");
      CHECK(named.count(fs::path(path).filename().string()) + named.count(path) > 0);
    }
  }
}

TEST_CASE("the glossary is sorted, and grep finds each word in the file beside it") {
  const auto rows = glossary();
  CHECK(rows.size() >= 40);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    INFO(rows[i].word << " in " << rows[i].file);
    CHECK_FALSE(rows[i].meaning.empty());
    if (i > 0) CHECK(lower(rows[i - 1].word) < lower(rows[i].word));
    REQUIRE(exists(rows[i].file));
    CHECK(any_line_has(lines_of(rows[i].file), rows[i].word));
  }
  for (const char* word : {"purple point", "umbilic index", "strand", "cut", "acute rule", "tile",
                           "conflict triangle", "foot", "blow-up", "umbilic patch"}) {
    INFO(word);
    CHECK(std::count_if(rows.begin(), rows.end(),
                        [&](const Row& row) { return row.word == word; }) == 1);
  }
}

TEST_CASE("one grep of the headers finds where each of twenty rules is defined") {
  const std::pair<const char*, const char*> rules[] = {
      {"acute rule", "kernel/predicates/acute_rule.hpp"},
      {"sign of an extremality", "kernel/predicates/extremality_sign.hpp"},
      {"elliptic or hyperbolic at a crossing", "kernel/predicates/crossing_type.hpp"},
      {"det rule", "kernel/predicates/segment_type.hpp"},
      {"index of a triangle", "kernel/predicates/rotation.hpp"},
      {"umbilic kind", "kernel/predicates/umbilic_kind.hpp"},
      {"line-critical point", "kernel/predicates/line_critical.hpp"},
      {"face-critical point", "kernel/predicates/face_critical.hpp"},
      {"boundary saddle", "kernel/predicates/boundary_saddle.hpp"},
      {"equal values by number", "kernel/predicates/critical_value_order.hpp"},
      {"symbolic perturbation", "kernel/predicates/symbolic.hpp"},
      {"area exactly zero", "kernel/predicates/collinear.hpp"},
      {"conflict triangle", "algorithms/ridges/edge_states.hpp"},
      {"umbilic patch", "algorithms/ridges/umbilics.hpp"},
      {"coherent", "algorithms/ridges/umbilics.hpp"},
      {"simple vertex", "algorithms/feature_lines/skeleton.hpp"},
      {"strand", "algorithms/reeb/strands.hpp"},
      {"monotone tile", "algorithms/reeb/tile_complex.hpp"},
      {"cut", "algorithms/reeb/cuts.hpp"},
      {"purple point", "algorithms/smooth_ridges/face_test.hpp"},
      {"turning point", "algorithms/smooth_ridges/face_test.hpp"},
      {"chart conditions", "algorithms/smooth_ridges/chart.hpp"},
      {"blow-up", "algorithms/smooth_ridges/blow_up.hpp"},
  };
  CHECK(std::size(rules) >= 20);
  for (const auto& [phrase, header] : rules) {
    INFO(phrase << " in the first comment of " << header);
    REQUIRE(exists(header));
    CHECK(any_line_has(first_comment(header), phrase));
  }
}
