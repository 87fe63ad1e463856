// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The four loaded blocks of paper 004, section 7 and appendix B: compression, push and pull, three
// compressions, a twisting compression. The floor is clamped, square patches of the top are bonded
// to plates that move by 5 % of the height; patches and the twist's angle are ours, the paper has
// no numbers.
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "algorithms/sampling/elastic_block.hpp"

namespace crest::experiments {

using sampling::ElasticBlock;

struct Scenario {
  std::string name;
  std::array<int, 3> cubes;
  /// Prescribes the top's nodes; depth: 5 % of the height.
  std::function<void(ElasticBlock&, double depth)> load;
};

/// A square patch of the top: bonded, moved by `dz`, turned by `turn` radians.
inline void press(ElasticBlock& block, double x, double y, double half, double dz,
                  double turn = 0) {
  const auto& n = block.size();
  for (int j = 0; j <= n[1]; ++j)
    for (int i = 0; i <= n[0]; ++i) {
      const double a = i - x, b = j - y;
      if (std::fabs(a) > half || std::fabs(b) > half) continue;
      const std::size_t node = block.index(i, j, n[2]);
      block.prescribed(node, 0) = -turn * b;
      block.prescribed(node, 1) = turn * a;
      block.prescribed(node, 2) = dz;
    }
}

inline std::vector<Scenario> scenarios() {
  return {
      {"single", {40, 40, 50}, [](ElasticBlock& b, double d) { press(b, 20, 20, 8, -d); }},
      {"push_pull",
       {75, 40, 25},
       [](ElasticBlock& b, double d) {
         press(b, 18.5, 20, 6.5, -d);
         press(b, 56.5, 20, 6.5, d);
       }},
      {"three",
       {80, 40, 20},
       [](ElasticBlock& b, double d) {
         for (const int x : {14, 40, 66}) press(b, x, 20, 5, -d);
       }},
      {"twist", {36, 34, 39}, [](ElasticBlock& b, double d) { press(b, 18, 17, 8, -d, 0.1); }},
  };
}

struct LoadedBlock {
  ElasticBlock block;
  std::vector<std::array<double, 6>> stress;
  int iterations;
};

/// exact: the load's symmetries are made exact (the twist has none).
inline LoadedBlock loaded(const Scenario& s, bool exact) {
  LoadedBlock result{{s.cubes[0], s.cubes[1], s.cubes[2]}, {}, 0};
  ElasticBlock& block = result.block;
  for (int j = 0; j <= s.cubes[1]; ++j)
    for (int i = 0; i <= s.cubes[0]; ++i)
      for (std::size_t a = 0; a < 3; ++a) block.prescribed(block.index(i, j, 0), a) = 0;
  s.load(block, 0.05 * s.cubes[2]);
  result.iterations = block.solve();
  result.stress = block.nodal_stress();
  if (exact && s.name != "twist") {
    sampling::symmetrise(block, 1, 1, result.stress);
    sampling::symmetrise(block, 0, s.name == "push_pull" ? -1 : 1, result.stress);
  }
  return result;
}

}  // namespace crest::experiments
