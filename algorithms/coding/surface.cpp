// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/coding/surface.hpp"

namespace crest::coding {

Surface::Surface(Index vertices, std::span<const Triangle> faces)
    : faces_(faces), table_(vertices, faces) {
  counts_ = {.vertices = vertices, .components = 0};
  find_components();
  find_loops();
  std::int64_t sides = 0;  // of edges of one face
  for (Index h = 0; h < 3 * face_count(); ++h) sides += twin(h) == kNone ? 1 : 0;
  // V - E + F = 2 c - 2 g - h, and 2 E = 3 F + sides.
  const std::int64_t f = face_count();
  const std::int64_t twice = 2 * std::int64_t{vertices} - (3 * f + sides) + 2 * f;
  counts_.loops = static_cast<Index>(loops_.size());
  counts_.handles = static_cast<Index>(
      (4 * std::int64_t{counts_.components} - 2 * std::int64_t{counts_.loops} - twice) / 4);
}

void Surface::find_components() {
  component_.assign(face_count(), kNone);
  std::vector<Index> waiting;
  for (Index first = 0; first < face_count(); ++first) {
    if (component_[first] != kNone) continue;
    component_[first] = counts_.components;
    waiting.push_back(first);
    while (!waiting.empty()) {
      const Index f = waiting.back();
      waiting.pop_back();
      for (Index h = 3 * f; h < 3 * f + 3; ++h) {
        if (twin(h) == kNone || component_[twin(h) / 3] != kNone) continue;
        component_[twin(h) / 3] = counts_.components;
        waiting.push_back(twin(h) / 3);
      }
    }
    ++counts_.components;
  }
}

Index Surface::next_on_boundary(Index h) const {
  h = next_half(h);
  while (twin(h) != kNone) h = next_half(twin(h));
  return h;
}

void Surface::find_loops() {
  std::vector<bool> seen(3 * std::size_t{face_count()}, false);
  for (Index h = 0; h < 3 * face_count(); ++h) {
    if (twin(h) != kNone || seen[h]) continue;
    loops_.push_back(h);
    for (Index g = h; !seen[g]; g = next_on_boundary(g)) seen[g] = true;
  }
}

}  // namespace crest::coding
