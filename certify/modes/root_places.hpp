// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Where the roots around a face are on its edges, in doubles or exactly.
#include <algorithm>

#include "certify/container/reject.hpp"
#include "certify/modes/edges.hpp"

namespace crest::certify::modes {

/// A root on the boundary of a face: in (low, high) of a leaf edge whose ends are at these places
/// of the face's edge, measured from corner k to corner k + 1.
template <class Number>
struct RootOnFace {
  u32 root, node;
  unsigned edge;
  double low, high;
  Number first, second;

  Number place(double t) const {
    // At an end exactly that number: roots next to one vertex have the same place.
    return t == 0 ? first : t == 1 ? second : Number(first + Number(t) * (second - first));
  }
};

/// first and second: of the part of an edge, in the whole.
template <class Number>
void list_edge(const LevelContext& context, u32 node, const Number& first, const Number& second,
               std::vector<RootOnFace<Number>>& roots) {
  const EdgeNode& edge = context.trees.edges[node];
  if (edge.leaf()) {
    require(!edge.open, "edge ({}, {}): open, yet of a face that is not", edge.first, edge.second);
    for (u32 i = edge.root; i < edge.root + edge.roots; ++i) {
      const RootRecord& root = context.stated.roots[i];
      roots.push_back({i, node, 0, root.low, root.high, first, second});
    }
    return;
  }
  const unsigned n = context.field.parts(context.trees.edges[edge.other].first).n;
  const Number middle = first + (second - first) * Number(n / 64.0);
  list_edge(context, node + 1, first, middle, roots);
  list_edge(context, edge.other, middle, second, roots);
}

/// All roots around a face, in their order around it. Doubles are wrong by at most kPlaceError: a
/// level of splits adds 3 u, and there are at most 64.
constexpr double kPlaceError = 256 * kUnit;

template <class Number>
std::vector<RootOnFace<Number>> list_roots(const LevelContext& context, const FaceNode& face) {
  std::vector<RootOnFace<Number>> all, some;
  for (unsigned k = 0; k < 3; ++k) {
    some.clear();
    list_edge<Number>(context, face.edges[k].node, 0, 1, some);
    if (face.edges[k].reversed) std::ranges::reverse(some);
    for (auto& root : some) {
      root.edge = k;
      if (face.edges[k].reversed) {
        root.first = 1 - root.first;
        root.second = 1 - root.second;
      }
      all.push_back(root);
    }
  }
  return all;
}

}  // namespace crest::certify::modes
