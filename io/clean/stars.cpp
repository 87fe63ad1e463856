// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/clean/stars.hpp"

#include <algorithm>
#include <iterator>

namespace crest::io {

using kernel::Index;
using kernel::Triangle;

Stars::Stars(Surface& surface)
    : surface_(surface), alive_(surface.faces.size(), true), star_(surface.points.size()) {
  for (Index f = 0; f < surface_.faces.size(); ++f)
    for (const Index v : surface_.faces[f]) star_[v].push_back(f);
}

bool Stars::has(Index f, Index v) const {
  const Triangle& t = surface_.faces[f];
  return t[0] == v || t[1] == v || t[2] == v;
}

Index Stars::third(Index f, Index u, Index v) const {
  const Triangle& t = surface_.faces[f];
  return t[0] ^ t[1] ^ t[2] ^ u ^ v;
}

std::vector<Index> Stars::faces_at(Index u, Index v) const {
  std::vector<Index> faces;
  for (const Index f : star_[u])
    if (has(f, v)) faces.push_back(f);
  return faces;
}

std::vector<Index> Stars::neighbours(Index v) const {
  std::vector<Index> list;
  for (const Index f : star_[v])
    for (const Index w : surface_.faces[f])
      if (w != v) list.push_back(w);
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  return list;
}

/// A fan that is open has a corner more than faces.
bool Stars::on_boundary(Index v) const {
  return neighbours(v).size() > star_[v].size();
}

bool Stars::may_collapse(Index u, Index v) const {
  const std::vector<Index> faces = faces_at(u, v), nu = neighbours(u), nv = neighbours(v);
  std::vector<Index> common;
  std::set_intersection(nu.begin(), nu.end(), nv.begin(), nv.end(), std::back_inserter(common));
  if (common.size() != faces.size()) return false;
  const Index x = common[0];
  if (faces.size() == 1) return !(at_boundary(u, x) && at_boundary(v, x));
  if (on_boundary(u) && on_boundary(v)) return false;
  const auto has_face = [&, y = common[1]](Index w) {
    return std::any_of(star_[w].begin(), star_[w].end(),
                       [&](Index f) { return has(f, x) && has(f, y); });
  };
  return !(has_face(u) && has_face(v));
}

void Stars::collapse(Index kept, Index gone) {
  for (const Index f : faces_at(kept, gone)) leave_out(f);
  for (const Index f : star_[gone]) {
    for (Index& v : surface_.faces[f])
      if (v == gone) v = kept;
    star_[kept].push_back(f);
  }
  star_[gone].clear();
}

void Stars::flip(Index f, Index other, const Triangle& abc, Index d) {
  const auto& [a, b, c] = abc;
  surface_.faces[f] = {a, b, d};
  surface_.faces[other] = {a, d, c};
  std::erase(star_[c], f);
  std::erase(star_[b], other);
  star_[d].push_back(f);
  star_[a].push_back(other);
}

void Stars::leave_out(Index f) {
  alive_[f] = false;
  for (const Index v : surface_.faces[f]) std::erase(star_[v], f);
}

}  // namespace crest::io
