// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Numbers of the partition's edges for a walk through the cubes, layer after layer along the third
// axis. An edge is known by a cube that has it and its slot there, that of its middle coefficient.
#include <vector>

#include "algorithms/splines/quadratic.hpp"
#include "kernel/geometry/index.hpp"

namespace crest::splines {

/// Of a cube's edges those in its three lower faces, without what upper faces have, are its own;
/// others may be had by another cube, but for those inside.
inline constexpr std::size_t kSharedEdges = 15, kInnerEdges = 14;
struct EdgePlace {
  std::uint8_t x, y, z;  ///< whose edge it is: 0 the cube's, 1 the next one's along the axis
  std::uint8_t number;   ///< shared ones first
};

/// By slot.
constexpr std::array<EdgePlace, 125> make_edge_places() {
  std::array<EdgePlace, 125> places{};
  std::array<std::uint8_t, 64> number{};
  std::uint8_t shared = 0, inner = kSharedEdges;
  // The cube's own first; the others have the numbers of these.
  for (const bool own : {true, false})
    for (std::size_t i = 0; i < 125; ++i) {
      const std::size_t x = i % 5, y = i / 5 % 5, z = i / 25;
      const std::size_t odd = x % 2 + y % 2 + z % 2;
      const std::size_t in_faces = (x % 4 == 0) + (y % 4 == 0) + (z % 4 == 0);
      // The middles of AB; of AD and BD; of AC and BC; of CD.
      if (!((odd == 0 && in_faces == 2) || (odd == 2 && in_faces == 1) || odd == 3 ||
            (odd == 1 && in_faces == 0)))
        continue;
      std::uint8_t& n = number[x % 4 + 4 * (y % 4) + 16 * (z % 4)];
      if (own && x < 4 && y < 4 && z < 4) n = in_faces > 0 ? shared++ : inner++;
      const auto beyond = [](std::size_t k) { return static_cast<std::uint8_t>(k / 4); };
      if (!own) places[i] = {beyond(x), beyond(y), beyond(z), n};
    }
  return places;
}
inline constexpr std::array<EdgePlace, 125> kEdgePlaces = make_edge_places();

class EdgeLayers {
 public:
  explicit EdgeLayers(const Cube& cubes)
      : row_(static_cast<std::size_t>(cubes[0]) + 1),
        layer_(row_ * (static_cast<std::size_t>(cubes[1]) + 1) * kSharedEdges),
        shared_(2 * layer_, kernel::kNone) {
    inner_.fill(kernel::kNone);
  }

  /// Cubes are entered in order; those in between have no edge with a number.
  void enter(const Cube& cube) {
    inner_.fill(kernel::kNone);
    if (cube[2] == cube_[2] + 1)
      forget(static_cast<std::size_t>(cube_[2]) & 1);
    else if (cube[2] != cube_[2])
      for (const std::size_t parity : {0, 1}) forget(parity);
    cube_ = cube;
  }

  /// kNone where the edge has none.
  kernel::Index find(std::size_t slot) const {
    const EdgePlace& place = kEdgePlaces[slot];
    return place.number < kSharedEdges ? shared_[index(place)]
                                       : inner_[place.number - kSharedEdges];
  }
  void add(std::size_t slot, kernel::Index number) {
    const EdgePlace& place = kEdgePlaces[slot];
    if (place.number >= kSharedEdges) {
      inner_[place.number - kSharedEdges] = number;
      return;
    }
    const std::size_t at = index(place);
    shared_[at] = number;
    added_[at / layer_].push_back(at);
  }

 private:
  std::size_t index(const EdgePlace& place) const {
    const auto x = static_cast<std::size_t>(cube_[0] + place.x);
    const auto y = static_cast<std::size_t>(cube_[1] + place.y);
    const auto parity = static_cast<std::size_t>(cube_[2] + place.z) & 1;
    return parity * layer_ + (x + row_ * y) * kSharedEdges + place.number;
  }
  void forget(std::size_t parity) {
    for (const std::size_t at : added_[parity]) shared_[at] = kernel::kNone;
    added_[parity].clear();
  }

  std::size_t row_, layer_;
  std::vector<kernel::Index> shared_;  ///< of two layers
  std::array<std::vector<std::size_t>, 2> added_;
  std::array<kernel::Index, kInnerEdges> inner_{};
  Cube cube_{};
};

}  // namespace crest::splines
