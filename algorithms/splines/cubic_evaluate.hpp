// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Cubic splines at points.
#include <span>
#include <utility>
#include <vector>

#include "algorithms/splines/cubic_model.hpp"
#include "algorithms/splines/value_and_gradient.hpp"

namespace crest::splines {

/// Rounded as de Casteljau's rule rounds: not C1 to the last digit (README.md beside this file).
ValueAndGradient evaluate(const CubicModel& model, const Vec3& point);

/// At many points, in parallel.
std::vector<ValueAndGradient> evaluate(const CubicModel& model, std::span<const Vec3> points);

/// The least and the largest Bernstein coefficient of all tetrahedra, between which s stays.
std::pair<double, double> coefficient_range(const CubicModel& model);

}  // namespace crest::splines
