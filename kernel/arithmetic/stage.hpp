// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Which stage of a ladder decided, and how often (kernel/predicates/ladder.hpp).
#include <cstdint>

#include "kernel/arithmetic/sign.hpp"

namespace crest::kernel {

enum class Stage : std::uint8_t { triage, interval, integer, exact, symbolic };

struct Decision {
  Sign sign;
  Stage stage;  ///< the one that decided
};

/// Who decided, summed over calls; the calls that no other stage decided triage did.
struct StageCounts {
  std::uint64_t calls = 0, interval = 0, integer = 0, exact = 0, symbolic = 0;
  void add(Stage s) {
    ++calls;
    interval += s == Stage::interval;
    integer += s == Stage::integer;
    exact += s == Stage::exact;
    symbolic += s == Stage::symbolic;
  }
  StageCounts& operator+=(const StageCounts& o) {
    calls += o.calls;
    interval += o.interval;
    integer += o.integer;
    exact += o.exact;
    symbolic += o.symbolic;
    return *this;
  }
};

}  // namespace crest::kernel
