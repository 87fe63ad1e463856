// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/coding/decisions.hpp"

namespace crest::certify {
namespace {

constexpr int kRange = 2816;
constexpr std::array<int, 45> kNodes = {
    32768, 36843, 40793, 44511, 47911, 50941, 53581, 55834, 57724, 59287, 60565, 61598,
    62428, 63090, 63615, 64030, 64357, 64614, 64816, 64974, 65097, 65194, 65269, 65328,
    65374, 65410, 65438, 65459, 65476, 65489, 65500, 65508, 65514, 65519, 65523, 65526,
    65528, 65530, 65531, 65532, 65533, 65534, 65534, 65535, 65535};

int squash(int x) {
  if (x < 0) return 65536 - squash(-x);
  if (x == kRange) return 65535;
  const auto k = static_cast<std::size_t>(x / 64);
  const int r = x % 64;
  return (kNodes[k] * (64 - r) + kNodes[k + 1] * r + 32) / 64;
}

std::array<int, 4096> make_stretch() {
  std::array<int, 4096> table{};
  int x = -kRange;
  for (int i = 0; i < 4096; ++i) {
    while (x < kRange && squash(x) < 16 * i + 8) ++x;
    table[static_cast<std::size_t>(i)] = x;
  }
  return table;
}

std::int64_t confidence(std::int64_t n) {
  return n == 0 ? 0 : 65536 * (10 * n + 3) / (10 * n + 9);
}

}  // namespace

bool Decisions::mixed(std::span<Line* const> lines, std::size_t which, Mixer& mixer) {
  static const std::array<int, 4096> stretch = make_stretch();
  std::array<std::int64_t, 6> t{};
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const Counter& counter = (*lines[i])[which];
    t[i] = stretch[static_cast<std::size_t>(counter.p >> 10)] * confidence(counter.n) >> 16;
    sum += mixer.weight[i] * t[i];
  }
  const int q = squash(static_cast<int>(clamped(sum >> 16, -kRange, kRange)));
  const bool one = with(static_cast<std::uint32_t>(q), 16);
  const std::int64_t error = (one ? 65536 : 0) - q;
  const int shift = mixer.uses < 24 ? 12 : mixer.uses < 200 ? 13 : 15;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    mixer.weight[i] = clamped(mixer.weight[i] + (t[i] * error >> shift), -(1 << 20), 1 << 20);
    (*lines[i])[which].learn(one);
  }
  ++mixer.uses;
  return one;
}

}  // namespace crest::certify
