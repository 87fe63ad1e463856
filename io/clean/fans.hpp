// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Vertices where several fans of faces meet.
#include "io/clean/sides.hpp"

namespace crest::io {

/// Faces that lie across sides of each other around a vertex are one fan of it. Every fan but the
/// one with the first face gets a vertex of its own, at the end, in the order of their first faces.
/// Returns how many vertices had several. Cost: O(F log F).
std::size_t split_fans(Surface& surface, const Neighbours& across);

}  // namespace crest::io
