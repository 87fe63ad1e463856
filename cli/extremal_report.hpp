// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The report and the summary of crest extremal.
#include <string>
#include <vector>

#include "algorithms/extremal/extremal_result.hpp"
#include "cli/report.hpp"

namespace crest::cli {

void fill_report(Report& report, const extremal::Result& result);

/// What a user should know of the result, a line each.
std::vector<std::string> extremal_warnings(const extremal::Result& result);

std::string extremal_summary(const extremal::Result& result);

}  // namespace crest::cli
