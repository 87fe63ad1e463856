// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Which edges, faces and cells of the grid touch (SPEC.md, "Numbers").
#include "certify/extremal/fields.hpp"

namespace crest::certify::extremal {

inline constexpr u32 kNothing = 0xffffffffU;

struct EdgePlace {
  u32 node;
  unsigned axis;
};
inline EdgePlace edge_place(const Grid& grid, u32 edge) {
  return {edge / grid.dimension, edge % grid.dimension};
}
inline bool is_edge(const Grid& grid, u32 edge) {
  const auto [node, axis] = edge_place(grid, edge);
  return node < grid.count && grid.place(node)[axis] + 1 < grid.nodes[axis];
}

/// Calls visit(edge, axis, low corner, high corner) for the edges of a cell; corners are numbered
/// by their bits.
template <class Visit>
void for_edges_of_cell(const Grid& grid, u32 cell, const Visit& visit) {
  for (unsigned corner = 0; corner < grid.corners(); ++corner) {
    u32 node = cell;
    for (unsigned k = 0; k < grid.dimension; ++k)
      if ((corner >> k & 1U) != 0) node += grid.stride[k];
    for (unsigned axis = 0; axis < grid.dimension; ++axis)
      if ((corner >> axis & 1U) == 0) visit(grid.edge(node, axis), corner, corner | 1U << axis);
  }
}
inline u32 corner_node(const Grid& grid, u32 cell, unsigned corner) {
  for (unsigned k = 0; k < grid.dimension; ++k)
    if ((corner >> k & 1U) != 0) cell += grid.stride[k];
  return cell;
}

/// A square of four edges: a face of a volume, a cell of an image. Its edges follow one another.
struct Square {
  u32 id = kNothing;
  std::array<u32, 4> edges{};
};
/// From its lowest node, along axes a and b.
inline Square square(const Grid& grid, u32 id, u32 node, unsigned a, unsigned b) {
  return {id,
          {grid.edge(node, a), grid.edge(node + grid.stride[a], b),
           grid.edge(node + grid.stride[b], a), grid.edge(node, b)}};
}
/// Of a volume: face 3 * node + normal.
inline Square face(const Grid& grid, u32 node, unsigned normal) {
  return square(grid, 3 * node + normal, node, (normal + 1) % 3, (normal + 2) % 3);
}
/// Of an image: the cell.
inline Square cell_square(const Grid& grid, u32 cell) {
  return square(grid, cell, cell, 0, 1);
}

/// The squares that have the edge: 4 of a volume in the order in which they lie round it, from the
/// first to the second axis after the edge's own; 2 of an image. Those beyond the border have no
/// id.
struct SquaresRound {
  std::array<Square, 4> at;
  unsigned count;
};
inline SquaresRound squares_round(const Grid& grid, u32 edge) {
  const auto [node, axis] = edge_place(grid, edge);
  const Place p = grid.place(node);
  SquaresRound out{{}, grid.dimension == 3 ? 4U : 2U};
  if (grid.dimension == 2) {
    const unsigned a = 1 - axis;
    if (p[a] > 0) out.at[0] = cell_square(grid, node - grid.stride[a]);
    if (p[a] + 1 < grid.nodes[a]) out.at[1] = cell_square(grid, node);
    return out;
  }
  const unsigned a = (axis + 1) % 3, b = (axis + 2) % 3;
  if (p[b] > 0) out.at[0] = face(grid, node - grid.stride[b], a);
  if (p[a] + 1 < grid.nodes[a]) out.at[1] = face(grid, node, b);
  if (p[b] + 1 < grid.nodes[b]) out.at[2] = face(grid, node, a);
  if (p[a] > 0) out.at[3] = face(grid, node - grid.stride[a], b);
  return out;
}
/// Has the edge all its cells round it?
inline bool is_inside(const Grid& grid, u32 edge) {
  const auto around = squares_round(grid, edge);
  for (unsigned i = 0; i < around.count; ++i)
    if (around.at[i].id == kNothing) return false;
  return true;
}
/// The cells round an edge that is inside: in a volume cell i and i + 1 meet in square i.
inline std::array<u32, 4> cells_round(const Grid& grid, u32 edge) {
  const auto [node, axis] = edge_place(grid, edge);
  if (grid.dimension == 2) return {node - grid.stride[1 - axis], node, kNothing, kNothing};
  const u32 a = grid.stride[(axis + 1) % 3], b = grid.stride[(axis + 2) % 3];
  return {node - a - b, node - b, node, node - a};
}

}  // namespace crest::certify::extremal
