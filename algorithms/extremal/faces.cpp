// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/extremal/faces.hpp"

#include <algorithm>

#include "algorithms/extremal/dual.hpp"

namespace crest::extremal {

/// Of the corners 0 and 2, or 1 and 3, those are joined whose sign g has at the bilinear saddle;
/// where no cell at the face orients n: the lowest edge with its successor.
bool Faces::pairs_swapped(const Node& p, std::size_t normal) const {
  const Grid& grid = fields_.grid();
  const std::size_t a = next(normal), b = after_next(normal), at = grid.index(p);
  const std::array<std::size_t, 4> corners = {
      at, at + grid.stride[a], at + grid.stride[a] + grid.stride[b], at + grid.stride[b]};
  std::size_t cell = at;
  if (!cells_.decides(cell)) {
    if (p[normal] == 0) return false;
    cell -= grid.stride[normal];
    if (!cells_.decides(cell)) return false;
  }
  const Vec3 w = unit(cells_.direction(cell));
  const auto oriented = [&](const Local& l) {
    const Vec3 n = dominant_direction(l.tensor);
    return kernel::dot(n, l.gradient) * side(n, w);
  };
  std::array<double, 4> g;
  for (std::size_t i = 0; i < 4; ++i) {
    const Node v = grid.node(corners[i]);
    // Signs are those that were decided.
    g[i] = std::fabs(oriented(fields_.at(v, {0, 0, 0}))) * nodes_.sign(corners[i]) *
           side(nodes_.direction(corners[i]), w);
  }
  const double sum = g[0] + g[2] - g[1] - g[3];
  if (sum == 0) return false;
  Vec3 t{};
  t[a] = std::clamp((g[0] - g[3]) / sum, 0.0, 1.0);
  t[b] = std::clamp((g[0] - g[1]) / sum, 0.0, 1.0);
  const double saddle = oriented(fields_.at(p, t));
  // Corner 0 apart from corner 2: arcs round both, {3, 0} and {1, 2}.
  return (saddle > 0) != (g[0] > 0);
}

Face Faces::face(const Node& p, std::size_t normal) const {
  const Grid& grid = fields_.grid();
  const std::size_t a = next(normal), b = after_next(normal), at = grid.index(p);
  Face f;
  f.edges = {static_cast<Index>(3 * at + a), static_cast<Index>(3 * (at + grid.stride[a]) + b),
             static_cast<Index>(3 * (at + grid.stride[b]) + a), static_cast<Index>(3 * at + b)};
  for (std::size_t i = 0; i < 4; ++i) {
    const bool critical = edges_.critical(f.edges[i]);
    f.group[i] = static_cast<std::int8_t>(critical ? static_cast<int>(i) : -1);
    f.critical += critical ? 1 : 0;
    f.tested = f.tested && edges_.tested(f.edges[i]);
  }
  if (!f.tested || f.critical < 2) return f;
  if (f.critical == 4) {
    f.swapped = pairs_swapped(p, normal);
    f.group =
        f.swapped ? std::array<std::int8_t, 4>{0, 1, 1, 0} : std::array<std::int8_t, 4>{0, 0, 2, 2};
    return f;
  }
  std::int8_t first = -1;
  for (auto& group : f.group) {
    if (group < 0) continue;
    if (first < 0) first = group;
    group = first;
  }
  return f;
}

std::array<Index, 12> edges_of_cell(const Grid& grid, const Node& cell) {
  const std::size_t at = grid.index(cell);
  std::array<Index, 12> r;
  if (grid.dimension() == 2) {
    r.fill(kernel::kNone);
    const auto round = Dual(grid).edges_of({cell, 2});
    std::copy(round.begin(), round.end(), r.begin());
    return r;
  }
  for (std::size_t axis = 0, n = 0; axis < 3; ++axis)
    for (std::size_t i = 0; i < 4; ++i, ++n)
      r[n] = static_cast<Index>(
          3 * (at + (i & 1) * grid.stride[next(axis)] + (i >> 1) * grid.stride[after_next(axis)]) +
          axis);
  return r;
}

std::array<std::int8_t, 12> Faces::sheets(const Node& cell) const {
  const auto edges = edges_of_cell(fields_.grid(), cell);
  std::array<std::int8_t, 12> parent;
  for (std::size_t i = 0; i < 12; ++i)
    parent[i] = static_cast<std::int8_t>(edges_.critical(edges[i]) ? static_cast<int>(i) : -1);
  const auto place = [&](Index e) {
    return static_cast<std::size_t>(std::find(edges.begin(), edges.end(), e) - edges.begin());
  };
  const auto join = [&](std::int8_t a, std::int8_t b) {
    const auto low = std::min(a, b), high = std::max(a, b);
    for (auto& x : parent)
      if (x == high) x = low;
  };
  for (std::size_t normal = 0; normal < 3; ++normal)
    for (int far = 0; far < 2; ++far) {
      Node p = cell;
      p[normal] += far;
      const Face f = face(p, normal);
      for (std::size_t i = 0; i < 4; ++i)
        if (f.group[i] >= 0)
          join(parent[place(f.edges[i])],
               parent[place(f.edges[static_cast<std::size_t>(f.group[i])])]);
    }
  std::int8_t count = 0;
  std::array<std::int8_t, 12> number, r;
  number.fill(-1);
  for (std::size_t i = 0; i < 12; ++i) {
    if (parent[i] < 0) {
      r[i] = -1;
      continue;
    }
    auto& n = number[static_cast<std::size_t>(parent[i])];
    if (n < 0) n = count++;
    r[i] = n;
  }
  return r;
}

}  // namespace crest::extremal
