// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/coding/closed_surface.hpp"

#include "kernel/geometry/input_error.hpp"

namespace crest::coding {

ClosedSurface::ClosedSurface(const Surface& surface)
    : vertices(surface.counts().vertices),
      faces(surface.face_count()),
      starts(surface.counts().components, kNone) {
  const std::size_t sides = surface.side_count();
  if (faces + sides >= std::size_t{1} << 29)
    throw kernel::InputError("mesh: has 2^29 triangles or more; cut it into parts");
  list.reserve(faces + sides);
  for (Index f = 0; f < faces; ++f) {
    const auto& [a, b, c] = surface.faces()[f];
    Face face{{a, b, c, kNone}, {}};
    for (Index k = 0; k < 3; ++k) {
      const Index twin = surface.twin(3 * f + k);
      face.twin[k] = twin == kNone ? kNone : twin + twin / 3;
    }
    list.push_back(face);
  }
  Index extra = vertices;
  for (const Index first : surface.loops()) {
    Index& start = starts[surface.component(first / 3)];
    const auto fan = static_cast<Index>(4 * list.size());
    if (start == kNone) start = fan + 2;
    Index h = first;
    do {
      const Index after = surface.next_on_boundary(h);
      const auto side = static_cast<Index>(4 * list.size());  // to -> from -> extra
      const Index here = h + h / 3;
      twin(here) = side;
      list.push_back(
          {{surface.to(h), surface.from(h), extra, kNone},
           {here, side == fan ? kNone : side - 2, (after == first ? fan : side + 4) + 1, kNone}});
      if (after == first) twin(fan + 1) = side + 2;
      h = after;
    } while (h != first);
    ++extra;
  }
  valence.assign(extra, 0);
  for (const Face& face : list)
    for (std::size_t k = 0; k < 3; ++k) ++valence[face.origin[k]];
  for (std::size_t c = 0, f = 0; c < starts.size(); ++f) {
    const Index component = surface.component(static_cast<Index>(f));
    if (component != c) continue;  // components are numbered by their first faces
    if (starts[c] == kNone) starts[c] = static_cast<Index>(4 * f);
    ++c;
  }
}

}  // namespace crest::coding
