// SPDX-License-Identifier: GPL-3.0-or-later
// The octree: what is split, what becomes one again, the balance of neighbours.
#include "algorithms/extremal/octree.hpp"

#include <catch2/catch.hpp>

#include "tests/support/degenerate_families.hpp"

using namespace crest;
using namespace crest::tests;
using extremal::Content;
using extremal::Octree;
using extremal::OctreeLeaf;

namespace {

/// Splits what has the place in it, down to size 1; all else is far.
std::vector<Content> round_place(const std::vector<OctreeLeaf>& boxes,
                                 const extremal::Node& place) {
  std::vector<Content> r;
  for (const OctreeLeaf& box : boxes) {
    bool has = true;
    for (std::size_t k = 0; k < 3; ++k)
      has = has && place[k] >= box.low[k] && place[k] < box.low[k] + box.size;
    r.push_back(!has ? Content::far : box.size > 1 ? Content::split : Content::open);
  }
  return r;
}

std::size_t volume(const Octree& tree) {
  std::size_t r = 0;
  for (const OctreeLeaf& leaf : tree.leaves())
    r += static_cast<std::size_t>(leaf.size) * static_cast<std::size_t>(leaf.size) *
         static_cast<std::size_t>(leaf.size);
  return r;
}

}  // namespace

TEST_CASE("extremal octree: leaves that touch differ by a factor of two at most") {
  Draw d(1);
  for (int i = 0; i < 50; ++i) {
    const auto coordinate = [&] { return static_cast<int>(d.integer(0, 63)); };
    const extremal::Node place = {coordinate(), coordinate(), coordinate()};
    const Octree tree(6, [&](const auto& boxes) { return round_place(boxes, place); });
    CHECK(tree.finest() == 1);
    CHECK(volume(tree) == 64 * 64 * 64);
    std::size_t open = 0, worst = 0;
    for (const OctreeLeaf& leaf : tree.leaves()) {
      open += leaf.content == Content::open ? 1 : 0;
      for (int n = 0; n < 27; ++n) {
        const std::array<int, 3> step = {n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1};
        extremal::Node at;
        for (std::size_t k = 0; k < 3; ++k)
          at[k] = 2 * leaf.low[k] + leaf.size + step[k] * (leaf.size + 1);
        const auto other = tree.leaf_at(at);
        if (other == kernel::kNone) continue;
        worst = std::max(worst, static_cast<std::size_t>(tree.leaves()[other].size / leaf.size));
      }
    }
    CHECK(open == 1);
    CHECK(worst == 2);
  }
}

TEST_CASE("extremal octree: eight boxes without anything become one, the rest stays") {
  // All is split down to size 1; of these those of y < 4 are far.
  const auto contents = [](const std::vector<OctreeLeaf>& boxes, bool one_open) {
    std::vector<Content> r;
    for (const OctreeLeaf& box : boxes) {
      const bool chosen = one_open && box.low == extremal::Node{7, 7, 7};
      r.push_back(box.size > 1     ? Content::split
                  : chosen         ? Content::open
                  : box.low[1] < 4 ? Content::far
                                   : Content::empty);
    }
    return r;
  };
  const Octree none(3, [&](const auto& boxes) { return contents(boxes, false); });
  REQUIRE(none.leaves().size() == 1);
  CHECK(none.leaves()[0].content == Content::empty);
  const Octree one(3, [&](const auto& boxes) { return contents(boxes, true); });
  // Four far octants and three empty ones of size 4, seven of size 2, eight of size 1.
  REQUIRE(one.leaves().size() == 22);
  CHECK(volume(one) == 8 * 8 * 8);
  std::size_t far = 0, open = 0;
  for (const OctreeLeaf& leaf : one.leaves()) {
    far += leaf.content == Content::far ? 1 : 0;
    open += leaf.content == Content::open ? 1 : 0;
  }
  CHECK(far == 4);
  CHECK(open == 1);
}
