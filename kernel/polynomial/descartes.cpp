// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/polynomial/descartes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "kernel/arithmetic/approximate.hpp"
#include "kernel/polynomial/integer_polynomial.hpp"

namespace crest::kernel {
namespace {

constexpr std::size_t kMostCoefficients = 17;
/// Ends of places stay doubles; what is not decided here needs more bits than a double has.
constexpr int kMostHalvings = 48;
constexpr int kMostNodes = 256;

/// Error of a child's coefficients. One halving of degree n is n levels of averages a/2 + b/2 of
/// numbers of at most m = max |b|; an average is at most m (1 + u)^k, is rounded once (u times
/// itself), each half may underflow (2^-1075), and an average of two errors is no larger than the
/// larger. So n u m (1 + u)^n + n 2^-1074 are added; n + 2 in place of n covers (1 + u)^n and the
/// rounding of this formula and of its sum with the parent's error (n <= 16).
struct UnitTriage {
  std::size_t count;
  std::vector<UnitRange>& places;
  int nodes = 0;

  struct Node {
    std::array<double, kMostCoefficients> b;
    double error, low, width;
  };

  enum class Count { none, one, unknown, failed };

  Count changes(const Node& node) const {
    int last = 0, found = 0;
    std::size_t unknown = 0;
    bool failed = false, more = false;
    for (std::size_t k = 0; k < count; ++k) {
      const int s = (node.b[k] > node.error) - (node.b[k] < -node.error);
      if (s == 0) {
        ++unknown;
        failed = failed || k == 0 || k + 1 == count;
        continue;
      }
      found += last != 0 && s != last;
      // Numbers of unknown sign may change it twice more, but for a single one between two signs.
      more = more || unknown > 1 || (unknown == 1 && s == last);
      unknown = 0;
      last = s;
    }
    if (failed) return Count::failed;
    if (more || found > 1) return Count::unknown;
    return found == 0 ? Count::none : Count::one;
  }

  bool isolate(const Node& node, int halvings) {
    switch (changes(node)) {
      case Count::failed:
        return false;
      case Count::none:
        return true;
      case Count::one:
        places.push_back({node.low, node.low + node.width});
        return true;
      case Count::unknown:
        break;
    }
    if (halvings == kMostHalvings || ++nodes == kMostNodes) return false;
    Node left, right = node;
    double largest = 0;
    for (std::size_t k = 0; k < count; ++k) largest = std::max(largest, std::fabs(node.b[k]));
    for (std::size_t level = 0; level < count; ++level) {
      left.b[level] = right.b[0];
      for (std::size_t k = 0; k + level + 1 < count; ++k)
        right.b[k] = 0.5 * right.b[k] + 0.5 * right.b[k + 1];
    }
    const double steps = static_cast<double>(count + 1);
    left.error = right.error =
        (node.error + steps * (kUnitRoundoff * largest + 0x1p-1074)) * (1 + 4 * kUnitRoundoff);
    left.width = right.width = node.width / 2;
    left.low = node.low;
    right.low = node.low + left.width;
    return isolate(left, halvings + 1) && isolate(right, halvings + 1);
  }
};

struct ExactNode {
  std::vector<Integer> b;  ///< empty: a place that is decided
  UnitPlace place;
};

int sign_changes(const std::vector<Integer>& b) {
  int last = 0, changes = 0;
  for (const Integer& x : b) {
    const int s = x.sign();
    if (s == 0) continue;
    changes += last != 0 && s != last;
    last = s;
  }
  return changes;
}

/// Left half and right half, both times 2^n; b becomes the right one.
std::vector<Integer> halve(std::vector<Integer>& b) {
  const std::size_t n = b.size() - 1;
  std::vector<Integer> left(b.size());
  for (std::size_t level = 0; level <= n; ++level) {
    mpz_mul_2exp(left[level].backend().data(), b[0].backend().data(), n - level);
    for (std::size_t k = 0; k + level < n; ++k) b[k] += b[k + 1];
  }
  for (std::size_t k = 0; k <= n; ++k)
    mpz_mul_2exp(b[k].backend().data(), b[k].backend().data(), k);
  drop_twos(left);
  drop_twos(b);
  return left;
}

void push(std::vector<ExactNode>& stack, std::vector<Integer> b, Integer position, long depth) {
  const int changes = sign_changes(b);
  if (changes == 0) return;
  const bool decided = changes == 1 && !b.front().is_zero() && !b.back().is_zero();
  if (decided) b.clear();
  stack.push_back({std::move(b), {std::move(position), depth, false}});
}

}  // namespace

std::optional<std::vector<UnitRange>> triage_unit_places(std::span<const double> b, double error) {
  if (b.empty() || b.size() > kMostCoefficients || !std::isfinite(error)) return std::nullopt;
  std::vector<UnitRange> places;
  UnitTriage::Node node;
  std::copy(b.begin(), b.end(), node.b.begin());
  node.error = error;
  node.low = 0;
  node.width = 1;
  if (!UnitTriage{b.size(), places}.isolate(node, 0)) return std::nullopt;
  return places;
}

std::vector<UnitPlace> exact_unit_places(std::vector<Integer> b) {
  std::vector<UnitPlace> places;
  std::vector<ExactNode> stack;
  drop_twos(b);
  push(stack, std::move(b), 0, 0);
  while (!stack.empty()) {
    ExactNode node = std::move(stack.back());
    stack.pop_back();
    if (node.b.empty()) {
      places.push_back(std::move(node.place));
      continue;
    }
    std::vector<Integer> left = halve(node.b);
    const Integer middle = 2 * node.place.position + 1;
    const long depth = node.place.depth + 1;
    const bool root = node.b.front().is_zero();
    push(stack, std::move(node.b), middle, depth);
    if (root) stack.push_back({{}, {middle, depth, true}});
    push(stack, std::move(left), middle - 1, depth);
  }
  return places;
}

}  // namespace crest::kernel
