// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/clean/drop.hpp"

#include <algorithm>

namespace crest::io {

using kernel::Index;
using kernel::kNone;

void keep_faces(Surface& surface, const std::vector<bool>& kept) {
  std::size_t to = 0;
  for (std::size_t f = 0; f < kept.size(); ++f) {
    if (!kept[f]) continue;
    surface.faces[to] = surface.faces[f];
    surface.cell_of[to] = surface.cell_of[f];
    for (auto* list : {&surface.midside, &surface.places})
      if (!list->empty()) (*list)[to] = (*list)[f];
    ++to;
  }
  surface.faces.resize(to);
  surface.cell_of.resize(to);
  for (auto* list : {&surface.midside, &surface.places})
    if (!list->empty()) list->resize(to);
}

std::size_t drop_repeated_corners(Surface& surface) {
  std::vector<bool> kept(surface.faces.size());
  std::size_t dropped = 0;
  for (std::size_t f = 0; f < kept.size(); ++f) {
    const auto& [a, b, c] = surface.faces[f];
    kept[f] = a != b && b != c && c != a;
    dropped += !kept[f];
  }
  if (dropped > 0) keep_faces(surface, kept);
  return dropped;
}

std::size_t drop_duplicates(Surface& surface, const std::vector<Side>& sides) {
  std::vector<bool> kept(surface.faces.size(), true);
  for (std::size_t i = 1; i < sides.size(); ++i) {
    const Side &s = sides[i - 1], &t = sides[i];
    if (s.low == t.low && s.high == t.high && s.third == t.third) kept[t.face] = false;
  }
  const auto dropped = static_cast<std::size_t>(std::count(kept.begin(), kept.end(), false));
  if (dropped > 0) keep_faces(surface, kept);
  return dropped;
}

std::size_t drop_unused(Surface& surface) {
  std::vector<bool> between;  // of the soup's points
  for (const Index point : surface.between) {
    if (point >= between.size()) between.resize(point + std::size_t{1}, false);
    between[point] = true;
  }
  std::vector<Index> number(surface.points.size(), kNone);
  for (const kernel::Triangle& face : surface.faces)
    for (const Index v : face) number[v] = 0;
  Index to = 0;
  std::size_t dropped = 0;
  for (Index v = 0; v < number.size(); ++v) {
    if (number[v] == kNone) {
      const Index point = surface.point_of[v];
      dropped += point >= between.size() || !between[point];
      continue;
    }
    number[v] = to;
    surface.points[to] = surface.points[v];
    surface.point_of[to++] = surface.point_of[v];
  }
  if (to == number.size()) return 0;
  surface.points.resize(to);
  surface.point_of.resize(to);
  for (kernel::Triangle& face : surface.faces)
    for (Index& v : face) v = number[v];
  return dropped;
}

}  // namespace crest::io
