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

/// Why a table is not made anew yet.
constexpr const char* kTimes = "times: it wants a quiet machine";
constexpr const char* kMinutes = "many minutes of work";
constexpr const char* kPeer = "it wants the peer's program";

/// Of experiments/, without .md. A table that is made anew leaves the list.
const std::map<std::string, const char*> kExceptions = {
    {"000-extremal/tables/scaling", kTimes},
    {"001-curvature/tables/curvature_speed", kTimes},
    {"001-curvature/tables/curvature_speed_all", kTimes},
    {"001-features/tables/thinning_speed", kTimes},
    {"001-line-art/tables/contour_table", kTimes},
    {"001-line-art/tables/line_figures", kMinutes},
    {"002-ridges/tables/mesh_ranks", kTimes},
    {"002-ridges/tables/recheck", kTimes},
    {"002-ridges/tables/salience", kMinutes},
    {"002-ridges/tables/smooth_phases", kTimes},
    {"003-reeb/tables/checker_cost", kTimes},
    {"003-reeb/tables/growth", kTimes},
    {"003-reeb/tables/pipeline_speed", kTimes},
    {"004-modes/tables/blocks", kTimes},
    {"004-modes/tables/marching_peer", kTimes},
    {"peers/coding/tables/draco", kPeer},
    {"peers/extremal/tables/teem", kPeer},
    {"peers/reeb/tables/vtk_reeb", kTimes},
    {"peers/ridges/tables/ellipsoid-159k", kTimes},
    {"peers/splines/tables/multilevel", kTimes},
    {"peers/splines/tables/volume_peers", kTimes},
};

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
    const auto exception = kExceptions.find(path.substr(12, path.size() - 15));
    const bool open = exception != kExceptions.end();
    INFO((open ? exception->second : "not excepted"));
    excepted += open;
    CHECK(lacking(lines[0]).empty() != open);
  }
  CHECK(tables > 60);
  CHECK(excepted == kExceptions.size());
}
