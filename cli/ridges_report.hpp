// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What `crest ridges` says about its result: the report's keys and the summary on the terminal.
#include <optional>
#include <string>

#include "algorithms/ridges/auto_scale.hpp"
#include "algorithms/ridges/salience.hpp"
#include "cli/colour_summary.hpp"
#include "cli/report.hpp"
#include "cli/written.hpp"
#include "io/clean/surface.hpp"

namespace crest::cli {

/// How many ridges by colour, and umbilics.
struct GraphCounts {
  ridges::Index loops[2] = {0, 0}, segments[2] = {0, 0}, umbilics = 0;
  ridges::Index ridges() const { return loops[0] + loops[1] + segments[0] + segments[1]; }
};
GraphCounts count(const ridges::RidgeGraph& graph);

/// The filter that keeps what has at least this level of salience.
ridges::FilterOptions at_level(int level);

/// Everything the report speaks about. `graph` is what is written (after the filters).
struct RidgesRun {
  const kernel::TriangleMesh& mesh;
  const io::FileNumbers& numbers;
  const ridges::FitResult& fit;
  const ridges::RidgeGraph& graph;
  const ridges::FilterOptions& filter;
  const ridges::FilterReport& dropped;
  const ridges::PredicateReport& predicates;
  int order;                ///< 3 or 4: the rule behind elliptic_length and hyperbolic_length
  std::string data_digest;  ///< hex
  GraphCounts whole;        ///< of the graph before the filters, which a certificate is about
  const std::optional<ridges::SalienceReport>& salience;
  const ridges::SalienceOptions& salience_options;
  const ridges::SupportChoice& choice;  ///< without trials: the support was given
  bool shows_salience;                  ///< the summary counts salient and significant ridges
  bool certifies;                       ///< a certificate is written

  /// The options by which ridges were dropped or cut.
  std::vector<std::string> filtered_by() const;
};

/// Types by the fourth-order rule (a segment whose ends differ is halved) or by the third-order
/// rule; flat and undecided segments count in neither.
ColourSummary summarise(const ridges::RidgeGraph& graph, ridges::Colour colour, int order);

void fill_report(Report& report, const RidgesRun& run);
void add_paper_umbilics(Report& report, const ridges::PaperUmbilics& umbilics);

/// A few lines for the terminal, units of the input.
std::string summary_text(const RidgesRun& run);

}  // namespace crest::cli
