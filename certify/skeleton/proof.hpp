// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// All steps of claim 9, and what they found: also for claims about several skeletons.
#include "certify/container/verdict.hpp"
#include "certify/skeleton/lines.hpp"

namespace crest::certify::skeleton {

struct Proof {
  explicit Proof(const SkeletonCertificate& c) : stated(c), field(c) {}

  const SkeletonCertificate& stated;
  Field field;
  Domain domain;
  ZeroSet zeros;
  Boundary boundary;
  std::vector<Claimed> claimed;  ///< of separatrices
  std::vector<Trace> lines, orbits;
};

/// Step 1. Throws Reject.
void prove_surface(Proof& proof, SignLadder& sign, Verdict& verdict);
/// Steps 2 to 6, after the first. Throws Reject.
void prove_skeleton(Proof& proof, SignLadder& sign, Arithmetic arithmetic, Verdict& verdict);

}  // namespace crest::certify::skeleton
