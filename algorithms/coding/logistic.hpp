// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The logistic function and its inverse as tables of integers, so that every machine has the same
// (docs/cmc-format.md, "Tables").
#include <algorithm>
#include <array>
#include <cstdint>

namespace crest::coding {

inline constexpr int kLogitLimit = 2816;  ///< 11 in steps of 1/256

/// 65536 / (1 + exp(-k / 4)), rounded.
inline constexpr std::array<std::int32_t, 45> kLogisticNodes = {
    32768, 36843, 40793, 44511, 47911, 50941, 53581, 55834, 57724, 59287, 60565, 61598,
    62428, 63090, 63615, 64030, 64357, 64614, 64816, 64974, 65097, 65194, 65269, 65328,
    65374, 65410, 65438, 65459, 65476, 65489, 65500, 65508, 65514, 65519, 65523, 65526,
    65528, 65530, 65531, 65532, 65533, 65534, 65534, 65535, 65535};

/// The probability in 1/65536 of the logit x / 256, between the nodes on straight lines.
constexpr std::int32_t logistic(int x) {
  if (x < 0) return 65536 - logistic(-x);
  const auto k = static_cast<std::size_t>(x / 64);
  if (k + 1 >= kLogisticNodes.size()) return kLogisticNodes.back();
  const int r = x % 64;
  return (kLogisticNodes[k] * (64 - r) + kLogisticNodes[k + 1] * r + 32) / 64;
}

struct LogisticTables {
  std::array<std::uint16_t, 2 * kLogitLimit + 1> probability{};  ///< at the logit + kLogitLimit
  std::array<std::int16_t, 4096> logit{};  ///< least one whose probability is 16 i + 8 or more

  constexpr LogisticTables() {
    for (int x = -kLogitLimit; x <= kLogitLimit; ++x)
      probability[static_cast<std::size_t>(x + kLogitLimit)] =
          static_cast<std::uint16_t>(logistic(x));
    int x = -kLogitLimit;
    for (std::size_t i = 0; i < logit.size(); ++i) {
      while (x < kLogitLimit && probability[static_cast<std::size_t>(x + kLogitLimit)] <
                                    16 * static_cast<int>(i) + 8)
        ++x;
      logit[i] = static_cast<std::int16_t>(x);
    }
  }
};

/// What counters do after n decisions, n up to 1023.
struct CounterTables {
  std::array<std::uint32_t, 1024> step{};        ///< 65536 / (n + 3/2)
  std::array<std::int32_t, 1024> confidence{};   ///< 65536 (n + 3/10) / (n + 9/10); 0 for n = 0

  constexpr CounterTables() {
    for (std::uint32_t n = 0; n < 1024; ++n) {
      step[n] = 131072 / (2 * n + 3);
      confidence[n] = n == 0 ? 0 : static_cast<std::int32_t>(65536 * (10 * n + 3) / (10 * n + 9));
    }
  }
};

inline constexpr LogisticTables kLogistic;
inline constexpr CounterTables kCounter;

}  // namespace crest::coding
