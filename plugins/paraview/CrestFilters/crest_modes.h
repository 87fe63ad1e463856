// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef crest_modes_h
#define crest_modes_h

#include <string>
#include <vector>

#include "algorithms/modes/level.hpp"

/// A level and, if only its sign is wanted, that sign.
struct WantedMode {
  crest::modes::Level level;
  int sign = 0;
  friend bool operator==(const WantedMode& a, const WantedMode& b) {
    return a.level.p == b.level.p && a.level.q == b.level.q && a.sign == b.sign;
  }
};

/// "0.5, -1/3" as levels, different ones, in their order. Throws: crest::kernel::InputError.
std::vector<WantedMode> wanted_modes(const std::string& words, bool keep_sign, bool neutral);

#endif
