// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// crest spline of tables of samples and of saved cubic splines.
#include "cli/run.hpp"
#include "cli/spline_options.hpp"

namespace crest::cli {

/// Whether INPUT is meant for this: a table, or a cubic spline in a file.
bool is_cubic_input(const std::string& path);

Outcome run_cubic(Run& run, const SplineOptions& options);

}  // namespace crest::cli
