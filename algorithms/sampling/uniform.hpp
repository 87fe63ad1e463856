// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Uniform random numbers that are the same on every platform.
#include <cstdint>
#include <random>

namespace crest::sampling {

class Uniform {
 public:
  explicit Uniform(std::uint64_t seed) : engine_(seed) {}
  /// In [0, 1), 53 bits.
  double operator()() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

 private:
  std::mt19937_64 engine_;
};

}  // namespace crest::sampling
