// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The mesh as cut: valences, components, Euler characteristics, boundaries, orientability (SPEC.md,
// "Mesh").
#include "certify/extremal/mesh.hpp"

namespace crest::certify::extremal {

/// What is kept; of a mesh that is not cut all.
struct Kept {
  std::vector<std::uint8_t> vertices;
  std::vector<std::uint8_t> fans;  ///< points on the polygons' edges
};

struct Components {
  ExtremalValences valences;
  std::vector<ExtremalComponent> list;  ///< in canonical order; neither isotopic nor extremal
  std::vector<u32> of_vertex;           ///< of those kept; kNothing
};

Components count_components(const Mesh& mesh, const Kept& kept);

}  // namespace crest::certify::extremal
