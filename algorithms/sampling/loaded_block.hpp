// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The four loaded blocks of paper 004, section 7 and appendix B: compression, push and pull, three
// compressions, a twisting compression. The floor is clamped, square patches of the top are bonded
// to plates that move by 5 % of the height; patches and the twist's angle are ours, the paper has
// no numbers.
#include <array>
#include <string>
#include <vector>

#include "algorithms/sampling/elastic_block.hpp"
#include "kernel/arithmetic/vec3.hpp"

namespace crest::sampling {

struct Scenario {
  std::string name;          ///< single, push_pull, three, twist
  std::array<int, 3> cubes;  ///< in the paper's size
  std::string summary;
};

const std::vector<Scenario>& scenarios();

struct LoadedBlock {
  ElasticBlock block;
  std::vector<std::array<double, 6>> stress;  ///< xx yy zz xy yz xz at each node
  int iterations;
};

/// `scale`: 1 is the paper's size; cubes stay of size 1. exact: the load's symmetries are made
/// exact (the twist has none). Requires: scale > 0. Cost: about 270 iterations of the whole block.
LoadedBlock load_block(const Scenario& scenario, double scale = 1, bool exact = false);

/// Its nodes.
std::vector<kernel::Vec3> points(const ElasticBlock& block);

}  // namespace crest::sampling
