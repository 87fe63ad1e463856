// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/reeb/exact_order.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "kernel/arithmetic/rational.hpp"

namespace crest::reeb {
namespace {

using kernel::CriticalValue;
using kernel::FaceValues;
using kernel::Rational;
using kernel::Sign;
using kernel::Stage;
using kernel::ValueKind;
using Integer =
    boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;

/// Not reduced: that would cost more than the comparisons. denominator > 0.
struct Fraction {
  Integer numerator, denominator;
  int compare(const Fraction& o) const {
    return Integer(numerator * o.denominator).compare(o.numerator * denominator);
  }
};

// The values times 2^shift are integers, as doubles; nothing if their exponents differ too much.
std::optional<int> integer_shift(const FaceValues& f) {
  int low = 2000, high = -2000;
  for (const auto& part : {f.corner, f.side})
    for (double x : part) {
      if (x == 0) continue;
      const int exponent = std::ilogb(x);
      low = std::min(low, exponent);
      high = std::max(high, exponent);
    }
  if (high - low > 800 || low < -900 || high > 900) return std::nullopt;
  return 52 - low;
}

template <ValueKind kind>
Fraction fraction(FaceValues f, Sign denominator) {
  const std::optional<int> shift = integer_shift(f);
  Fraction x;
  if (shift) {
    for (auto* part : {&f.corner, &f.side})
      for (double& v : *part) v = std::ldexp(v, *shift);
    const kernel::ValueFraction<Integer, kind> q(f);
    x = {Integer(f.corner[0]) * q.denominator + q.numerator, q.denominator};
    if (denominator == Sign::negative) x = {-x.numerator, -x.denominator};
    Integer& scaled = *shift > 0 ? x.denominator : x.numerator;
    scaled <<= static_cast<unsigned>(std::abs(*shift));
  } else {
    const kernel::ValueFraction<Rational, kind> q(f);
    const Rational value = Rational(f.corner[0]) + q.numerator / q.denominator;
    x = {boost::multiprecision::numerator(value), boost::multiprecision::denominator(value)};
  }
  return x;
}

Fraction exact_value(const CriticalValue& v) {
  switch (v.kind) {
    case ValueKind::vertex:
      return fraction<ValueKind::vertex>(v.f, v.denominator);
    case ValueKind::edge:
      return fraction<ValueKind::edge>(v.f, v.denominator);
    default:
      return fraction<ValueKind::face>(v.f, v.denominator);
  }
}

/// Items with the same data, a stretch of them; then with one value.
struct Tied {
  Fraction value;
  kernel::ValueRange range;
  std::size_t begin, end;
};

int by_range(const Tied& x, const Tied& y) {
  return x.range.high < y.range.low ? -1 : y.range.high < x.range.low ? 1 : 0;
}
int by_value(const Tied& x, const Tied& y) {
  const int c = by_range(x, y);
  return c != 0 ? c : x.value.compare(y.value);
}

/// Sorts the items, too.
std::vector<Tied> group_by_data(std::vector<ValuedNode>& items) {
  for (ValuedNode& item : items) item.value = kernel::normal_form(item.value);
  const auto data = [](const ValuedNode& x) { return std::pair(x.value.kind, x.value.f); };
  std::sort(items.begin(), items.end(),
            [&](const ValuedNode& x, const ValuedNode& y) { return data(x) < data(y); });
  std::vector<Tied> groups;
  for (std::size_t begin = 0, end = 0; begin < items.size(); begin = end) {
    while (end < items.size() && data(items[end]) == data(items[begin])) ++end;
    groups.push_back({{}, items[begin].range, begin, end});
  }
  if (groups.size() == 1) return groups;
  for (Tied& group : groups) group.value = exact_value(items[group.begin].value);
  std::sort(groups.begin(), groups.end(),
            [](const Tied& x, const Tied& y) { return by_value(x, y) < 0; });
  return groups;
}

}  // namespace

void sort_exactly(std::vector<ValuedNode>& items, std::span<Index> nodes,
                  std::span<std::uint8_t> tied, kernel::StageCounts& counts) {
  const std::vector<Tied> groups = group_by_data(items);
  std::size_t first = 0, next = 0;  // in nodes: where the value's begin, and the next node goes
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const bool same = g > 0 && by_value(groups[g - 1], groups[g]) == 0;
    if (!same) {
      std::sort(nodes.begin() + static_cast<std::ptrdiff_t>(first),
                nodes.begin() + static_cast<std::ptrdiff_t>(next));
      first = next;
    }
    for (std::size_t i = groups[g].begin; i < groups[g].end; ++i, ++next) {
      nodes[next] = items[i].node;
      if (next == 0) continue;
      tied[next] = next > first;
      counts.add(next > first                              ? Stage::symbolic
                 : by_range(groups[g - 1], groups[g]) != 0 ? Stage::triage
                                                           : Stage::exact);
    }
  }
  std::sort(nodes.begin() + static_cast<std::ptrdiff_t>(first), nodes.end());
}

}  // namespace crest::reeb
