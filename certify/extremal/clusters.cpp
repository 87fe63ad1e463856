// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/extremal/clusters.hpp"

#include <algorithm>

namespace crest::certify::extremal {
namespace {

namespace code = extremal_code;

struct Cluster {
  bool good = true;      ///< theorem 15 holds for it
  bool extremal = true;  ///< s_nn > 0 on all of its cells
};

class Clusters {
 public:
  Clusters(const Grid& grid, const Cells& cells, const Edges& edges, const Squares& squares)
      : grid_(grid),
        cells_(cells),
        edges_(edges),
        squares_(squares),
        number_(grid.count, kNothing) {}

  /// The cluster of a cell, flooded when it is first asked for.
  Cluster of(u32 cell) {
    if (!is_regular(cell)) return {false, false};
    if (number_[cell] == kNothing) flood(cell);
    return clusters_[number_[cell]];
  }

 private:
  bool is_regular(u32 cell) const {
    const std::uint8_t stated = cells_.code(cell);
    return stated == code::kRegular || stated == code::kRegularExtremal;
  }

  void flood(u32 seed) {
    const auto number = static_cast<u32>(clusters_.size());
    clusters_.push_back({});
    std::vector<u32> waiting{seed};
    number_.at(seed) = number;
    while (!waiting.empty()) {
      const u32 cell = waiting.back();
      waiting.pop_back();
      Cluster& cluster = clusters_[number];
      cluster.extremal &= cells_.code(cell) == code::kRegularExtremal;
      const Place p = grid_.place(cell);
      if (touches_border(p)) {  // what lies beyond is not proven
        cluster.good = false;
        continue;
      }
      cluster.good &= cells_.is_boxed(cell) && has_one_sheet(cell);
      for_neighbours(cell, [&](u32 other) {
        if (cells_.code(other) == code::kEmpty || number_[other] == number) return;
        if (!is_regular(other)) {
          cluster.good = false;
          return;
        }
        number_.at(other) = number;
        waiting.push_back(other);
      });
    }
  }
  bool touches_border(const Place& p) const {
    for (unsigned k = 0; k < grid_.dimension; ++k)
      if (p[k] == 0 || p[k] + 2 >= grid_.nodes[k]) return true;
    return false;
  }
  /// Cells that share a point with this one, which does not touch the border.
  template <class Visit>
  void for_neighbours(u32 cell, const Visit& visit) const {
    const u32 layer = grid_.dimension == 3 ? grid_.stride[2] : 0;
    for (u32 z = 0; z < (grid_.dimension == 3 ? 3U : 1U); ++z)
      for (u32 y = 0; y < 3; ++y)
        for (u32 x = 0; x < 3; ++x)
          visit(cell + (x + y * grid_.stride[1] + z * layer) - (1 + grid_.stride[1] + layer));
  }

  /// No square of the cell has four critical edges, and all critical edges are joined.
  bool has_one_sheet(u32 cell) const {
    std::vector<u32> critical;
    for_edges_of_cell(grid_, cell, [&](u32 edge, unsigned, unsigned) {
      if (edges_.is_critical(edge)) critical.push_back(edge);
    });
    if (critical.empty()) return true;
    std::vector<u32> reached{critical[0]};
    for (size_t i = 0; i < reached.size(); ++i)
      for (const Square& square : squares_of(cell)) {
        if (std::ranges::count(square.edges, reached[i]) == 0) continue;
        const Groups groups = squares_.groups(square);
        if (groups.critical == 4) return false;
        for (const u32 edge : square.edges)
          if (edges_.is_critical(edge) && std::ranges::count(reached, edge) == 0)
            reached.push_back(edge);
      }
    return reached.size() == critical.size();
  }
  std::vector<Square> squares_of(u32 cell) const {
    if (grid_.dimension == 2) return {cell_square(grid_, cell)};
    std::vector<Square> out;
    for (unsigned k = 0; k < 3; ++k) {
      out.push_back(face(grid_, cell, k));
      out.push_back(face(grid_, cell + grid_.stride[k], k));
    }
    return out;
  }

  const Grid& grid_;
  const Cells& cells_;
  const Edges& edges_;
  const Squares& squares_;
  Sparse<u32> number_;
  std::vector<Cluster> clusters_;
};

}  // namespace

void find_isotopic(const ExtremalCertificate& c, const Grid& grid, const Cells& cells,
                   const Edges& edges, const Squares& squares, const Mesh& mesh,
                   Components& components) {
  if (c.data.hessian) return;  // g is not C1: SPEC.md
  for (ExtremalComponent& component : components.list)
    component.isotopic = component.extremal = !component.cut;
  for (const Seam& seam : mesh.seams) {
    if (seam.count == 2) continue;
    for (u32 i = 0; i < mesh.corners; ++i) {
      const u32 of = components.of_vertex[mesh.vertex[mesh.corners * seam.sides[0].polygon + i]];
      if (of != kNothing) components.list[of].isotopic = false;
    }
  }
  for (size_t p = 0; p < c.fan_points.size(); ++p)
    if (c.fan_points[p] == 0)  // the node: fans of two edges might meet
      for (u32 i = 0; i < mesh.corners; ++i) {
        const u32 of = components.of_vertex[mesh.vertex[mesh.corners * p + i]];
        if (of != kNothing) components.list[of].isotopic = false;
      }
  Clusters clusters(grid, cells, edges, squares);
  for (u32 i = 0; i < mesh.vertex_cells.size(); ++i) {
    if (components.of_vertex[i] == kNothing) continue;
    ExtremalComponent& component = components.list[components.of_vertex[i]];
    if (!component.isotopic) continue;
    const Cluster cluster = clusters.of(mesh.vertex_cells[i]);
    component.isotopic = cluster.good;
    component.extremal &= cluster.extremal;
    for (unsigned k = 0; k < grid.dimension; ++k)
      component.isotopic &= c.vertices[i][k] >= 1024 && c.vertices[i][k] <= 64512;
  }
  for (ExtremalComponent& component : components.list) component.extremal &= component.isotopic;
}

}  // namespace crest::certify::extremal
