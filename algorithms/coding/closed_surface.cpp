// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/coding/closed_surface.hpp"

namespace crest::coding {

ClosedSurface::ClosedSurface(const Surface& surface)
    : vertices(surface.counts().vertices),
      faces(surface.face_count()),
      starts(surface.counts().components, kNone) {
  const Index count = 3 * surface.face_count();
  origin.resize(count);
  twin.resize(count);
  for (Index h = 0; h < count; ++h) {
    origin[h] = surface.from(h);
    twin[h] = surface.twin(h);
  }
  Index extra = vertices;
  for (const Index first : surface.loops()) {
    Index& start = starts[surface.component(first / 3)];
    const auto fan = static_cast<Index>(origin.size());
    if (start == kNone) start = fan + 2;
    Index h = first;
    do {
      const Index next = surface.next_on_boundary(h);
      const auto side = static_cast<Index>(origin.size());  // to -> from -> extra
      twin[h] = side;
      origin.insert(origin.end(), {surface.to(h), surface.from(h), extra});
      const Index after = next == first ? fan : side + 3;
      const Index before = side == fan ? kNone : side - 3;
      twin.insert(twin.end(), {h, before == kNone ? kNone : before + 2, after + 1});
      if (next == first) twin[fan + 1] = side + 2;
      h = next;
    } while (h != first);
    ++extra;
  }
  valence.assign(extra, 0);
  for (const Index v : origin) ++valence[v];
  for (Index h = 0; h < count; h += 3)
    if (Index& start = starts[surface.component(h / 3)]; start == kNone) start = h;
}

}  // namespace crest::coding
