// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The roots of edges are those listed (SPEC.md, H3).
#include <atomic>

#include "certify/container/verdict.hpp"
#include "certify/modes/level.hpp"
#include "certify/modes/trees.hpp"

namespace crest::certify::modes {

/// What one thread computes with.
struct Worker {
  explicit Worker(const Field& field) : exact(field) {}
  ExactTensors exact;
  SignCounts counts;
};

/// Where a point is: above the + level (1), below the - level (-1), between (0). Mode 0: 1 or 0.
using State = std::int8_t;

/// Everything that the checks of one level share.
class LevelContext {
 public:
  LevelContext(const ModeLevel& stated, const Field& field, const Trees& trees);

  const ModeLevel& stated;
  const Field& field;
  const Trees& trees;
  Level level;

  /// Of a vertex whose tensor is not zero; f = 0 counts as f > 0.
  State state(u32 vertex, Worker& worker) const;

 private:
  mutable std::vector<std::atomic<std::int8_t>> states_;
};

/// The sign of f at a place in [0, 1] of a leaf.
int sign_on_edge(const LevelContext& context, u32 node, double t, Worker& worker);

/// Throws Reject unless a leaf's roots are right: number, enclosures, levels.
void check_edge(const LevelContext& context, u32 node, Worker& worker);

}  // namespace crest::certify::modes
