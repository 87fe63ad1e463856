// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/extremal/sheet_mesh.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>

#include "algorithms/extremal/dual.hpp"
#include "kernel/geometry/disjoint_sets.hpp"

namespace crest::extremal {
namespace {

constexpr double kUnits = 65536;

/// Inside the edge: at a node the fans of several edges would meet.
std::uint16_t snapped(double x) {
  return static_cast<std::uint16_t>(std::clamp(std::round(x * kUnits), 1.0, kUnits - 1));
}

Vec3 as_vector(const Node& v) {
  return {double(v[0]), double(v[1]), double(v[2])};
}
Vec3 zero(const Grid& grid, Index edge, std::uint16_t place) {
  Vec3 x = as_vector(grid.node(edge / 3));
  x[edge % 3] += place / kUnits;
  return x;
}

std::size_t local(const Face& f, Index e) {
  return static_cast<std::size_t>(std::find(f.edges.begin(), f.edges.end(), e) - f.edges.begin());
}

/// Polygons of the edges, and which of them share a side.
class Polygons {
 public:
  Polygons(const Fields& fields, const Edges& edges, const Faces& faces, bool critical)
      : dual(fields.grid()), edges_(edges), faces_(faces), critical_(critical) {
    const auto& list = edges.critical_edges();
    number_.assign(list.size(), kernel::kNone);
    for (std::size_t i = 0; i < list.size(); ++i) {
      const Index e = list[i].edge;
      if (!wanted(e)) continue;
      const auto cells = dual.cells_at(e);
      if (!std::all_of(cells.begin(), cells.begin() + dual.sides,
                       [&](const Node& c) { return dual.inside(c); }))
        continue;
      number_[i] = static_cast<Index>(all.size());
      const std::uint16_t place = snapped(list[i].place);
      all.push_back({e,
                     place,
                     edges.state(e) == EdgeState::extremal,
                     zero(fields.grid(), e, place),
                     {},
                     {},
                     static_cast<std::uint8_t>(dual.sides)});
    }
  }

  /// Should a critical edge have a polygon, its type says?
  bool wanted(Index e) const { return critical_ || edges_.state(e) == EdgeState::extremal; }
  /// kNone: the critical edge has none.
  Index of(Index e) const { return number_[edges_.find(e)]; }
  Face face(const Dual::Side& s) const { return faces_.face(s.face, s.normal); }

  /// Polygons of a face's group, ascending.
  struct Members {
    std::array<Index, 4> polygons{};
    std::size_t count = 0;
  };
  Members members(const Face& f, std::size_t group) const {
    Members m;
    for (std::size_t i = 0; i < 4; ++i) {
      if (f.group[i] != f.group[group]) continue;
      const Index p = of(f.edges[i]);
      if (p == kernel::kNone) continue;
      std::size_t at = m.count++;
      for (; at > 0 && m.polygons[at - 1] > p; --at) m.polygons[at] = m.polygons[at - 1];
      m.polygons[at] = p;
    }
    return m;
  }

  const Dual dual;
  std::vector<SheetPolygon> all;

 private:
  const Edges& edges_;
  const Faces& faces_;
  bool critical_;
  std::vector<Index> number_;  ///< a critical edge's
};

/// Vertices: corners of polygons, joined in a cell where they share a side.
class VertexMaker {
 public:
  VertexMaker(const Fields& fields, Polygons& polygons)
      : fields_(fields),
        grid_(fields.grid()),
        polygons_(polygons),
        sides_(static_cast<Index>(polygons.dual.sides)) {}

  std::vector<SheetVertex> make() {
    const auto count = static_cast<Index>(polygons_.all.size());
    kernel::DisjointSets sets(sides_ * count);
    const Dual& dual = polygons_.dual;
    for (Index p = 0; p < count; ++p) {
      const Index e = polygons_.all[p].edge;
      const auto cells = dual.cells_at(e);
      for (Index i = 0; i < sides_; ++i) {
        const Face f = polygons_.face(dual.side_at(e, i));
        const auto m = polygons_.members(f, local(f, e));
        for (std::size_t k = 0; k < m.count; ++k) {
          if (m.polygons[k] <= p) continue;
          join(sets, p, i, cells[i], m.polygons[k]);
          if (!dual.plane()) join(sets, p, (i + 1) % 4, cells[(i + 1) % 4], m.polygons[k]);
        }
      }
    }
    number(sets);
    place();
    return std::move(vertices_);
  }

 private:
  void join(kernel::DisjointSets& sets, Index p, Index i, const Node& cell, Index q) const {
    const auto cells = polygons_.dual.cells_at(polygons_.all[q].edge);
    const auto k = std::find(cells.begin(), cells.begin() + sides_, cell) - cells.begin();
    sets.unite(sides_ * p + i, sides_ * q + static_cast<Index>(k));
  }

  void number(kernel::DisjointSets& sets) {
    std::vector<std::pair<std::size_t, Index>> roots;
    roots.reserve(sets.count());
    for (Index c = 0; c < sets.size(); ++c)
      if (sets.find(c) == c)
        roots.emplace_back(
            grid_.index(polygons_.dual.cells_at(polygons_.all[c / sides_].edge)[c % sides_]), c);
    tbb::parallel_sort(roots.begin(), roots.end());
    std::vector<Index> number(sets.size());
    for (const auto& [cell, root] : roots) {
      number[root] = static_cast<Index>(vertices_.size());
      vertices_.push_back({cell, {}, {}});
    }
    for (Index c = 0; c < sets.size(); ++c)
      polygons_.all[c / sides_].corners[c % sides_] = number[sets.find(c)];
  }

  /// From the centroid of the zeros along n to g = 0, inside the cell by 1/64 at least.
  Vec3 projected(const Node& cell, Vec3 t) const {
    const Vec3& d = grid_.spacing;
    const auto clamp = [&] {
      for (double& x : t) x = std::clamp(x, 1.0 / 64, 63.0 / 64);
      if (polygons_.dual.plane()) t[2] = 0;
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
      if (kernel::norm(t - before) < 1e-5) break;
    }
    return t;
  }

  void place() {
    std::vector<Vec3> sum(vertices_.size(), Vec3{});
    std::vector<int> count(vertices_.size(), 0);
    for (const SheetPolygon& p : polygons_.all)
      for (std::size_t i = 0; i < sides_; ++i) {
        sum[p.corners[i]] = sum[p.corners[i]] + p.zero;
        ++count[p.corners[i]];
      }
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, sum.size(), 256), [&](const auto& range) {
      for (std::size_t i = range.begin(); i < range.end(); ++i) {
        const Node cell = grid_.node(vertices_[i].cell);
        const Vec3 t = projected(cell, (1.0 / count[i]) * sum[i] - as_vector(cell));
        for (std::size_t k = 0; k < 3; ++k) {
          vertices_[i].place[k] = snapped(t[k]);
          vertices_[i].at[k] = cell[k] + vertices_[i].place[k] / kUnits;
        }
      }
    });
  }

  const Fields& fields_;
  const Grid& grid_;
  Polygons& polygons_;
  Index sides_;
  std::vector<SheetVertex> vertices_;
};

/// Edges of the mesh, with why not two polygons are there (an image: ends).
class EdgeMaker {
 public:
  EdgeMaker(const Fields& fields, const Cells& cells, const Edges& edges, Polygons& polygons)
      : grid_(fields.grid()), cells_(cells), edges_(edges), polygons_(polygons) {}

  std::vector<SheetEdge> make() {
    made_.reserve(2 * polygons_.all.size());
    for (Index p = 0; p < polygons_.all.size(); ++p) {
      const Index e = polygons_.all[p].edge;
      for (std::size_t i = 0; i < 4; ++i) {
        const Face f = polygons_.face(polygons_.dual.side_at(e, i));
        const auto m = polygons_.members(f, local(f, e));
        if (m.polygons[0] == p) add(p, i, f, m);
      }
    }
    return std::move(made_);
  }

  std::vector<std::pair<std::uint8_t, std::uint8_t>> make_ends(std::size_t vertices) const {
    std::vector<std::pair<std::uint8_t, std::uint8_t>> r(vertices);
    for (const SheetPolygon& p : polygons_.all)
      for (std::size_t i = 0; i < 2; ++i) {
        const Face f = polygons_.face(polygons_.dual.side_at(p.edge, i));
        const std::size_t group = local(f, p.edge);
        const auto m = polygons_.members(f, group);
        r[p.corners[i]] = {static_cast<std::uint8_t>(m.count), reason(f, group, m.count)};
      }
    return r;
  }

 private:
  bool at_listed_cell(Index e) const {
    for (const Node& c : polygons_.dual.cells_at(e))
      if (polygons_.dual.inside(c) && cells_.state(grid_.index(c)) != CellState::unlisted)
        return true;
    return false;
  }
  /// Why not two polygons of the group are kept; 0: two are.
  std::uint8_t reason(const Face& f, std::size_t group, std::size_t count) const {
    return static_cast<std::uint8_t>(count == 2 ? 0 : static_cast<int>(why(f, group)));
  }
  Reason why(const Face& f, std::size_t group) const {
    if (!f.tested) {
      for (const Index e : f.edges)
        if (!edges_.tested(e) && at_listed_cell(e)) return Reason::undecided;
      return Reason::border;
    }
    if (f.odd()) return Reason::discontinuity;
    for (std::size_t i = 0; i < 4; ++i) {
      if (f.group[i] != f.group[group] || polygons_.of(f.edges[i]) != kernel::kNone) continue;
      if (polygons_.wanted(f.edges[i])) return Reason::border;
      return edges_.state(f.edges[i]) == EdgeState::merely_critical ? Reason::inflection
                                                                    : Reason::undecided;
    }
    return kUnexplained;
  }

  void add(Index p, std::size_t i, const Face& f, const Polygons::Members& m) {
    SheetEdge edge;
    const auto& corners = polygons_.all[p].corners;
    edge.ends = {corners[i], corners[(i + 1) % 4]};
    edge.valence = static_cast<std::uint8_t>(m.count);
    const std::size_t group = local(f, polygons_.all[p].edge);
    edge.reason = reason(f, group, m.count);
    if (f.critical > 1) mark_twin(edge, f, group, m);
    for (std::size_t k = 0; k < m.count; ++k) {
      SheetPolygon& q = polygons_.all[m.polygons[k]];
      q.sides[side_in(q, f)] = static_cast<Index>(made_.size());
    }
    made_.push_back(edge);
  }
  /// Which side of the polygon crosses the face.
  std::size_t side_in(const SheetPolygon& q, const Face& f) const {
    std::size_t s = 0;
    while (polygons_.dual.edges_of(polygons_.dual.side_at(q.edge, s)) != f.edges) ++s;
    return s;
  }
  /// Does another group of the face join the same vertices? Of an ambiguous face its other arc; of
  /// one with an edge that is not tested each critical edge is a group.
  void mark_twin(SheetEdge& edge, const Face& f, std::size_t group,
                 const Polygons::Members& m) const {
    for (std::size_t other = 0; other < 4; ++other) {
      if (f.group[other] < 0 || f.group[other] == f.group[group]) continue;
      const auto o = polygons_.members(f, other);
      if (o.count == 0) continue;
      const SheetPolygon& q = polygons_.all[o.polygons[0]];
      const std::size_t s = side_in(q, f);
      const Index a = q.corners[s], b = q.corners[(s + 1) % 4];
      edge.twin = edge.twin || std::minmax(a, b) == std::minmax(edge.ends[0], edge.ends[1]);
    }
    if (!edge.twin) return;
    for (std::size_t k = 0; k < m.count; ++k)
      edge.middle = edge.middle + (1.0 / double(m.count)) * polygons_.all[m.polygons[k]].zero;
  }

  const Grid& grid_;
  const Cells& cells_;
  const Edges& edges_;
  Polygons& polygons_;
  std::vector<SheetEdge> made_;
};

}  // namespace

SheetMesh make_sheets(const Fields& fields, const Cells& cells, const Edges& edges,
                      const Faces& faces, bool critical) {
  SheetMesh r;
  r.dimension = fields.grid().dimension();
  Polygons polygons(fields, edges, faces, critical);
  r.vertices = VertexMaker(fields, polygons).make();
  EdgeMaker maker(fields, cells, edges, polygons);
  if (polygons.dual.plane())
    r.ends = maker.make_ends(r.vertices.size());
  else
    r.edges = maker.make();
  r.polygons = std::move(polygons.all);
  return r;
}

}  // namespace crest::extremal
