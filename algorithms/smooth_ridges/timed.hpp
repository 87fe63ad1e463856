// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Where the time goes.
#include <chrono>

namespace crest::smooth_ridges {

/// Runs f, adds its seconds by the clock to `sum`, and returns its result.
template <class F>
auto timed(double& sum, F&& f) {
  struct Watch {
    double& sum;
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
    ~Watch() {
      sum += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }
  } watch{sum};
  return f();
}

}  // namespace crest::smooth_ridges
