// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The report and the summary of crest lineart.
#include <string>

#include "algorithms/line_art/line_art_result.hpp"
#include "cli/report.hpp"

namespace crest::cli {

void report_line_art(Report& report, const line_art::Drawing& drawing);

std::string line_art_summary(const line_art::Drawing& drawing);

}  // namespace crest::cli
