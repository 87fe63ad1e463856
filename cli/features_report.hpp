// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What `crest features` says about its result: the report's keys and the summary on the terminal.
#include <string>

#include "algorithms/feature_lines/feature_lines.hpp"
#include "algorithms/feature_lines/sharp_edges.hpp"
#include "certify/features_mesh/records.hpp"
#include "certify/sharp_edges/records.hpp"
#include "cli/report.hpp"
#include "cli/written.hpp"

namespace crest::cli {

/// The mesh and the lines on it, as both ways to find them have them.
void report_lines(Report& report, const kernel::TriangleMesh& mesh,
                  const feature_lines::FeatureGraph& graph);
/// Of a region that was thinned, with what the certificate states.
void report_region(Report& report, const feature_lines::FeatureLines& lines,
                   const certify::FeaturesMeshCertificate& certificate);
/// Of edges above an angle, with what the certificate states.
void report_sharp(Report& report, const feature_lines::SharpLines& lines,
                  const certify::SharpEdgesCertificate& certificate);

/// What options left out of, or changed in, what is certified.
Written written(const feature_lines::FeatureLines& lines, bool certifies);
Written written(const feature_lines::SharpLines& lines, bool certifies);

/// Three lines for the terminal, and one if options left something out.
std::string region_summary(const feature_lines::FeatureLines& lines, bool certifies);
/// Two, and one.
std::string sharp_summary(const feature_lines::SharpLines& lines, const std::string& degrees,
                          bool certifies);

}  // namespace crest::cli
