// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/extremal/mesh.hpp"

#include <algorithm>

#include "certify/container/reject.hpp"
#include "certify/surface/union_find.hpp"

namespace crest::certify::extremal {
namespace {

class MeshBuilder {
 public:
  MeshBuilder(const Grid& grid, const Edges& edges, const Squares& squares)
      : grid_(grid), edges_(edges), squares_(squares) {}

  Mesh build() {
    mesh_.corners = grid_.dimension == 3 ? 4 : 2;
    for (const u32 edge : edges_.critical)
      if (edges_.is_extremal(edge) && is_inside(grid_, edge)) mesh_.polygons.push_back(edge);
    require(mesh_.polygons.size() <= 0x10000000U, "mesh: more than 2^28 polygons");
    mesh_.seams.reserve(size_t{mesh_.corners / 2} * mesh_.polygons.size());
    for (u32 polygon = 0; polygon < mesh_.polygons.size(); ++polygon) {
      const auto around = squares_round(grid_, mesh_.polygons[polygon]);
      for (u32 side = 0; side < around.count; ++side) add_seam({polygon, side}, around.at[side]);
    }
    number_vertices();
    return std::move(mesh_);
  }

 private:
  u32 polygon_of(u32 edge) const {
    const auto at = std::ranges::lower_bound(mesh_.polygons, edge);
    return at != mesh_.polygons.end() && *at == edge ? static_cast<u32>(at - mesh_.polygons.begin())
                                                     : kNothing;
  }
  static u32 side_on(const Grid& grid, u32 edge, u32 square) {
    const auto around = squares_round(grid, edge);
    u32 side = 0;
    while (around.at[side].id != square) ++side;
    return side;
  }

  /// Once for each group: when its first polygon comes.
  void add_seam(const Side& own, const Square& square) {
    const Groups groups = squares_.groups(square);
    const u32 edge = mesh_.polygons[own.polygon];
    const auto slot =
        static_cast<size_t>(std::ranges::find(square.edges, edge) - square.edges.begin());
    Seam seam{{own}, 1, 0};
    unsigned mates = 0;
    std::uint8_t other = 4;  // the reason, if the mate has no polygon
    for (size_t i = 0; i < 4; ++i) {
      if (i == slot || groups.group[i] != groups.group[slot]) continue;
      ++mates;
      const u32 mate = square.edges[i], polygon = polygon_of(mate);
      if (polygon < own.polygon) return;
      if (polygon != kNothing)
        seam.sides[seam.count++] = {polygon, side_on(grid_, mate, square.id)};
      else if (!edges_.is_extremal(mate))
        other = edges_.is_undecided(mate) ? 5 : 2;
    }
    if (!groups.tested)
      seam.reason = static_cast<std::uint8_t>(squares_.border_reason(square));
    else if (seam.count != 2)
      seam.reason = mates == 1 ? other : 1;
    mesh_.seams.push_back(seam);
  }

  void number_vertices() {
    const u32 m = mesh_.corners;
    UnionFind classes(m * mesh_.polygons.size());
    for (const Seam& seam : mesh_.seams)
      for (unsigned i = 1; i < seam.count; ++i) {
        const Side &a = seam.sides[0], &b = seam.sides[i];
        if (grid_.dimension == 2) {
          classes.join(m * a.polygon + a.side, m * b.polygon + b.side);
          continue;
        }
        classes.join(m * a.polygon + side_ends(a.side).low, m * b.polygon + side_ends(b.side).low);
        classes.join(m * a.polygon + side_ends(a.side).high,
                     m * b.polygon + side_ends(b.side).high);
      }
    std::vector<std::array<u32, 2>> order;  // cell, first corner of the class
    for (u32 polygon = 0; polygon < mesh_.polygons.size(); ++polygon) {
      const auto cells = cells_round(grid_, mesh_.polygons[polygon]);
      for (u32 i = 0; i < m; ++i)
        if (classes.find(m * polygon + i) == m * polygon + i)
          order.push_back({cells[i], m * polygon + i});
    }
    std::ranges::sort(order);
    mesh_.vertex.resize(m * mesh_.polygons.size());
    for (u32 i = 0; i < order.size(); ++i) {
      mesh_.vertex[order[i][1]] = i;
      mesh_.vertex_cells.push_back(order[i][0]);
    }
    for (u32 corner = 0; corner < mesh_.vertex.size(); ++corner)
      mesh_.vertex[corner] = mesh_.vertex[classes.find(corner)];
  }

  const Grid& grid_;
  const Edges& edges_;
  const Squares& squares_;
  Mesh mesh_;
};

}  // namespace

Mesh build_mesh(const Grid& grid, const Edges& edges, const Squares& squares) {
  return MeshBuilder(grid, edges, squares).build();
}

}  // namespace crest::certify::extremal
