// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Which nodes are active or flat, n there and the sign of g = n . grad s.
#include <optional>
#include <vector>

#include "algorithms/extremal/direction.hpp"
#include "algorithms/extremal/fields.hpp"
#include "algorithms/extremal/ranked_bits.hpp"
#include "kernel/geometry/piece.hpp"

namespace crest::extremal {

enum class NodeState : std::uint8_t { inactive, active, flat };

class Nodes {
 public:
  /// `min_value`: nodes in whose cells L is certainly less are inactive, and so are those that are
  /// not in `asked`.
  Nodes(const Fields& fields, const std::optional<double>& min_value, const kernel::GridBox& asked);

  NodeState state(std::size_t v) const { return states_[v]; }
  bool active(std::size_t v) const { return states_[v] == NodeState::active; }
  /// n at an active node, in the orientation that stays.
  Vec3 direction(std::size_t v) const {
    const auto& d = directions_[ids_.rank(v)];
    return {static_cast<double>(d[0]), static_cast<double>(d[1]), static_cast<double>(d[2])};
  }
  /// Of g in that orientation: 1 or -1.
  int sign(std::size_t v) const { return signs_[ids_.rank(v)]; }
  /// May L reach min-value in the cell (an image: square) at v?
  bool possible(std::size_t v) const { return (cells_[v] & kPossible) != 0; }
  std::size_t count(NodeState s) const;

 private:
  static constexpr std::uint8_t kPossible = 1, kPlateau = 2;
  void scan_cells(const std::optional<double>& min_value);
  NodeState before_direction(const Node& v) const;
  NodeState decide(const Node& v, std::array<float, 3>& direction, std::int8_t& sign) const;

  const Fields& fields_;
  std::vector<std::uint8_t> cells_;
  std::vector<NodeState> states_;
  RankedBits ids_;  ///< of active nodes
  std::vector<std::array<float, 3>> directions_;
  std::vector<std::int8_t> signs_;
};

}  // namespace crest::extremal
