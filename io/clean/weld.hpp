// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Vertices close to each other become one.
#include "io/clean/surface.hpp"

namespace crest::io {

/// First come: in the order of the vertices each joins the lowest one that stays within `distance`
/// of it (decided exactly), or else stays; 0: equal ones. So no vertex moves farther than that, and
/// whatever is farther apart than twice the distance is not joined through others.
/// Returns how many joined another; they are gone, faces may then repeat corners.
/// Requires: finite points, distance >= 0.
/// Cost: O(V log V) where few vertices that stay are within some distances of each other: their
/// number is bounded, they are farther apart than the distance.
std::size_t weld(Surface& surface, double distance);

}  // namespace crest::io
