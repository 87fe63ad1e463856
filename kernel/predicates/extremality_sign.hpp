// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Sign of an extremality b0 or b3 at a vertex, for the stored frame (hypothesis S3 of paper 002
// asks that it is not zero; here zero has a rule).
//
// Laws. (1) odd: sign(-b, -d1) = -sign(b, d1). (2) never zero for a non-zero d1. (3) equals the
// sign of b when b != 0. The number is given exactly, so triage always decides; zero is symbolic.
#include "kernel/predicates/symbolic.hpp"

namespace crest::kernel {

inline MaybeSign triage_extremality_sign(double b) {
  if (b == 0) return std::nullopt;
  return sign_of(b);
}
inline Sign symbolic_extremality_sign(const Vec3& d1) {
  return symbolic_extremality(d1);
}

inline Decision extremality_sign(double b, const Vec3& d1) {
  if (const MaybeSign s = triage_extremality_sign(b)) return {*s, Stage::triage};
  return {symbolic_extremality_sign(d1), Stage::symbolic};
}

}  // namespace crest::kernel
