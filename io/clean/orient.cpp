// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/clean/orient.hpp"

#include <algorithm>

#include "kernel/predicates/enclosed_volume.hpp"

namespace crest::io {

using kernel::Index;
using kernel::kNone;

Parts parts_of(const Neighbours& across) {
  Parts result;
  result.of.assign(across.size(), kNone);
  result.against.assign(across.size(), 0);
  std::vector<Index> faces;
  for (Index first = 0; first < across.size(); ++first) {
    if (result.of[first] != kNone) continue;
    const auto number = static_cast<Index>(result.parts.size());
    Parts::Part part;
    result.of[first] = number;
    faces.assign(1, first);
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const Index f = faces[i];
      part.against += result.against[f];
      for (std::uint8_t k = 0; k < 3; ++k) {
        const Neighbour& n = across[f][k];
        if (n.face == kNone) {
          part.closed = false;
          continue;
        }
        const std::uint8_t wanted = result.against[f] ^ static_cast<std::uint8_t>(!n.agrees);
        if (result.of[n.face] == kNone) {
          result.of[n.face] = number;
          result.against[n.face] = wanted;
          faces.push_back(n.face);
        } else if (result.against[n.face] != wanted && f <= n.face) {
          result.clashes.emplace_back(f, k);
        }
      }
    }
    part.faces = faces.size();
    result.parts.push_back(part);
  }
  std::sort(result.clashes.begin(), result.clashes.end());
  return result;
}

namespace {

void turn_face(Surface& surface, std::size_t f) {
  std::swap(surface.faces[f][1], surface.faces[f][2]);
  if (!surface.places.empty()) std::swap(surface.places[f][1], surface.places[f][2]);
}

}  // namespace

std::size_t turn_minorities(Surface& surface, const Parts& parts) {
  std::size_t turned = 0;
  for (Index f = 0; f < surface.faces.size(); ++f) {
    const Parts::Part& part = parts.parts[parts.of[f]];
    if (parts.against[f] != (2 * part.against > part.faces ? 0 : 1)) continue;
    turn_face(surface, f);
    ++turned;
  }
  return turned;
}

std::vector<bool> inside_out(const Surface& surface, const Parts& parts) {
  std::vector<std::size_t> begin(parts.parts.size() + 1, 0);
  for (std::size_t p = 0; p < parts.parts.size(); ++p)
    begin[p + 1] = begin[p] + (parts.parts[p].closed ? parts.parts[p].faces : 0);
  std::vector<kernel::Triangle> faces(begin.back());
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for (std::size_t f = 0; f < surface.faces.size(); ++f)
    if (parts.parts[parts.of[f]].closed) faces[next[parts.of[f]]++] = surface.faces[f];
  std::vector<bool> marked(parts.parts.size(), false);
  for (std::size_t p = 0; p < marked.size(); ++p) {
    if (!parts.parts[p].closed) continue;
    const std::span<const kernel::Triangle> own(faces.data() + begin[p], begin[p + 1] - begin[p]);
    marked[p] = kernel::enclosed_volume(surface.points, own) == kernel::Sign::negative;
  }
  return marked;
}

void turn(Surface& surface, const Parts& parts, const std::vector<bool>& marked) {
  for (std::size_t f = 0; f < surface.faces.size(); ++f)
    if (marked[parts.of[f]]) turn_face(surface, f);
}

}  // namespace crest::io
