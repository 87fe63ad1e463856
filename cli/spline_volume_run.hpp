// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// crest spline of volumes and of saved quadratic splines.
#include "cli/run.hpp"
#include "cli/spline_options.hpp"

namespace crest::cli {

Outcome run_volume(Run& run, const SplineOptions& options);

}  // namespace crest::cli
