// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Adaptive models of binary decisions: counters, and the mixing of several contexts' counters
// (docs/cmc-format.md, "Counters" and "Mixing").
#include <array>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <span>
#include <vector>

#include "algorithms/coding/logistic.hpp"
#include "algorithms/coding/range_coder.hpp"

namespace crest::coding {

/// How often a decision was 1: a probability of 22 bits and the number of decisions, of 10. All zero
/// is 1/2 after none, so that fresh memory is fresh counters.
class Counter {
 public:
  constexpr Counter() = default;
  /// Of probability `ones` / 2^22 as if after `count` decisions.
  constexpr Counter(std::uint32_t ones, std::uint32_t count) : word_((ones << 10 | count) ^ kHalf) {}

  std::uint32_t ones() const { return (word_ ^ kHalf) >> 10; }
  std::uint32_t count() const { return word_ & 1023u; }
  void learn(bool bit, std::uint32_t limit) {
    const std::uint32_t n = count();
    const std::int64_t p = ones();
    const std::int64_t target = bit ? (1 << 22) - 1 : 0;
    const std::int64_t moved = p + (((target - p) * kCounter.step[n]) >> 16);
    word_ = ((static_cast<std::uint32_t>(moved) << 10) | (n < limit ? n + 1 : n)) ^ kHalf;
  }

 private:
  static constexpr std::uint32_t kHalf = 0x80000000u;
  std::uint32_t word_ = 0;
};

inline constexpr std::uint32_t kCounterLimit = 1000;

/// A decision that only its own counter predicts.
template <class Range>
bool code_alone(Range& range, Counter& counter, bool bit) {
  const std::uint64_t p = std::uint64_t{counter.ones()} >> 6;
  bit = range.code(bit, {p == 0 ? 1 : p, 16});
  counter.learn(bit, kCounterLimit);
  return bit;
}

/// The counters of all decisions of a symbol in one context: a cache line.
using Line = std::array<Counter, 16>;

/// Lines by context, in memory that costs nothing before it is used. Contexts that share a line
/// learn together.
class Lines {
 public:
  explicit Lines(int bits)
      : bits_(bits),
        lines_(static_cast<Line*>(std::calloc((std::size_t{1} << bits) + 1, sizeof(Line)))) {
    if (!lines_) throw std::bad_alloc();
    const auto address = reinterpret_cast<std::uintptr_t>(lines_.get());
    aligned_ = reinterpret_cast<Line*>((address + sizeof(Line) - 1) / sizeof(Line) * sizeof(Line));
  }
  Line& of(std::uint64_t context) {
    return aligned_[(context * 0x9e3779b97f4a7c15u) >> (64 - bits_)];
  }

 private:
  struct Free {
    void operator()(Line* lines) const { std::free(lines); }
  };
  int bits_;
  std::unique_ptr<Line[], Free> lines_;
  Line* aligned_;
};

/// Weights of K inputs in 1/65536.
template <std::size_t K>
struct Weights {
  std::array<std::int32_t, K> weight;
  std::int32_t uses = 0;
  Weights() { weight.fill(18350); }
};

/// The lines of a symbol's K contexts.
template <std::size_t K>
using Context = std::array<Line*, K>;

/// Decision `number` of a symbol, below 16, predicted by all K contexts.
template <class Range, std::size_t K>
bool code_mixed(Range& range, const Context<K>& context, std::size_t number, Weights<K>& weights,
                bool bit) {
  std::array<std::int32_t, K> input;
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < K; ++i) {
    const Counter& counter = (*context[i])[number];
    input[i] = (kLogistic.logit[counter.ones() >> 10] * kCounter.confidence[counter.count()]) >> 16;
    sum += std::int64_t{weights.weight[i]} * input[i];
  }
  const auto logit = static_cast<int>(
      std::clamp<std::int64_t>(sum >> 16, -kLogitLimit, kLogitLimit));
  const std::int32_t p = kLogistic.probability[static_cast<std::size_t>(logit + kLogitLimit)];
  bit = range.code(bit, {static_cast<std::uint64_t>(p), 16});
  const std::int32_t error = (bit ? 65536 : 0) - p;
  const int shift = weights.uses < 24 ? 12 : weights.uses < 200 ? 13 : 15;
  if (weights.uses < 200) ++weights.uses;
  for (std::size_t i = 0; i < K; ++i) {
    weights.weight[i] = std::clamp(weights.weight[i] + ((input[i] * error) >> shift), -(1 << 20), 1 << 20);
    (*context[i])[number].learn(bit, kCounterLimit);
  }
  return bit;
}

}  // namespace crest::coding
