// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What `crest reeb` says about its result: the report's keys and the summary on the terminal.
#include <string>
#include <vector>

#include "algorithms/reeb/reeb_graph.hpp"
#include "algorithms/reeb/tile_complex.hpp"
#include "cli/report.hpp"
#include "cli/written.hpp"
#include "io/reeb/reeb_writer.hpp"

namespace crest::cli {

struct LevelCount {
  double level;
  std::size_t paths, cycles;
};

/// Everything the report speaks about.
struct ReebRun {
  const kernel::QuadraticMesh& mesh;
  const reeb::TileComplex& tiles;
  const reeb::PredicateReport& predicates;
  const reeb::ReebGraph& graph;    ///< of all critical nodes
  const reeb::ReebGraph& written;  ///< after simplifying and contracting
  const std::vector<io::TreeLines>& trees;
  const std::string& function;
  const std::vector<LevelCount>& levels;
  bool certified;                                 ///< `graph` has a certificate
  const std::vector<std::string>& simplified_by;  ///< options by which `written` is less
};

void fill_report(Report& report, const ReebRun& run);

/// Four lines or a few more for the terminal.
std::string summary_text(const ReebRun& run);

}  // namespace crest::cli
