// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// All that is found of a field, with what proves it.
#include "algorithms/vector_fields/sectors.hpp"
#include "algorithms/vector_fields/witnesses.hpp"

namespace crest::vector_fields {

struct Analysis {
  /// Requires: `field` outlives the analysis.
  explicit Analysis(const PlanarField& field);
  /// doors: where annuli are looked for first; witnesses: those to follow.
  Analysis(const PlanarField& field, const std::vector<AnnulusDoor>& doors,
           const std::vector<Witness>& witnesses);
  Skeleton skeleton() const;

  Domain domain;
  std::vector<ZeroComponent> zeros;
  std::vector<FanPortrait> portraits;  ///< one a zero
  Boundary boundary;
  std::unordered_map<Index, Trap> traps;
  std::vector<Annulus> annuli;
  std::vector<Trace> traces;  ///< of the separatrices, then of the witnesses
  std::vector<Witness> witnesses;

 private:
  Analysis(const PlanarField& field, const std::vector<AnnulusDoor>& doors,
           const std::vector<Witness>* given);
};

}  // namespace crest::vector_fields
