// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ctime>

namespace crest::experiments {

/// Of all threads of this process, in seconds: what runs beside it does not count.
inline double processor_seconds() {
  timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace crest::experiments
