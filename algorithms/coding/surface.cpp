// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/coding/surface.hpp"

#include <algorithm>
#include <numeric>

namespace crest::coding {

Surface::Surface(Index vertices, std::span<const Triangle> faces)
    : faces_(faces), table_(vertices, faces) {
  counts_ = {.vertices = vertices, .components = 0};
  find_components();
  find_loops();
  // V - E + F = 2 c - 2 g - h, and 2 E = 3 F + sides.
  const std::int64_t f = face_count(), sides = static_cast<std::int64_t>(sides_);
  const std::int64_t twice = 2 * std::int64_t{vertices} - (3 * f + sides) + 2 * f;
  counts_.loops = static_cast<Index>(loops_.size());
  counts_.handles = static_cast<Index>(
      (4 * std::int64_t{counts_.components} - 2 * std::int64_t{counts_.loops} - twice) / 4);
}

void Surface::find_components() {
  // Each vertex points to a lower one of its component, or to itself.
  std::vector<Index>& lower = component_;
  lower.resize(counts_.vertices);
  std::iota(lower.begin(), lower.end(), Index{0});
  const auto lowest = [&](Index v) {
    for (; lower[v] != v; v = lower[v]) lower[v] = lower[lower[v]];
    return v;
  };
  Index parts = counts_.vertices;
  for (Index f = 0; f < face_count() && parts > 1; ++f) {
    Index a = lowest(faces_[f][0]);
    for (const Index v : {faces_[f][1], faces_[f][2]}) {
      const Index b = lowest(v);
      if (a == b) continue;
      lower[std::max(a, b)] = std::min(a, b);
      a = std::min(a, b);
      --parts;
    }
  }
  for (Index v = 0; v < lower.size(); ++v) lower[v] = lower[lower[v]];
  counts_.components = parts;
  // Numbered by their first faces.
  std::vector<Index> number(parts > 1 ? lower.size() : 1, kNone);
  Index next = 0;
  for (Index f = 0; f < face_count() && next < parts; ++f)
    if (Index& mine = number[lower[faces_[f][0]]]; mine == kNone) mine = next++;
  for (Index& v : lower) v = number[v];
}

Index Surface::next_on_boundary(Index h) const {
  h = next_half(h);
  while (twin(h) != kNone) h = next_half(twin(h));
  return h;
}

void Surface::find_loops() {
  for (Index h = 0; h < 3 * face_count(); ++h) sides_ += twin(h) == kNone ? 1 : 0;
  if (sides_ == 0) return;
  std::vector<bool> seen(3 * std::size_t{face_count()}, false);
  for (Index h = 0; h < 3 * face_count(); ++h) {
    if (twin(h) != kNone || seen[h]) continue;
    loops_.push_back(h);
    for (Index g = h; !seen[g]; g = next_on_boundary(g)) seen[g] = true;
  }
}

}  // namespace crest::coding
