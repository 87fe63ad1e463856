// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Do faces go through one another: where none do, a hatch stays on one sheet (theorem 2).
#include <optional>
#include <utility>

#include "algorithms/line_art/scene.hpp"

namespace crest::line_art {

/// Two faces that have more in common than their common vertices and edges, exactly: closed
/// triangles are compared, and a face without area counts as such a pair with itself. Nothing:
/// every pair was looked at. The pair that is found is the lowest. Cost: linear in the faces, for
/// faces of about one size.
std::optional<std::pair<Index, Index>> meeting_faces(const Scene& scene);

}  // namespace crest::line_art
