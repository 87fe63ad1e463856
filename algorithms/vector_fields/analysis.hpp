// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// All that is found of a field, with what proves it.
#include "algorithms/vector_fields/sectors.hpp"
#include "algorithms/vector_fields/trace.hpp"

namespace crest::vector_fields {

struct Analysis {
  /// doors: where annuli are looked for first. Requires: `field` outlives the analysis.
  explicit Analysis(const PlanarField& field, const std::vector<AnnulusDoor>& doors = {});
  Skeleton skeleton() const;

  Domain domain;
  std::vector<ZeroComponent> zeros;
  std::vector<FanPortrait> portraits;  ///< one a zero
  Boundary boundary;
  std::unordered_map<Index, Trap> traps;
  std::vector<Annulus> annuli;
  std::vector<Trace> traces;
};

}  // namespace crest::vector_fields
