// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/sampling/loaded_block.hpp"

#include <algorithm>
#include <cmath>

namespace crest::sampling {
namespace {

/// In cubes of the paper's size.
struct Plate {
  double x, y, half, turn = 0;
  int direction = -1;  ///< +1: pulled
};

std::vector<Plate> plates(const std::string& name) {
  if (name == "single") return {{20, 20, 8}};
  if (name == "push_pull") return {{18.5, 20, 6.5}, {56.5, 20, 6.5, 0, 1}};
  if (name == "three") return {{14, 20, 5}, {40, 20, 5}, {66, 20, 5}};
  return {{18, 17, 8, 0.1}};
}

/// Bonds a square of the top to a plate that moves by `depth` and turns by `turn` radians.
void press(ElasticBlock& block, const Scenario& s, const Plate& plate, double depth) {
  const auto& n = block.size();
  const double sx = static_cast<double>(n[0]) / s.cubes[0],
               sy = static_cast<double>(n[1]) / s.cubes[1];
  for (int j = 0; j <= n[1]; ++j)
    for (int i = 0; i <= n[0]; ++i) {
      const double a = i - plate.x * sx, b = j - plate.y * sy;
      if (std::fabs(a) > plate.half * sx || std::fabs(b) > plate.half * sy) continue;
      const std::size_t node = block.index(i, j, n[2]);
      block.prescribed(node, 0) = -plate.turn * b;
      block.prescribed(node, 1) = plate.turn * a;
      block.prescribed(node, 2) = plate.direction * depth;
    }
}

}  // namespace

const std::vector<Scenario>& scenarios() {
  static const std::vector<Scenario> list = {
      {"single", {40, 40, 50}, "compressed by a plate"},
      {"push_pull", {75, 40, 25}, "pushed by one plate, pulled by another"},
      {"three", {80, 40, 20}, "compressed by three plates"},
      {"twist", {36, 34, 39}, "compressed by a plate that turns"}};
  return list;
}

LoadedBlock load_block(const Scenario& s, double scale, bool exact) {
  std::array<int, 3> n{};
  for (std::size_t k = 0; k < 3; ++k)
    n[k] = std::max(2, static_cast<int>(std::lround(scale * s.cubes[k])));
  LoadedBlock result{{n[0], n[1], n[2]}, {}, 0};
  ElasticBlock& block = result.block;
  for (int j = 0; j <= n[1]; ++j)
    for (int i = 0; i <= n[0]; ++i)
      for (std::size_t a = 0; a < 3; ++a) block.prescribed(block.index(i, j, 0), a) = 0;
  for (const Plate& plate : plates(s.name)) press(block, s, plate, 0.05 * n[2]);
  result.iterations = block.solve();
  result.stress = block.nodal_stress();
  if (exact && s.name != "twist") {
    symmetrise(block, 1, 1, result.stress);
    symmetrise(block, 0, s.name == "push_pull" ? -1 : 1, result.stress);
  }
  return result;
}

std::vector<kernel::Vec3> points(const ElasticBlock& block) {
  const auto& n = block.size();
  std::vector<kernel::Vec3> list;
  for (int k = 0; k <= n[2]; ++k)
    for (int j = 0; j <= n[1]; ++j)
      for (int i = 0; i <= n[0]; ++i)
        list.push_back({static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)});
  return list;
}

}  // namespace crest::sampling
