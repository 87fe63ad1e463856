// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Ending long work early: a time limit, a user's Ctrl-C.
#include <functional>

namespace crest::smooth_ridges {

/// Whether to stop now; empty: never. Asked often and by several threads; once true, it stays so.
using Stop = std::function<bool()>;

inline bool is_over(const Stop& stop) {
  return stop && stop();
}

}  // namespace crest::smooth_ridges
