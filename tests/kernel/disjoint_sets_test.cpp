// SPDX-License-Identifier: GPL-3.0-or-later
// Disjoint sets against a partition kept as labels.
#include "kernel/geometry/disjoint_sets.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "tests/support/random.hpp"

namespace {

using namespace crest::kernel;

/// The label of an element is the smallest of its set, by relabelling all.
class Labels {
 public:
  explicit Labels(Index n) : label_(n) {
    for (Index i = 0; i < n; ++i) label_[i] = i;
  }
  Index find(Index x) const { return label_[x]; }
  Index count() const {
    return static_cast<Index>(std::set<Index>(label_.begin(), label_.end()).size());
  }
  bool unite(Index a, Index b) {
    const Index low = std::min(label_[a], label_[b]), high = std::max(label_[a], label_[b]);
    std::replace(label_.begin(), label_.end(), high, low);
    return low != high;
  }

 private:
  std::vector<Index> label_;
};

}  // namespace

TEST_CASE("disjoint sets: named by their smallest elements, whatever the order of joins") {
  crest::tests::Random random(7);
  for (int trial = 0; trial < 200; ++trial) {
    const auto n = static_cast<Index>(1 + random() % 60);
    INFO("trial " << trial << ", " << n << " elements");
    DisjointSets sets(n);
    Labels labels(n);
    CHECK(sets.size() == n);
    std::vector<std::pair<Index, Index>> joins;
    for (Index i = 0; i < n; ++i) {
      const auto a = static_cast<Index>(random() % n), b = static_cast<Index>(random() % n);
      joins.emplace_back(a, b);
      CHECK(sets.unite(a, b) == labels.unite(a, b));
      CHECK(sets.count() == labels.count());
      const auto x = static_cast<Index>(random() % n);
      CHECK(sets.find(x) == labels.find(x));
    }
    std::shuffle(joins.begin(), joins.end(), random);
    DisjointSets again(n);
    for (const auto& [a, b] : joins) again.unite(b, a);
    for (Index x = 0; x < n; ++x) {
      CHECK(sets.find(x) == labels.find(x));
      CHECK(again.find(x) == labels.find(x));
    }
  }
}

TEST_CASE("disjoint sets: a long chain joined from its end") {
  constexpr Index n = 1000000;
  DisjointSets sets(n);
  bool all = true;
  for (Index i = n - 1; i > 0; --i) all = sets.unite(i, i - 1) && all;
  CHECK(all);
  CHECK(sets.count() == 1);
  CHECK(sets.find(n - 1) == 0);
  CHECK_FALSE(sets.unite(0, n - 1));
  DisjointSets none(0);
  CHECK(none.count() == 0);
}
