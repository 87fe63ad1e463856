// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How the differences between integers and their predictions are coded (docs/cmc-format.md,
// "Positions").
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "algorithms/coding/mixer.hpp"
#include "algorithms/coding/numbers.hpp"
#include "algorithms/coding/stream_error.hpp"

namespace crest::coding {

__extension__ using Int128 = __int128;

/// Wide: std::int64_t or Int128.
template <class Wide>
int bit_length(Wide x) {
  if (x < 0) x = -x;
  const auto low = static_cast<std::uint64_t>(x);
  if constexpr (sizeof(Wide) > 8)
    if (const auto high = static_cast<std::uint64_t>(x >> 64))
      return 64 + static_cast<int>(std::bit_width(high));
  return static_cast<int>(std::bit_width(low));
}

template <class Wide>
struct Prediction {
  Wide value = 0, spread = 0, pull = 0;  ///< pull: mean of known neighbours - value
  int expected = 0, most = 0;            ///< of bit lengths of neighbours' residuals
};

/// The residuals of three axes, vertex by vertex.
template <class Range, class Wide>
class ResidualModel {
 public:
  explicit ResidualModel(Range& range) : range_(range), lines_(16) {}

  /// A residual below 2^64, below 2^62 if Wide has 64 bits (within +-2^53, whose residuals are
  /// shorter, so that longer ones are beyond their range); `predictions`: how many parallelograms p
  /// is the mean of.
  Wide code(std::size_t axis, std::size_t predictions, const Prediction<Wide>& p, Wide wanted) {
    const int bits = code_length(axis, predictions, p, bit_length(wanted));
    if (sizeof(Wide) == 8 && bits > 62) throw StreamError("has a number beyond its range");
    here_[axis] = bits;
    minus_[axis] = false;
    if (bits == 0) return 0;
    minus_[axis] = code_sign(axis, predictions, p, bits, wanted < 0);
    const auto size =
        code_size(axis, bits, static_cast<std::uint64_t>(wanted < 0 ? -wanted : wanted));
    return minus_[axis] ? -static_cast<Wide>(size) : static_cast<Wide>(size);
  }
  /// The axis has none at this vertex.
  void skip(std::size_t axis) { here_[axis] = 0; }
  /// The bit length of the last one.
  int bits(std::size_t axis) const { return here_[axis]; }

 private:
  static constexpr std::size_t kContexts = 6;

  static constexpr std::uint64_t clip(int bits) {
    return static_cast<std::uint64_t>(std::clamp(bits, 0, 63));
  }
  static constexpr std::uint64_t pack(std::uint64_t which,
                                      std::initializer_list<std::uint64_t> parts) {
    for (const std::uint64_t part : parts) which = which << 6 | part;
    return which;
  }

  int code_length(std::size_t axis, std::size_t predictions, const Prediction<Wide>& p,
                  int wanted) {
    const std::uint64_t e = clip(p.expected), n = std::min<std::size_t>(predictions, 3);
    const std::uint64_t spread = clip(bit_length(p.spread)), pull = clip(bit_length(p.pull));
    const std::uint64_t one = axis > 0 ? clip(here_[axis - 1] + 1) : 0;
    const std::uint64_t two = axis > 1 ? clip(here_[0] + 1) : 0;
    const Context<kContexts> context = {
        &lines_.of(pack(1, {axis, e, n})),      &lines_.of(pack(2, {e, spread, n})),
        &lines_.of(pack(3, {axis, e, pull})),   &lines_.of(pack(4, {axis, e, one, two})),
        &lines_.of(pack(5, {spread, pull, e})), &lines_.of(pack(6, {e, clip(p.most), one}))};
    const auto decide = [&](int number, bool bit) {
      const auto d = static_cast<std::size_t>(number);
      return code_mixed(range_, context, d, weights_[axis][d], bit);
    };
    int bits = p.expected;
    if (decide(0, wanted > bits)) {
      if (bits >= 64) throw StreamError("has a coordinate beyond its range");
      for (int k = 1; ++bits < 64 && decide(std::min(k, 7), wanted > bits); ++k) {
      }
    } else {
      for (int k = 0; bits > 0 && decide(8 + std::min(k, 7), wanted < bits); ++k) --bits;
    }
    return bits;
  }

  bool code_sign(std::size_t axis, std::size_t predictions, const Prediction<Wide>& p, int bits,
                 bool minus) {
    const std::uint64_t side = p.pull < 0 ? 2 : p.pull > 0 ? 1 : 0;
    const std::uint64_t size = clip(bit_length(p.pull) - bits + 8);
    const std::uint64_t n = std::min<std::size_t>(predictions, 3);
    const std::uint64_t others = axis == 0   ? 0
                                 : axis == 1 ? 1 + minus_[0]
                                             : 3 + 2 * minus_[1] + minus_[0];
    const Context<4> context = {
        &lines_.of(pack(7, {side, std::min<std::uint64_t>(size, 15), n})),
        &lines_.of(pack(8, {axis, side, others})),
        &lines_.of(pack(9, {axis, side, clip(bits), std::min<std::uint64_t>(size, 15)})),
        &lines_.of(pack(10, {axis, others}))};
    return code_mixed(range_, context, 0, sign_weights_[axis], minus);
  }

  /// The number of `bits` bits; those below the first, three at most, have counters.
  std::uint64_t code_size(std::size_t axis, int bits, std::uint64_t wanted) {
    std::uint64_t size = 1;
    int left = bits - 1;
    for (std::size_t node = 1; left > 0 && node < 8;) {
      --left;
      const bool bit = code_alone(range_, top_[axis][static_cast<std::size_t>(bits)][node],
                                  (wanted >> left & 1) != 0);
      size = size << 1 | (bit ? 1 : 0);
      node = node << 1 | (bit ? 1 : 0);
    }
    if (left == 0) return size;
    return size << left | LargeNumber::code_lower(range_, wanted, left);
  }

  Range& range_;
  Lines lines_;
  std::array<int, 3> here_{};  ///< bit lengths at this vertex
  std::array<bool, 3> minus_{};
  std::array<std::array<Weights<kContexts>, 16>, 3> weights_;
  std::array<Weights<4>, 3> sign_weights_;
  std::array<std::array<std::array<Counter, 8>, 66>, 3> top_;
};

}  // namespace crest::coding
