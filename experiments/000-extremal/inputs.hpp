// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Volumes as the extraction takes them.
#include <string>
#include <variant>
#include <vector>

#include "algorithms/extremal/extremal.hpp"
#include "algorithms/sampling/phantoms.hpp"

namespace crest::experiments {

/// In the grid's own frame.
inline extremal::Volume volume_of(const kernel::SampledGrid& grid) {
  extremal::Volume volume;
  for (std::size_t k = 0; k < 3; ++k) volume.size[k] = static_cast<kernel::Index>(grid.size[k]);
  volume.spacing = grid.spacing;
  std::visit([&](const auto& x) { volume.samples = std::vector<double>(x.begin(), x.end()); },
             grid.samples);
  return volume;
}

inline extremal::Volume phantom(const std::string& name, std::size_t nodes) {
  return volume_of(sampling::volume_phantom(name, nodes));
}

inline extremal::Options ridge_options(bool hessian, double min_value, double min_strength = 0) {
  extremal::Options options;
  options.definition = hessian ? extremal::Definition::hessian : extremal::Definition::structure;
  options.min_value = min_value;
  options.min_strength = min_strength;
  return options;
}

}  // namespace crest::experiments
