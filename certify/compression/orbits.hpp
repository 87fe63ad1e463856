// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Listed closed orbits: what they go around, and how lines arrive at them (SPEC.md, lemma 16).
#include "certify/compression/paths.hpp"

namespace crest::certify::compression {

struct Orbit {
  Path chain;  ///< one period
  bool counter_clockwise = false;
  std::vector<u32> zeros, loops;  ///< inside, of its part of the domain; ascending
  std::size_t vertices = 0;       ///< inside
  u32 rank = 0;                   ///< among those around the same: 0 is innermost
};

/// Throws Reject if two that go around the same cannot be told apart. Cost: orbits times corners,
/// above 2^31 refused.
std::vector<Orbit> find_orbits(const Proof& proof, SignLadder& sign);

/// How a line ends in an orbit.
struct Tail {
  bool left;          ///< it comes from the left of the chain
  std::size_t cells;  ///< of the chain that it crosses before its end, modulo the period
  std::size_t apart;  ///< its cell before those
};
Tail tail_of(Comparison& comparison, const Path& path, const Orbit& orbit);

}  // namespace crest::certify::compression
