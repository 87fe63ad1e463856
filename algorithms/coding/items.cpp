// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/coding/items.hpp"

namespace crest::coding {

std::vector<Index> visit_sequence(const Surface& surface) {
  std::vector<Index> sequence;
  VisitOrder order(surface);
  for (Index v = order.take(); v != kNone; v = order.take()) {
    sequence.push_back(v);
    order.visit(v);
  }
  return sequence;
}

bool equal_at(const kernel::Attribute& attribute, std::size_t p, std::size_t q) {
  const std::size_t places = attribute.places();
  for (std::size_t first = 0; first < attribute.words.size(); first += places)
    if (attribute.words[first + p] != attribute.words[first + q]) return false;
  return true;
}

Surroundings Items::around(Index item, const std::vector<bool>& known) const {
  const auto is_known = [&](Index i) { return i != kNone && known[i]; };
  if (site_ == kernel::Site::faces) {
    Surroundings s;
    for (Index h = 3 * item; h < 3 * item + 3; ++h)
      if (const Index twin = surface_.twin(h); twin != kNone && is_known(of_[twin / 3]))
        s.add_neighbour(twin / 3);
    return s;
  }
  const auto each_corner = [&](auto&& each) {
    if (site_ == kernel::Site::vertices) return surface_.around(item, each);
    for (std::size_t i = item == 0 ? 0 : ends_[item - 1]; i < ends_[item]; ++i) each(corners_[i]);
  };
  return surroundings(
      surface_, each_corner, [&](Index h) { return item_of(h); }, is_known);
}

}  // namespace crest::coding
