// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/coding/order_code.hpp"

#include <array>

#include "algorithms/coding/numbers.hpp"

namespace crest::coding {
namespace {

/// Each number by its distance from the one before, in the direction that the last one had or not.
template <class Range>
class PermutationRoutine {
 public:
  explicit PermutationRoutine(Range& range) : range_(range) {}

  void run(std::vector<Index>& numbers) {
    const auto count = static_cast<Index>(numbers.size());
    std::vector<bool> taken(count, false);
    std::int64_t before = -1;
    for (Index& number : numbers) {
      const std::int64_t step = std::int64_t{number} - before;
      const bool down = code_alone(range_, down_[last_down_ ? 1 : 0], step < 0);
      const auto size = static_cast<std::int64_t>(
          size_[down ? 1 : 0].code(range_, static_cast<std::uint64_t>((step < 0 ? -step : step) - 1)));
      const std::int64_t limit = down ? before : count - 1 - before;
      if (size < 0 || size >= limit) throw StreamError("has a number that is out of range");
      before += down ? -(size + 1) : size + 1;
      number = static_cast<Index>(before);
      if (taken[number]) throw StreamError("has a number twice");
      taken[number] = true;
      last_down_ = down;
    }
  }

 private:
  Range& range_;
  std::array<Counter, 2> down_;
  std::array<LargeNumber, 2> size_;
  bool last_down_ = false;
};

}  // namespace

Bytes encode_order(const KeptOrder& order) {
  RangeEncoder range;
  KeptOrder copy = order;
  PermutationRoutine(range).run(copy.vertices);
  PermutationRoutine(range).run(copy.faces);
  return range.finish();
}

KeptOrder decode_order(std::span<const std::uint8_t> bytes, Index vertices, Index faces) {
  RangeDecoder range(bytes);
  KeptOrder order{std::vector<Index>(vertices), std::vector<Index>(faces)};
  PermutationRoutine(range).run(order.vertices);
  PermutationRoutine(range).run(order.faces);
  range.finish();
  return order;
}

}  // namespace crest::coding
