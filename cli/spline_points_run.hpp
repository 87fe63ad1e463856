// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// --evaluate and --values of crest spline.
#include <functional>
#include <span>
#include <vector>

#include "algorithms/splines/value_and_gradient.hpp"
#include "cli/run.hpp"
#include "cli/spline_options.hpp"

namespace crest::cli {

using SplineValues =
    std::function<std::vector<splines::ValueAndGradient>(std::span<const kernel::Vec3>)>;

/// Reads the points, writes the table of values and gradients and reports it. Points outside of the
/// domain have `nan`, and a warning counts them. Nothing happens without --evaluate.
void evaluate_points(Run& run, const SplineOptions& options, const SplineValues& evaluate);

/// Points of the columns x, y, z.
std::vector<kernel::Vec3> points_of(const std::vector<std::vector<double>>& columns);

}  // namespace crest::cli
