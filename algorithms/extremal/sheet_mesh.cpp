// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/extremal/sheet_mesh.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>

#include "kernel/geometry/disjoint_sets.hpp"

namespace crest::extremal {
namespace {

constexpr double kUnits = 65536;

std::uint16_t snapped(double x, double low, double high) {
  return static_cast<std::uint16_t>(std::clamp(std::round(x * kUnits), low, high));
}

class SheetMaker {
 public:
  SheetMaker(const Fields& fields, const Cells& cells, const Edges& edges, const Faces& faces,
             bool critical)
      : fields_(fields),
        cells_(cells),
        edges_(edges),
        faces_(faces),
        grid_(fields.grid()),
        plane_(grid_.dimension() == 2),
        sides_(plane_ ? 2 : 4),
        critical_(critical) {}

  SheetMesh make() {
    make_polygons();
    make_vertices();
    place_vertices();
    plane_ ? make_ends() : make_edges();
    return std::move(mesh_);
  }

 private:
  struct Side {
    Node face;
    std::size_t normal;
  };
  static Node minus(Node v, std::size_t axis) {
    --v[axis];
    return v;
  }
  /// Cells round an edge, cyclic; an image: the squares at it.
  std::array<Node, 4> cells_at(Index e) const {
    const Node v = grid_.node(e / 3);
    const std::size_t a = e % 3, b = next(a), c = after_next(a);
    if (plane_) return {minus(v, 1 - a), v, v, v};
    return {minus(minus(v, b), c), minus(v, c), v, minus(v, b)};
  }
  /// From a cell of cells_at to the next; an image: the square itself.
  Side side_at(Index e, std::size_t i) const {
    const Node v = grid_.node(e / 3);
    const std::size_t a = e % 3, b = next(a), c = after_next(a);
    if (plane_) return {i == 0 ? minus(v, 1 - a) : v, 2};
    return i == 0   ? Side{minus(v, c), b}
           : i == 1 ? Side{v, c}
           : i == 2 ? Side{v, b}
                    : Side{minus(v, b), c};
  }
  bool inside(const Node& cell) const {
    return plane_ ? grid_.is_square(cell) : grid_.is_cell(cell);
  }
  Index polygon_of(Index e) const { return polygon_of_[edges_.find(e)]; }

  void make_polygons() {
    const auto& critical = edges_.critical_edges();
    polygon_of_.assign(critical.size(), kernel::kNone);
    for (std::size_t i = 0; i < critical.size(); ++i) {
      const Index e = critical[i].edge;
      const bool extremal = edges_.state(e) == EdgeState::extremal;
      if (!extremal && !critical_) continue;
      const auto cells = cells_at(e);
      if (!std::all_of(cells.begin(), cells.begin() + sides_,
                       [&](const Node& c) { return inside(c); }))
        continue;
      polygon_of_[i] = static_cast<Index>(mesh_.polygons.size());
      mesh_.polygons.push_back({e, snapped(critical[i].place, 0, kUnits - 1), extremal, {}, {}});
    }
  }

  /// Polygons of a face's group, ascending.
  struct Members {
    std::array<Index, 4> polygons{};
    std::size_t count = 0;
  };
  Members members(const Face& f, std::size_t local) const {
    Members m;
    for (std::size_t i = 0; i < 4; ++i) {
      if (f.group[i] != f.group[local]) continue;
      const Index p = polygon_of(f.edges[i]);
      if (p == kernel::kNone) continue;
      std::size_t at = m.count++;
      for (; at > 0 && m.polygons[at - 1] > p; --at) m.polygons[at] = m.polygons[at - 1];
      m.polygons[at] = p;
    }
    return m;
  }
  static std::size_t local(const Face& f, Index e) {
    return static_cast<std::size_t>(std::find(f.edges.begin(), f.edges.end(), e) - f.edges.begin());
  }

  /// A polygon's corners, joined in a cell where a side is shared.
  void make_vertices() {
    const auto count = static_cast<Index>(mesh_.polygons.size());
    kernel::DisjointSets sets(static_cast<Index>(sides_) * count);
    for (Index p = 0; p < count; ++p) {
      const Index e = mesh_.polygons[p].edge;
      const auto cells = cells_at(e);
      for (std::size_t i = 0; i < sides_; ++i) {
        const Side side = side_at(e, i);
        const Face f = faces_.face(side.face, side.normal);
        const Members m = members(f, local(f, e));
        for (std::size_t k = 0; k < m.count; ++k) {
          if (m.polygons[k] <= p) continue;
          join(sets, p, i, cells[i], m.polygons[k]);
          if (!plane_) join(sets, p, (i + 1) % 4, cells[(i + 1) % 4], m.polygons[k]);
        }
      }
    }
    number_vertices(sets);
  }
  void join(kernel::DisjointSets& sets, Index p, std::size_t i, const Node& cell, Index q) {
    const auto cells = cells_at(mesh_.polygons[q].edge);
    const auto k = static_cast<std::size_t>(
        std::find(cells.begin(), cells.begin() + sides_, cell) - cells.begin());
    const auto n = static_cast<Index>(sides_);
    sets.unite(n * p + static_cast<Index>(i), n * q + static_cast<Index>(k));
  }
  void number_vertices(kernel::DisjointSets& sets) {
    const auto n = static_cast<Index>(sides_);
    std::vector<std::pair<std::size_t, Index>> roots;
    roots.reserve(sets.count());
    for (Index c = 0; c < sets.size(); ++c)
      if (sets.find(c) == c)
        roots.emplace_back(grid_.index(cells_at(mesh_.polygons[c / n].edge)[c % n]), c);
    tbb::parallel_sort(roots.begin(), roots.end());
    std::vector<Index> number(sets.size());
    for (std::size_t i = 0; i < roots.size(); ++i) {
      number[roots[i].second] = static_cast<Index>(i);
      mesh_.vertices.push_back({roots[i].first, {}});
    }
    for (Index c = 0; c < sets.size(); ++c)
      mesh_.polygons[c / n].corners[c % n] = number[sets.find(c)];
  }

  Vec3 zero(const SheetPolygon& p) const {
    const Node v = grid_.node(p.edge / 3);
    Vec3 x = {double(v[0]), double(v[1]), double(v[2])};
    x[p.edge % 3] += p.place / kUnits;
    return x;
  }

  /// From the centroid of the zeros along n to g = 0, inside the cell.
  Vec3 projected(const Node& cell, Vec3 t) const {
    const Vec3& d = grid_.spacing;
    const auto clamp = [&] {
      for (std::size_t k = 0; k < 3; ++k) t[k] = std::clamp(t[k], 1.0 / 64, 63.0 / 64);
      if (plane_) t[2] = 0;
    };
    clamp();
    for (int step = 0; step < 4; ++step) {
      const Local l = fields_.at(cell, t);
      const Vec3 n = dominant_direction(l.tensor);
      const double g = kernel::dot(n, l.gradient), bend = kernel::dot(n, product(l.hessian, n));
      if (bend == 0) break;
      const Vec3 before = t;
      for (std::size_t k = 0; k < 3; ++k) t[k] -= std::clamp(g / bend * n[k] / d[k], -1.0, 1.0);
      clamp();
      double moved = 0;
      for (std::size_t k = 0; k < 3; ++k) moved = std::max(moved, std::fabs(t[k] - before[k]));
      if (moved < 1e-5) break;
    }
    return t;
  }

  void place_vertices() {
    std::vector<Vec3> sum(mesh_.vertices.size(), Vec3{});
    std::vector<int> count(mesh_.vertices.size(), 0);
    for (const SheetPolygon& p : mesh_.polygons)
      for (std::size_t i = 0; i < sides_; ++i) {
        sum[p.corners[i]] = sum[p.corners[i]] + zero(p);
        ++count[p.corners[i]];
      }
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, sum.size(), 256), [&](const auto& range) {
          for (std::size_t i = range.begin(); i < range.end(); ++i) {
            const Node cell = grid_.node(mesh_.vertices[i].cell);
            const Vec3 low = {double(cell[0]), double(cell[1]), double(cell[2])};
            const Vec3 t = projected(cell, (1.0 / count[i]) * sum[i] - low);
            for (std::size_t k = 0; k < 3; ++k)
              mesh_.vertices[i].place[k] = snapped(t[k], 0, kUnits - 1);
          }
        });
  }

  bool at_listed_cell(Index e) const {
    for (const Node& c : cells_at(e))
      if (inside(c) && cells_.state(grid_.index(c)) != CellState::unlisted) return true;
    return false;
  }
  /// Why not two polygons of the group are kept.
  Reason reason(const Face& f, std::size_t group) const {
    if (!f.tested) {
      for (const Index e : f.edges)
        if (!edges_.tested(e) && at_listed_cell(e)) return Reason::undecided;
      return Reason::border;
    }
    if (f.odd()) return Reason::discontinuity;
    for (std::size_t i = 0; i < 4; ++i) {
      if (f.group[i] != f.group[group] || polygon_of(f.edges[i]) != kernel::kNone) continue;
      const EdgeState s = edges_.state(f.edges[i]);
      return s == EdgeState::merely_critical  ? Reason::inflection
             : s == EdgeState::type_undecided ? Reason::undecided
                                              : Reason::border;
    }
    return Reason::border;
  }

  void make_edges() {
    mesh_.edges.reserve(2 * mesh_.polygons.size());
    for (Index p = 0; p < mesh_.polygons.size(); ++p) {
      const Index e = mesh_.polygons[p].edge;
      for (std::size_t i = 0; i < 4; ++i) {
        const Side side = side_at(e, i);
        const Face f = faces_.face(side.face, side.normal);
        const Members m = members(f, local(f, e));
        if (m.polygons[0] != p) continue;
        add_edge(p, i, f, m);
      }
    }
  }
  void add_edge(Index p, std::size_t i, const Face& f, const Members& m) {
    SheetEdge edge;
    const auto& corners = mesh_.polygons[p].corners;
    edge.ends = {corners[i], corners[(i + 1) % 4]};
    edge.valence = static_cast<std::uint8_t>(m.count);
    const std::size_t group = local(f, mesh_.polygons[p].edge);
    edge.reason = static_cast<std::uint8_t>(m.count == 2 ? 0 : static_cast<int>(reason(f, group)));
    if (f.ambiguous()) mark_twin(edge, f, group, m);
    const auto number = static_cast<Index>(mesh_.edges.size());
    for (std::size_t k = 0; k < m.count; ++k) {
      SheetPolygon& q = mesh_.polygons[m.polygons[k]];
      for (std::size_t s = 0; s < 4; ++s) {
        const Side side = side_at(q.edge, s);
        if (faces_edges(side) == f.edges) q.sides[s] = number;
      }
    }
    mesh_.edges.push_back(edge);
  }
  std::array<Index, 4> faces_edges(const Side& s) const {
    const std::size_t a = next(s.normal), b = after_next(s.normal), at = grid_.index(s.face);
    return {static_cast<Index>(3 * at + a), static_cast<Index>(3 * (at + grid_.stride[a]) + b),
            static_cast<Index>(3 * (at + grid_.stride[b]) + a), static_cast<Index>(3 * at + b)};
  }
  /// Does the face's other arc join the same vertices?
  void mark_twin(SheetEdge& edge, const Face& f, std::size_t group, const Members& m) {
    std::size_t other = 0;
    while (f.group[other] == f.group[group]) ++other;
    const Members o = members(f, other);
    if (o.count == 0) return;
    const SheetPolygon& q = mesh_.polygons[o.polygons[0]];
    for (std::size_t s = 0; s < 4; ++s) {
      if (faces_edges(side_at(q.edge, s)) != f.edges) continue;
      const Index a = q.corners[s], b = q.corners[(s + 1) % 4];
      edge.twin = (a == edge.ends[0] && b == edge.ends[1]) || (a == edge.ends[1] && b == edge.ends[0]);
    }
    if (!edge.twin) return;
    for (std::size_t k = 0; k < m.count; ++k)
      edge.middle = edge.middle + (1.0 / double(m.count)) * zero(mesh_.polygons[m.polygons[k]]);
  }

  void make_ends() {
    mesh_.ends.assign(mesh_.vertices.size(), {0, 0});
    for (const SheetPolygon& p : mesh_.polygons)
      for (std::size_t i = 0; i < 2; ++i) {
        const Side side = side_at(p.edge, i);
        const Face f = faces_.face(side.face, side.normal);
        const Members m = members(f, local(f, p.edge));
        const auto why = m.count == 2 ? 0 : static_cast<int>(reason(f, local(f, p.edge)));
        mesh_.ends[p.corners[i]] = {static_cast<std::uint8_t>(m.count),
                                    static_cast<std::uint8_t>(why)};
      }
  }

  const Fields& fields_;
  const Cells& cells_;
  const Edges& edges_;
  const Faces& faces_;
  const Grid& grid_;
  bool plane_;
  std::size_t sides_;
  bool critical_;
  SheetMesh mesh_;
  std::vector<Index> polygon_of_;  ///< a critical edge's
};

}  // namespace

SheetMesh make_sheets(const Fields& fields, const Cells& cells, const Edges& edges,
                      const Faces& faces, bool critical) {
  return SheetMaker(fields, cells, edges, faces, critical).make();
}

}  // namespace crest::extremal
