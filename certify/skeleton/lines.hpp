// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Orbits and separatrices from start to end (SPEC.md, steps 5, 6).
#include "certify/skeleton/rays.hpp"
#include "certify/skeleton/traps.hpp"

namespace crest::certify::skeleton {

/// By zero: a trap that was proven, or nothing.
using Traps = std::vector<const Trap*>;

/// What is known of a line besides its records.
struct Trace {
  std::vector<StraightWalk::Passed> straight;
  std::vector<Passage> passages;  ///< of the leg that is not straight
};

/// The chain returns into its first segment. Throws Reject.
Work check_orbit(const Context& context, u32 number, SignLadder& sign, Trace& trace);

/// The line starts and ends as stated, or is as far proven as its turns go. Throws Reject.
Work check_line(const Context& context, const Traps& traps, u32 number, SignLadder& sign,
                Claimed& claimed, Trace& trace);

}  // namespace crest::certify::skeleton
