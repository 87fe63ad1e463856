// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What `crest ridges` says about its result: the report's keys and the summary on the terminal.
#include <string>

#include "algorithms/ridges/ridges.hpp"
#include "cli/colour_summary.hpp"
#include "cli/report.hpp"
#include "io/clean/surface.hpp"

namespace crest::cli {

/// Everything the report speaks about. `graph` is what is written (after the filters).
struct RidgesRun {
  const kernel::TriangleMesh& mesh;
  const io::FileNumbers& numbers;
  const ridges::FitResult& fit;
  const ridges::RidgeGraph& graph;
  const ridges::FilterReport& dropped;
  const ridges::PredicateReport& predicates;
  int order;                ///< 3 or 4: the rule behind elliptic_length and hyperbolic_length
  std::string data_digest;  ///< hex
};

/// Types by the fourth-order rule (a segment whose ends differ is halved) or by the third-order
/// rule; flat and undecided segments count in neither.
ColourSummary summarise(const ridges::RidgeGraph& graph, ridges::Colour colour, int order);

void fill_report(Report& report, const RidgesRun& run);
void add_paper_umbilics(Report& report, const ridges::PaperUmbilics& umbilics);

/// Five lines or fewer for the terminal, units of the input.
std::string summary_text(const RidgesRun& run);

}  // namespace crest::cli
