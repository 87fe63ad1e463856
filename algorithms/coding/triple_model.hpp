// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Up to three integers an item (a vertex, a face, a wedge), predicted from items around
// it; one routine both ways.
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "algorithms/coding/residual_model.hpp"
#include "algorithms/coding/visit_order.hpp"

namespace crest::coding {

inline constexpr std::int64_t kExactIntegers = std::int64_t{1} << 53;

/// An item's integers.
using Triple = std::array<std::int64_t, 3>;

/// What an axis' values are like.
enum class Hint : std::uint32_t {
  none,
  repeats,  ///< often those of a neighbour
  table     ///< of a few, which are listed first
};

/// The values that there are on an axis, ascending.
class ValueTable {
 public:
  ValueTable() = default;
  ValueTable(std::span<const Triple> values, std::size_t axis) {
    for (const Triple& value : values) values_.push_back(value[axis]);
    std::sort(values_.begin(), values_.end());
    values_.erase(std::unique(values_.begin(), values_.end()), values_.end());
  }
  std::int64_t size() const { return static_cast<std::int64_t>(values_.size()); }
  std::int64_t operator[](std::int64_t place) const {
    return values_[static_cast<std::size_t>(place)];
  }
  /// At most `items` values.
  template <class Range>
  void code(Range& range, std::size_t items, std::int64_t lowest, std::int64_t highest) {
    SmallNumber count;
    const std::uint32_t n = 1 + count.code(range, static_cast<std::uint32_t>(values_.size()) - 1);
    if (n > items) throw StreamError("lists more values than there may be");
    LargeNumber gap;
    values_.resize(n);
    auto least = static_cast<std::uint64_t>(lowest);
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint64_t more = gap.code(range, static_cast<std::uint64_t>(values_[i]) - least);
      if (more > static_cast<std::uint64_t>(highest) - least ||
          (more == static_cast<std::uint64_t>(highest) - least && i + 1 < n))
        throw StreamError("lists a value beyond its range");
      values_[i] = static_cast<std::int64_t>(least + more);
      least += more + 1;
    }
  }
  std::int64_t rank(std::int64_t value) const {
    return std::lower_bound(values_.begin(), values_.end(), value) - values_.begin();
  }
  /// Where the listed value nearest to x stands, the lower of two.
  template <class Wide>
  std::int64_t nearest(Wide x) const {
    const auto after = std::lower_bound(values_.begin(), values_.end(), x);
    const std::int64_t place = after - values_.begin();
    const bool before =
        after == values_.end() || (after != values_.begin() && x - *(after - 1) <= *after - x);
    return before ? place - 1 : place;
  }

 private:
  std::vector<std::int64_t> values_;
};

/// Wide: an integer type that holds sums of 48 values.
template <class Range, class Wide>
class TripleModel {
 public:
  /// `least`, `most`: bounds of all values. `hints`: what is special on each axis.
  TripleModel(Range& range, std::span<Triple> values, std::size_t axes, std::int64_t least,
              std::int64_t most, std::array<Hint, 3> hints)
      : range_(range),
        values_(values),
        axes_(axes),
        least_(least),
        most_(most),
        hints_(hints),
        residuals_(range),
        lengths_(values.size()) {}

  /// First of all.
  void code_hints() {
    for (std::size_t axis = 0; axis < axes_; ++axis) {
      hints_[axis] =
          static_cast<Hint>(code_below(range_, static_cast<std::uint32_t>(hints_[axis]), 3));
      if (hints_[axis] != Hint::table) continue;
      if constexpr (Range::kEncodes) tables_[axis] = ValueTable(values_, axis);
      tables_[axis].code(range_, values_.size(), least_, most_);
    }
  }
  void code(Index item, const Surroundings& around) {
    for (std::size_t axis = 0; axis < axes_; ++axis) code_axis(item, axis, around);
    last_ = item;
  }

 private:
  static Wide mean(Wide sum, std::size_t n) {
    const Wide twice = 2 * sum + static_cast<Wide>(n), over = 2 * static_cast<Wide>(n);
    return twice / over - (twice % over < 0 ? 1 : 0);
  }
  Prediction<Wide> predict(const Surroundings& s, std::size_t axis) const {
    Prediction<Wide> p;
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
      p.expected =
          (2 * lengths + static_cast<int>(s.neighbours)) / (2 * static_cast<int>(s.neighbours));
    }
    if (s.predictions == 0) {
      if (s.neighbours > 0)
        p.value = near;
      else if (last_ != kNone)
        p.value = values_[last_][axis];
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

  void code_axis(Index v, std::size_t axis, const Surroundings& s) {
    std::int64_t& value = values_[v][axis];
    if (hints_[axis] == Hint::repeats && code_repeat(value, axis, s)) {
      residuals_.skip(axis);
      lengths_[v][axis] = 0;
      return;
    }
    const Prediction<Wide> p = predict(s, axis);
    const ValueTable& table = tables_[axis];
    const bool listed = hints_[axis] == Hint::table;
    const Wide base = listed ? Wide{table.nearest(p.value)} : p.value;
    Wide wanted = 0;
    if constexpr (Range::kEncodes) wanted = (listed ? table.rank(value) : value) - base;
    const Wide result = base + residuals_.code(axis, s.predictions, p, wanted);
    if (listed ? result < 0 || result >= table.size() : result < least_ || result > most_)
      throw StreamError("has a number beyond its range");
    value = static_cast<std::int64_t>(result);
    if (listed) value = table[value];
    lengths_[v][axis] = static_cast<std::uint8_t>(residuals_.bits(axis));
  }

  bool code_repeat(std::int64_t& value, std::size_t axis, const Surroundings& s) {
    std::array<std::int64_t, 3> tried{};
    std::size_t n = 0;
    for (std::size_t i = 0; i < s.neighbours && n < 3; ++i) {
      const std::int64_t x = values_[s.neighbour[i]][axis];
      if (std::find(tried.begin(), tried.begin() + static_cast<std::ptrdiff_t>(n), x) !=
          tried.begin() + static_cast<std::ptrdiff_t>(n))
        continue;
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
  std::span<Triple> values_;
  std::size_t axes_;
  std::int64_t least_, most_;
  std::array<Hint, 3> hints_;
  std::array<ValueTable, 3> tables_;
  ResidualModel<Range, Wide> residuals_;
  std::vector<std::array<std::uint8_t, 3>> lengths_;  ///< of residuals, in bits
  Index last_ = kNone;
  std::array<std::array<Counter, 4>, 4> repeat_;
};

/// Calls `use` with a model of the values.
template <class Range, class Use>
void with_model(Range& range, std::span<Triple> values, std::size_t axes, bool wide,
                std::array<Hint, 3> hints, Use&& use) {
  if (wide)
    use(TripleModel<Range, Int128>(range, values, axes, std::numeric_limits<std::int64_t>::min(),
                                   std::numeric_limits<std::int64_t>::max(), hints));
  else
    use(TripleModel<Range, std::int64_t>(range, values, axes, -kExactIntegers, kExactIntegers,
                                         hints));
}

/// Which hints may pay on an axis, of whose pairs of neighbours the `equal` are equal.
std::vector<Hint> plausible(std::span<const Triple> values, std::size_t axis, std::size_t equal,
                            std::size_t pairs);

/// The hints with which `encode` gives least bytes, tried axis by axis, and these bytes.
/// each_pair() calls its argument with two items that are neighbours.
template <class EachPair, class Encode>
std::pair<std::array<Hint, 3>, Bytes> smallest(std::span<const Triple> values, std::size_t axes,
                                               EachPair&& each_pair, Encode&& encode) {
  std::array<Hint, 3> hints{};
  Bytes best = encode(hints);
  for (std::size_t axis = 0; axis < axes; ++axis) {
    std::size_t equal = 0, pairs = 0;
    each_pair([&](Index v, Index w) {
      ++pairs;
      equal += values[v][axis] == values[w][axis] ? 1 : 0;
    });
    Hint kept = hints[axis];
    for (const Hint hint : plausible(values, axis, equal, pairs)) {
      hints[axis] = hint;
      if (Bytes bytes = encode(hints); bytes.size() < best.size()) {
        best = std::move(bytes);
        kept = hint;
      }
    }
    hints[axis] = kept;
  }
  return {hints, std::move(best)};
}

}  // namespace crest::coding
