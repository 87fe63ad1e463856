// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Numbers along a ridge: position and quantities of a crossing, length, strength, sharpness.
#include "algorithms/ridges/edge_states.hpp"

namespace crest::ridges {

/// Position of the crossing of edge (p, q) between p (0) and q (1): equation 4 of paper 002, 1/2
/// when both extremalities are zero.
double crossing_weight(const kernel::TriangleMesh& mesh,
                       const std::vector<kernel::MongeForm>& forms, Index edge, Colour colour);

/// Everything of a crossing but its type; quantities are interpolated with the same weight.
Crossing measure_crossing(const kernel::TriangleMesh& mesh,
                          const std::vector<kernel::MongeForm>& forms, Index edge, Colour colour);

/// The length that makes sharpness free of units: the largest distance of a vertex from the mean of
/// all vertices. Invariant under rigid motions.
double model_size(const kernel::TriangleMesh& mesh);

/// Fills length, elliptic_length, hyperbolic_length (the drawn lines inside patches count as
/// hyperbolic: section 6.5), strength and sharpness (section 7.2; trapezoidal rule between
/// crossings). A turning segment is divided where its linear P is zero.
void measure_ridge(Ridge& ridge, double model_size);

}  // namespace crest::ridges
