// SPDX-License-Identifier: GPL-3.0-or-later
// A library that spoils a process which loads it, as one linked with -ffast-math does: a test loads
// it before a program (LD_PRELOAD).
#include <cfenv>

namespace {

struct RoundUpward {
  RoundUpward() { std::fesetround(FE_UPWARD); }
} round_upward;

}  // namespace
