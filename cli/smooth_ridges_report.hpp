// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What `crest ridges --surface` and `--param` say about their result.
#include <string>

#include "algorithms/smooth_ridges/smooth_ridges.hpp"
#include "cli/colour_summary.hpp"
#include "cli/report.hpp"

namespace crest::cli {

struct SmoothRidgesRun {
  const smooth_ridges::Surface& surface;
  const smooth_ridges::SmoothRidges& result;
  std::size_t certificate_bytes;  ///< 0 if there is none
  std::string data_digest;        ///< hex, or empty
};

/// A segment with a turning point is halved.
ColourSummary summarise(const smooth_ridges::SmoothRidges& result, smooth_ridges::Colour colour);

/// All keys but those of the certificate's file (Report::set_certificate).
void fill_report(Report& report, const SmoothRidgesRun& run);

/// For the terminal: the counts, then "certified" or "NOT CERTIFIED: ..." with the reasons and the
/// first cells.
std::string summary_text(const SmoothRidgesRun& run);

/// 1234567 as "1 234 567".
std::string grouped(std::size_t number);

}  // namespace crest::cli
