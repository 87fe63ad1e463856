// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Degenerate curves in the report and the summary of crest modes.
#include <string>

#include "algorithms/modes/degenerate_result.hpp"
#include "cli/report.hpp"

namespace crest::cli {

/// `cell_of`: tetrahedra as the file numbers cells.
Json curves_to_json(const modes::DegenerateCurves& curves,
                    const std::vector<std::int64_t>& cell_of);
/// A line a type.
std::string curves_summary(const modes::DegenerateCurves& curves);
/// What is named and not traced; empty: nothing.
std::string curves_warning(const modes::DegenerateCurves& curves);

}  // namespace crest::cli
