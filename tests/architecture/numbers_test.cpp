// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers that the README and experiments/README.md quote are those of the stored tables.
#include <catch2/catch.hpp>
#include <cstdio>
#include <map>
#include <set>
#include <sstream>

#include "tests/architecture/source_tree.hpp"

namespace {

using namespace crest::tests;

using Cells = std::vector<std::string>;

/// The cells of a Markdown table's line.
Cells cells_of(const std::string& line) {
  Cells cells;
  std::istringstream text(line.substr(1));
  for (std::string cell; std::getline(text, cell, '|');) {
    const auto first = cell.find_first_not_of(' '), last = cell.find_last_not_of(' ');
    cells.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
  }
  return cells;
}

/// All rows below the first table's head.
std::vector<Cells> rows_of(const std::string& table) {
  std::vector<Cells> rows;
  bool below = false;
  for (const std::string& line : lines_of("experiments/" + table)) {
    if (has_prefix(line, "|---")) below = true;
    if (!has_prefix(line, "|") && below) break;
    if (has_prefix(line, "| ") && below) rows.push_back(cells_of(line));
  }
  INFO(table);
  REQUIRE(rows.size() > 1);
  return rows;
}

std::string fixed(double x, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*f", digits, x);
  return text;
}

void quotes(const std::string& document, const std::string& sentence) {
  INFO(document << " should have: " << sentence);
  CHECK(read_text(fs::path(CREST_SOURCE_DIR) / document).find(sentence) != std::string::npos);
}

/// Least and largest, rounded.
std::string range(const std::vector<double>& values, int digits) {
  const auto [least, largest] = std::minmax_element(values.begin(), values.end());
  return fixed(*least, digits) + " to " + fixed(*largest, digits);
}

}  // namespace

TEST_CASE("quoted numbers: right Reeb graphs") {
  int right = 0, all = 0;
  std::set<std::string> kinds;
  for (const Cells& row : rows_of("003-reeb/tables/correctness.md")) {
    if (row.at(2) == "2") kinds.insert(row[0] + row[1]);
    int equal = 0, of = 0;
    if (std::sscanf(row.at(3).c_str(), "%d/%d", &equal, &of) != 2) continue;
    right += equal;
    all += of;
  }
  quotes("README.md",
         "right Reeb graphs: " + std::to_string(kinds.size()) + " kinds of surface and function");
  quotes("README.md", std::to_string(right) + " of " + std::to_string(all) + " |");
}

TEST_CASE("quoted numbers: index sums of closed meshes") {
  int meshes = 0, ours = 0, finished = 0, theirs = 0;
  for (const Cells& row : rows_of("002-ridges/tables/index.md")) {
    ++meshes;
    ours += row.at(2) == row.at(4) && row.at(6) == "accepted";
    finished += !row.at(8).empty();
    theirs += row.at(8) == row[2];
  }
  const auto share = [](int part, int whole) {
    return std::to_string(part) + " of " + std::to_string(whole);
  };
  for (const char* document : {"README.md", "experiments/README.md"}) {
    quotes(document, share(ours, meshes));
    quotes(document, share(theirs, finished));
  }
}

TEST_CASE("quoted numbers: noise on the ellipsoid") {
  int meshes = 0, ours = 0, same = 0, own = 0;
  for (const Cells& row : rows_of("002-ridges/tables/noise.md")) {
    if (row.at(0) == "0") continue;
    const bool sum = row.at(4) == "2", right = sum && row.at(3) == "4, 0, 0";
    meshes += row.at(2) == "Crest --scale auto";
    ours += right && row[2] == "Crest --scale auto";
    same += right && row[2] == "CGAL" && row.at(8) != "30";
    own += sum && row[2] == "CGAL" && row.at(8) == "30";
  }
  const std::string of = " of " + std::to_string(meshes);
  quotes("README.md", "4 umbilics, index sum 2 | " + std::to_string(ours) + of + " | " +
                          std::to_string(same) + of + " (CGAL with the same supports; " +
                          std::to_string(own) + of + " have index sum 2");
}

TEST_CASE("quoted numbers: sharp edges of fandisk") {
  const auto rows = rows_of("001-features/tables/sharp_edges.md");
  const Cells &tuned = rows.at(0), &plain = rows.at(1);
  for (const char* document : {"README.md", "experiments/README.md"}) {
    quotes(document, tuned.at(9) + " of " + tuned.at(3) + " on a line, " + tuned.at(8) +
                         " within an edge of one");
    quotes(document, plain.at(9) + " and " + plain.at(8));
  }
}

TEST_CASE("quoted numbers: topology kept by thinning") {
  std::size_t accepted = 0;
  const auto rows = rows_of("001-features/tables/betti.md");
  for (const Cells& row : rows)
    accepted += row.at(4) == row.at(5) && row.at(6) == row.at(7) && row.at(9) == "accepted";
  quotes("experiments/README.md",
         std::to_string(accepted) + " of " + std::to_string(rows.size()) + " meshes");
}

TEST_CASE("quoted numbers: VTK's time over Crest's, the checker's over the extraction's") {
  std::vector<double> ratios, quotients;
  for (const Cells& row : rows_of("peers/reeb/tables/vtk_reeb.md"))
    ratios.push_back(std::stod(row.at(5)));
  std::sort(ratios.begin(), ratios.end());
  const double median = 0.5 * (ratios[(ratios.size() - 1) / 2] + ratios[ratios.size() / 2]);
  for (const char* document : {"README.md", "experiments/README.md"})
    quotes(document, "median " + fixed(median, 0) + " times, " + range(ratios, 0));
  for (const Cells& row : rows_of("002-ridges/tables/smooth_table.md"))
    quotients.push_back(std::stod(row.at(11)));  // of processor times, one thread
  quotes("README.md", range(quotients, 2) + " of that");
}

TEST_CASE("quoted numbers: wrong nodes of linear methods") {
  std::map<int, std::vector<double>> of_right, of_own;
  double right = 0;
  for (const Cells& row : rows_of("003-reeb/tables/subdivision.md")) {
    const double nodes = std::stod(row.at(3)), wrong = std::stod(row.at(5));
    if (row.at(2) == "quadratic") {
      right = nodes;
      continue;
    }
    of_right[std::stoi(row[2])].push_back(100 * wrong / right);
    of_own[std::stoi(row[2])].push_back(100 * wrong / nodes);
  }
  const auto list = [](const std::map<int, std::vector<double>>& shares) {
    std::string text;
    for (const auto& [triangles, values] : shares)
      text += (text.empty() ? "" : ", ") + range(values, 0);
    return text;
  };
  quotes("experiments/README.md", list(of_right) + " % of the right number");
  quotes("experiments/README.md", list(of_own) + " % of the linear graph's own");
}
