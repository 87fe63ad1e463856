// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/extremal/sampled_grid.hpp"

namespace crest::extremal {

Volume volume_of(const kernel::SampledGrid& grid) {
  Volume volume;
  for (std::size_t k = 0; k < 3; ++k) volume.size[k] = static_cast<kernel::Index>(grid.size[k]);
  volume.spacing = grid.spacing;
  std::visit(
      [&](const auto& x) {
        using Native = typename std::decay_t<decltype(x)>::value_type;
        if constexpr (sizeof(Native) <= 2 || std::is_same_v<Native, float>)
          volume.samples = std::vector<float>(x.begin(), x.end());
        else
          volume.samples = std::vector<double>(x.begin(), x.end());
      },
      grid.samples);
  return volume;
}

void move_to_world(const kernel::SampledGrid& grid, Result& result) {
  for (auto& p : result.points) p = grid.to_world(p);
  for (auto& n : result.normals) n = grid.direction_to_world(n);
  for (auto& e : result.undecided) {
    e.a = grid.to_world(e.a);
    e.b = grid.to_world(e.b);
  }
}

}  // namespace crest::extremal
