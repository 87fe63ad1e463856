// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/extremal/edges.hpp"

#include <algorithm>

#include "kernel/geometry/parallel.hpp"

namespace crest::extremal {
namespace {

constexpr std::size_t kNoCell = ~std::size_t{0};

template <class T>
void append(std::vector<T>& to, std::vector<T>& from) {
  to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
  from = {};
}

}  // namespace

/// The first cell (an image: square) at the edge that passes the cone test.
std::size_t Edges::deciding_cell(const Node& v, std::size_t axis) const {
  const Grid& g = fields_.grid();
  const std::size_t b = next(axis), c = after_next(axis);
  for (int i = 3; i >= 0; --i) {
    Node cell = v;
    cell[b] -= i & 1;
    cell[c] -= i >> 1;
    if (cell[b] < 0 || cell[c] < 0) continue;
    const std::size_t n = g.index(cell);
    if (cells_.decides(n)) return n;
  }
  return kNoCell;
}

void Edges::decide(const Node& v, std::size_t axis, Slice& slice) {
  const Grid& g = fields_.grid();
  const std::size_t a = g.index(v), b = a + g.stride[axis];
  const auto e = static_cast<Index>(3 * a + axis);
  const Vec3 na = nodes_.direction(a), nb = nodes_.direction(b);
  const std::size_t cell = deciding_cell(v, axis);
  const bool counts =
      counted_.has({static_cast<Index>(v[0]), static_cast<Index>(v[1]), static_cast<Index>(v[2])});
  Transport way;
  EdgeNet net;
  int lower, upper;
  if (cell != kNoCell) {
    const Vec3 w = unit(cells_.direction(cell));
    lower = nodes_.sign(a) * side(na, w);
    upper = nodes_.sign(b) * side(nb, w);
    if (counts) slice.count(0, 1);
  } else {
    net = edge_net(fields_, v, axis);
    way = transport(net, na, nb);
    if (counts) slice.tests += way.tests;
    if (!way.decided) {
      states_[e] = EdgeState::undecided;
      slice.undecided.push_back(e);
      return;
    }
    if (counts) slice.count(static_cast<std::size_t>(way.depth), 0);
    int turned = 1;
    for (std::size_t i = 0; i + 1 < way.leaves.size(); ++i)
      turned *= side(unit(way.leaves[i].w), unit(way.leaves[i + 1].w));
    lower = nodes_.sign(a) * side(na, unit(way.leaves.front().w));
    // In the orientation of the last leaf, which the first one's is brought to.
    upper = nodes_.sign(b) * side(nb, unit(way.leaves.back().w));
    slice.bisected.add(e, way);
    if (lower * turned == upper) {
      states_[e] = EdgeState::plain;
      return;
    }
  }
  if (cell != kNoCell) {
    if (lower == upper) {
      states_[e] = EdgeState::plain;
      return;
    }
    net = edge_net(fields_, v, axis);
    way.leaves = {{0, 1, cells_.direction(cell)}};
  }
  const ZeroType type = zero_type(net, way.leaves);
  states_[e] = type == ZeroType::extremal          ? EdgeState::extremal
               : type == ZeroType::merely_critical ? EdgeState::merely_critical
                                                   : EdgeState::type_undecided;
  slice.critical.push_back({e, zero_place(net, way.leaves, lower, upper)});
}

Edges::Edges(const Fields& fields, const Nodes& nodes, const Cells& cells,
             const kernel::GridBox& counted)
    : fields_(fields), nodes_(nodes), cells_(cells), counted_(counted) {
  const Grid& g = fields.grid();
  states_.assign(3 * g.nodes(), EdgeState::untested);
  std::vector<Slice> slices(static_cast<std::size_t>(g.size[2]));
  kernel::parallel_for(0, g.size[2], [&](int k) {
    for (int j = 0; j < g.size[1]; ++j)
      for (int i = 0; i < g.size[0]; ++i) {
        const Node v = {i, j, k};
        const std::size_t a = g.index(v);
        if (!nodes_.active(a)) continue;
        for (std::size_t axis = 0; axis < 3; ++axis)
          if (v[axis] + 1 < g.size[axis] && nodes_.active(a + g.stride[axis]))
            decide(v, axis, slices[static_cast<std::size_t>(k)]);
      }
  });
  depths_.assign(15, 0);
  std::size_t found = 0;
  for (const Slice& s : slices) found += s.critical.size();
  critical_.reserve(found);
  for (Slice& s : slices) {
    append(critical_, s.critical);
    append(bisected_.edges, s.bisected.edges);
    append(bisected_.trees, s.bisected.trees);
    append(bisected_.leaves, s.bisected.leaves);
    append(undecided_, s.undecided);
    tests_ += s.tests;
    for (std::size_t d = 0; d < depths_.size(); ++d) depths_[d] += s.depths[d];
  }
}

std::size_t Edges::find(Index e) const {
  const auto at = std::lower_bound(critical_.begin(), critical_.end(), e,
                                   [](const CriticalEdge& c, Index x) { return c.edge < x; });
  return static_cast<std::size_t>(at - critical_.begin());
}

}  // namespace crest::extremal
