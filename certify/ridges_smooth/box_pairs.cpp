// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/ridges_smooth/box_pairs.hpp"

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <tuple>

#include "certify/container/reject.hpp"

namespace crest::certify::smooth {

namespace {

using Boxes = std::vector<std::array<kernel::Range, 3>>;
using Item = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;

/// The boxes of both lists with ranks for ends, which meet as before: CGAL compares all pairs where
/// it cannot split for equal ends.
std::vector<Item> with_distinct_ends(const Boxes& a, const Boxes& b) {
  struct End {
    double value;
    bool high;
    std::size_t box;
  };
  const std::size_t n = a.size() + b.size();
  std::vector<std::array<double, 3>> low(n), high(n);
  std::vector<End> ends(2 * n);
  for (std::size_t d = 0; d < 3; ++d) {
    for (std::size_t i = 0; i < n; ++i) {
      const kernel::Range& r = (i < a.size() ? a[i] : b[i - a.size()])[d];
      ends[2 * i] = {r.low, false, i};
      ends[2 * i + 1] = {r.high, true, i};
    }
    std::sort(ends.begin(), ends.end(), [](const End& x, const End& y) {
      return std::tie(x.value, x.high, x.box) < std::tie(y.value, y.high, y.box);
    });
    for (std::size_t k = 0; k < ends.size(); ++k)
      (ends[k].high ? high : low)[ends[k].box][d] = static_cast<double>(k);
  }
  std::vector<Item> items;
  for (std::size_t i = 0; i < n; ++i)
    items.push_back(Item(low[i].data(), high[i].data(), i < a.size() ? i : i - a.size()));
  return items;
}

}  // namespace

std::vector<std::pair<std::size_t, std::size_t>> meeting_boxes(const Boxes& a, const Boxes& b,
                                                               std::size_t most) {
  std::vector<Item> items = with_distinct_ends(a, b);
  const auto middle = items.begin() + static_cast<std::ptrdiff_t>(a.size());
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  CGAL::box_intersection_d(items.begin(), middle, middle, items.end(),
                           [&](const Item& x, const Item& y) {
                             require(pairs.size() < most, "more boxes meet than the claim names");
                             pairs.emplace_back(x.info(), y.info());
                           });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace crest::certify::smooth
