// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Triples of integers at vertices, coded in an order that gives many predictions; one routine both
// ways.
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "algorithms/coding/mixer.hpp"
#include "algorithms/coding/numbers.hpp"
#include "algorithms/coding/surface.hpp"

namespace crest::coding {

__extension__ using Int128 = __int128;

/// A vertex's three integers.
using Triple = std::array<std::int64_t, 3>;

/// In which order vertices come: of those with the most parallelograms whose other three vertices
/// are known, the one that got this many first; without any, a known vertex's neighbour; else the
/// lowest.
class VisitOrder {
 public:
  explicit VisitOrder(const Surface& surface)
      : surface_(surface), known_(surface.counts().vertices, 0), count_(known_.size(), 0), queued_(known_.size(), 0) {}

  bool known(Index v) const { return known_[v] != 0; }
  /// The next vertex, or kNone.
  Index take();
  void visit(Index w);

 private:
  static constexpr std::size_t kMost = 15;
  struct Queue {
    std::vector<Index> entries;
    std::size_t head = 0;
  };
  void credit(Index v) {
    if (count_[v] < kMost) queues_[++count_[v]].entries.push_back(v);
    highest_ = std::max<std::size_t>(highest_, count_[v]);
  }

  const Surface& surface_;
  std::vector<std::uint8_t> known_, count_, queued_;
  std::array<Queue, kMost + 1> queues_;
  std::size_t highest_ = 0;
  Index lowest_ = 0;
};

/// What is known around a vertex.
struct Surroundings {
  static constexpr std::size_t kMost = 16;
  std::size_t neighbours = 0, predictions = 0;
  std::array<Index, kMost> neighbour;
  std::array<std::array<Index, 3>, kMost> parallelogram;  ///< prediction: first + second - third
};

Surroundings surroundings(const Surface& surface, const VisitOrder& order, Index v);

/// What an axis' values are like.
enum class Hint : std::uint32_t {
  none,
  repeats,  ///< often those of a neighbour
  table     ///< of a few, which are listed first
};

/// Wide: an integer type that holds sums of 48 values.
template <class Range, class Wide>
class TripleRoutine {
 public:
  /// `least`, `most`: bounds of all values. `hints`: what is special on each axis.
  TripleRoutine(Range& range, const Surface& surface, std::span<Triple> values, std::int64_t least,
                std::int64_t most, std::array<Hint, 3> hints)
      : range_(range), surface_(surface), values_(values), least_(least), most_(most), hints_(hints),
        lines_(16), lengths_(values.size()), order_(surface) {}

  void run() {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      hints_[axis] = static_cast<Hint>(code_below(range_, static_cast<std::uint32_t>(hints_[axis]), 3));
      if (hints_[axis] == Hint::table) code_table(axis);
    }
    for (Index v = order_.take(); v != kNone; v = order_.take()) {
      const Surroundings around = surroundings(surface_, order_, v);
      for (std::size_t axis = 0; axis < 3; ++axis) code(v, axis, around);
      order_.visit(v);
      last_ = v;
    }
  }

 private:
  struct Prediction {
    Wide value = 0, spread = 0, pull = 0;  ///< pull: mean of known neighbours - value
    int expected = 0, most = 0;            ///< of bit lengths of neighbours' residuals
  };
  static constexpr std::size_t kContexts = 6;

  static Wide mean(Wide sum, std::size_t n) {
    const Wide twice = 2 * sum + static_cast<Wide>(n), over = 2 * static_cast<Wide>(n);
    return twice / over - (twice % over < 0 ? 1 : 0);
  }
  static int length(Wide x) {
    if (x < 0) x = -x;
    const auto low = static_cast<std::uint64_t>(x);
    if constexpr (sizeof(Wide) > 8)
      if (const auto high = static_cast<std::uint64_t>(x >> 64)) return 64 + static_cast<int>(std::bit_width(high));
    return static_cast<int>(std::bit_width(low));
  }

  Prediction predict(const Surroundings& s, std::size_t axis) const {
    Prediction p;
    Wide near = 0;
    int lengths = 0;
    for (std::size_t i = 0; i < s.neighbours; ++i) {
      near += values_[s.neighbour[i]][axis];
      const int l = lengths_[s.neighbour[i]][axis];
      lengths += l;
      p.most = std::max(p.most, l);
    }
    if (s.neighbours > 0) {
      near = mean(near, s.neighbours);
      p.expected = (2 * lengths + static_cast<int>(s.neighbours)) / (2 * static_cast<int>(s.neighbours));
    }
    if (s.predictions == 0) {
      if (s.neighbours > 0) p.value = near;
      else if (last_ != kNone) p.value = values_[last_][axis];
      return p;
    }
    Wide sum = 0, low = 0, high = 0;
    for (std::size_t i = 0; i < s.predictions; ++i) {
      const auto& [a, b, d] = s.parallelogram[i];
      const Wide one = static_cast<Wide>(values_[a][axis]) + values_[b][axis] - values_[d][axis];
      sum += one;
      low = i == 0 ? one : std::min(low, one);
      high = i == 0 ? one : std::max(high, one);
    }
    p.value = std::clamp<Wide>(mean(sum, s.predictions), least_, most_);
    p.spread = high - low;
    p.pull = near - p.value;
    return p;
  }

  static constexpr std::uint64_t clip(int bits) {
    return static_cast<std::uint64_t>(std::clamp(bits, 0, 63));
  }
  static constexpr std::uint64_t pack(std::uint64_t which, std::initializer_list<std::uint64_t> parts) {
    for (const std::uint64_t part : parts) which = which << 6 | part;
    return which;
  }

  void code(Index v, std::size_t axis, const Surroundings& s) {
    std::int64_t& value = values_[v][axis];
    if (hints_[axis] == Hint::repeats && code_repeat(value, axis, s)) {
      here_[axis] = 0;
      lengths_[v][axis] = 0;
      return;
    }
    const Prediction p = predict(s, axis);
    const bool listed = hints_[axis] == Hint::table;
    const Wide base = listed ? nearest(axis, p.value) : p.value;
    Wide wanted = -base;
    if constexpr (Range::kEncodes) wanted += listed ? rank(axis, value) : Wide{value};
    const int bits = code_length(axis, s, p, length(wanted));
    Wide residual = 0;
    bool minus = false;
    if (bits > 0) {
      minus = code_sign(axis, s, p, bits, wanted < 0);
      const auto size = code_size(axis, bits, static_cast<std::uint64_t>(wanted < 0 ? -wanted : wanted));
      residual = minus ? -static_cast<Wide>(size) : static_cast<Wide>(size);
    }
    const Wide result = base + residual;
    if (listed ? result < 0 || result >= static_cast<Wide>(table_[axis].size())
               : result < least_ || result > most_)
      throw StreamError("has a coordinate beyond its range");
    value = listed ? table_[axis][static_cast<std::size_t>(result)] : static_cast<std::int64_t>(result);
    here_[axis] = bits;
    minus_[axis] = minus;
    lengths_[v][axis] = static_cast<std::uint8_t>(bits);
  }

  int code_length(std::size_t axis, const Surroundings& s, const Prediction& p, int wanted) {
    const std::uint64_t e = clip(p.expected), n = std::min<std::size_t>(s.predictions, 3);
    const std::uint64_t spread = clip(length(p.spread)), pull = clip(length(p.pull));
    const std::uint64_t one = axis > 0 ? clip(here_[axis - 1] + 1) : 0;
    const std::uint64_t two = axis > 1 ? clip(here_[0] + 1) : 0;
    const Context<kContexts> context = {&lines_.of(pack(1, {axis, e, n})),
                                        &lines_.of(pack(2, {e, spread, n})),
                                        &lines_.of(pack(3, {axis, e, pull})),
                                        &lines_.of(pack(4, {axis, e, one, two})),
                                        &lines_.of(pack(5, {spread, pull, e})),
                                        &lines_.of(pack(6, {e, clip(p.most), one}))};
    const auto decide = [&](int number, bool bit) {
      const auto d = static_cast<std::size_t>(number);
      return code_mixed(range_, context, d, weights_[axis][d], bit);
    };
    int bits = p.expected;
    if (decide(0, wanted > bits)) {
      for (int k = 1; ++bits < 64 && decide(std::min(k, 7), wanted > bits); ++k) {}
    } else {
      for (int k = 0; bits > 0 && decide(8 + std::min(k, 7), wanted < bits); ++k) --bits;
    }
    return bits;
  }

  bool code_sign(std::size_t axis, const Surroundings& s, const Prediction& p, int bits, bool minus) {
    const std::uint64_t side = p.pull < 0 ? 2 : p.pull > 0 ? 1 : 0;
    const std::uint64_t size = clip(length(p.pull) - bits + 8);
    const std::uint64_t n = std::min<std::size_t>(s.predictions, 3);
    const std::uint64_t others = axis == 0 ? 0 : axis == 1 ? 1 + minus_[0] : 3 + 2 * minus_[1] + minus_[0];
    const Context<4> context = {&lines_.of(pack(7, {side, std::min<std::uint64_t>(size, 15), n})),
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
      const bool bit = code_alone(range_, top_[axis][static_cast<std::size_t>(bits)][node], (wanted >> left & 1) != 0);
      size = size << 1 | (bit ? 1 : 0);
      node = node << 1 | (bit ? 1 : 0);
    }
    if (left == 0) return size;
    return size << left | LargeNumber::code_lower(range_, wanted, left);
  }

  void code_table(std::size_t axis) {
    std::vector<std::int64_t>& table = table_[axis];
    if constexpr (Range::kEncodes) {
      for (const Triple& value : values_) table.push_back(value[axis]);
      std::sort(table.begin(), table.end());
      table.erase(std::unique(table.begin(), table.end()), table.end());
    }
    SmallNumber count;
    const std::uint32_t n = 1 + count.code(range_, static_cast<std::uint32_t>(table.size()) - 1);
    if (n > values_.size()) throw StreamError("lists more values than there are vertices");
    LargeNumber gap;
    table.resize(n);
    auto least = static_cast<std::uint64_t>(least_);
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint64_t more = gap.code(range_, static_cast<std::uint64_t>(table[i]) - least);
      if (more > static_cast<std::uint64_t>(most_) - least || (more == static_cast<std::uint64_t>(most_) - least && i + 1 < n))
        throw StreamError("lists a value beyond its range");
      table[i] = static_cast<std::int64_t>(least + more);
      least += more + 1;
    }
  }
  Wide rank(std::size_t axis, std::int64_t value) const {
    const auto& table = table_[axis];
    return static_cast<Wide>(std::lower_bound(table.begin(), table.end(), value) - table.begin());
  }
  /// Where the listed value nearest to x stands, the lower of two.
  Wide nearest(std::size_t axis, Wide x) const {
    const auto& table = table_[axis];
    const auto after = std::lower_bound(table.begin(), table.end(), x);
    auto place = after - table.begin();
    if (after == table.end() || (after != table.begin() && x - *(after - 1) <= *after - x)) --place;
    return static_cast<Wide>(place);
  }

  bool code_repeat(std::int64_t& value, std::size_t axis, const Surroundings& s) {
    std::array<std::int64_t, 3> tried{};
    std::size_t n = 0;
    for (std::size_t i = 0; i < s.neighbours && n < 3; ++i) {
      const std::int64_t x = values_[s.neighbour[i]][axis];
      if (std::find(tried.begin(), tried.begin() + static_cast<std::ptrdiff_t>(n), x) != tried.begin() + static_cast<std::ptrdiff_t>(n)) continue;
      tried[n] = x;
      if (code_alone(range_, repeat_[axis][n], value == x)) {
        value = x;
        return true;
      }
      ++n;
    }
    return false;
  }

  Range& range_;
  const Surface& surface_;
  std::span<Triple> values_;
  std::int64_t least_, most_;
  std::array<Hint, 3> hints_;
  std::array<std::vector<std::int64_t>, 3> table_;  ///< ascending
  Lines lines_;
  std::vector<std::array<std::uint8_t, 3>> lengths_;  ///< of residuals, in bits
  VisitOrder order_;
  Index last_ = kNone;
  std::array<int, 3> here_{};      ///< lengths at this vertex
  std::array<bool, 3> minus_{};
  std::array<std::array<Weights<kContexts>, 16>, 3> weights_;
  std::array<Weights<4>, 3> sign_weights_;
  std::array<std::array<std::array<Counter, 8>, 66>, 3> top_;
  std::array<std::array<Counter, 4>, 4> repeat_;
};

}  // namespace crest::coding
