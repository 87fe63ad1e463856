// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/ridges_smooth/box_pairs.hpp"

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>

#include "certify/container/reject.hpp"

namespace crest::certify::smooth {

std::vector<std::pair<std::size_t, std::size_t>> meeting_boxes(
    const std::vector<std::array<kernel::Range, 3>>& a,
    const std::vector<std::array<kernel::Range, 3>>& b, std::size_t most) {
  using Item = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;
  const auto items_of = [](const auto& boxes) {
    std::vector<Item> items;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const auto& [x, y, z] = boxes[i];
      double low[] = {x.low, y.low, z.low}, high[] = {x.high, y.high, z.high};
      items.push_back(Item(low, high, i));
    }
    return items;
  };
  std::vector<Item> left = items_of(a), right = items_of(b);
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  CGAL::box_intersection_d(left.begin(), left.end(), right.begin(), right.end(),
                           [&](const Item& x, const Item& y) {
                             require(pairs.size() < most, "more boxes meet than the claim names");
                             pairs.emplace_back(x.info(), y.info());
                           });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace crest::certify::smooth
