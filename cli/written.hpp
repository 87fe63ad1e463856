// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What a run writes, set beside what its certificate states: options may leave parts out.
#include <string>
#include <vector>

#include "cli/report.hpp"

namespace crest::cli {

struct Written {
  std::string kind = "subset";  ///< or "simplification"
  std::string whole;            ///< of what: "graph", "certified graph"
  std::string share;            ///< "405 of 599 ridges"
  std::vector<std::string> by;  ///< the options that made it one; none: all is written
};

/// The word for the whole: with "certified" before it if a certificate of it is written.
std::string whole(const std::string& what, bool certifies);

/// The keys `subset`, `subset_by` and `counts` (what a certificate states) of `certificate`.
void add_written(Report& report, const std::vector<std::string>& by, Json counts);

/// The summary's line, empty if all is written:
/// "written: a subset of the certified graph: 405 of 599 ridges (--min-sharpness)".
std::string written_line(const Written& written);

/// For a picture's legend, empty if all is drawn: "subset by --min-sharpness".
std::string legend_note(const std::string& kind, const std::vector<std::string>& by);

}  // namespace crest::cli
