// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What `crest features` says about its result: the report's keys and the summary on the terminal.
#include <string>

#include "algorithms/feature_lines/feature_lines.hpp"
#include "algorithms/feature_lines/sharp_edges.hpp"
#include "cli/report.hpp"

namespace crest::cli {

/// The mesh and the lines on it, as both ways to find them have them.
void report_lines(Report& report, const kernel::TriangleMesh& mesh,
                  const feature_lines::FeatureGraph& graph);
/// Of a region that was thinned.
void report_region(Report& report, const feature_lines::FeatureLines& lines);
/// Of edges above an angle.
void report_sharp(Report& report, const feature_lines::SharpLines& lines);

/// Three lines for the terminal.
std::string region_summary(const feature_lines::FeatureLines& lines);
/// Two.
std::string sharp_summary(const feature_lines::SharpLines& lines, const std::string& degrees);

}  // namespace crest::cli
