// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/extremal/sheet_mesh.hpp"

#include <algorithm>

#include "algorithms/extremal/dual.hpp"
#include "algorithms/extremal/placing.hpp"

namespace crest::extremal {
namespace {

/// A face's record and its edges.
struct CrossedFace {
  const FaceRecord& record;
  std::array<Index, 4> edges;
  std::size_t find(Index e) const {
    return static_cast<std::size_t>(std::find(edges.begin(), edges.end(), e) - edges.begin());
  }
};

/// Polygons of the edges, and which of them share a side.
class Polygons {
 public:
  Polygons(const Grid& grid, const Records& records, bool critical)
      : dual(grid), grid_(grid), records_(records), critical_(critical) {
    number_.assign(records.critical.size(), kernel::kNone);
    all.reserve(static_cast<std::size_t>(
        std::count_if(records.critical.begin(), records.critical.end(),
                      [&](const CriticalRecord& c) { return wanted(c) && c.whole; })));
    for (std::size_t i = 0; i < number_.size(); ++i) {
      const CriticalRecord& c = records.critical[i];
      if (!wanted(c) || !c.whole) continue;
      number_[i] = static_cast<Index>(all.size());
      all.push_back({c.edge,
                     c.place,
                     c.state == EdgeState::extremal,
                     zero_at(grid, c.edge, c.place),
                     {},
                     {},
                     static_cast<std::uint8_t>(dual.sides)});
    }
  }

  /// Should a critical edge have a polygon, its type says?
  bool wanted(const CriticalRecord& c) const { return critical_ || c.state == EdgeState::extremal; }
  const CriticalRecord& critical(Index e) const { return records_.critical[find(e)]; }
  /// kNone: the critical edge has none.
  Index of(Index e) const { return number_[find(e)]; }
  CrossedFace face(const Dual::Side& s) const {
    const auto id = static_cast<Index>(3 * grid_.index(s.face) + s.normal);
    const auto at = std::lower_bound(records_.faces.begin(), records_.faces.end(), id,
                                     [](const FaceRecord& f, Index x) { return f.face < x; });
    return {*at, dual.edges_of(s)};
  }

  /// Polygons of a face's group, ascending.
  struct Members {
    std::array<Index, 4> polygons{};
    std::size_t count = 0;
  };
  Members members(const CrossedFace& f, std::size_t group) const {
    Members m;
    for (std::size_t i = 0; i < 4; ++i) {
      if (f.record.group[i] != f.record.group[group]) continue;
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
  std::size_t find(Index e) const {
    const auto at = std::lower_bound(records_.critical.begin(), records_.critical.end(), e,
                                     [](const CriticalRecord& c, Index x) { return c.edge < x; });
    return static_cast<std::size_t>(at - records_.critical.begin());
  }

  const Grid& grid_;
  const Records& records_;
  bool critical_;
  std::vector<Index> number_;  ///< a critical edge's
};

/// Which vertex a polygon has in each of its cells.
void find_corners(const Grid& grid, const std::vector<SheetRecord>& sheets, Polygons& polygons) {
  for (SheetPolygon& p : polygons.all) {
    const auto cells = polygons.dual.cells_at(p.edge);
    for (std::size_t i = 0; i < polygons.dual.sides; ++i) {
      const auto edges = edges_of_cell(grid, cells[i]);
      const auto bit = std::find(edges.begin(), edges.end(), p.edge) - edges.begin();
      auto at = std::lower_bound(sheets.begin(), sheets.end(), grid.index(cells[i]),
                                 [](const SheetRecord& s, std::size_t x) { return s.cell < x; });
      while ((at->edges >> bit & 1) == 0) ++at;
      p.corners[i] = static_cast<Index>(at - sheets.begin());
    }
  }
}

void add_vertices(const Grid& grid, const std::vector<SheetRecord>& sheets, SheetMesh& mesh) {
  mesh.vertices.reserve(sheets.size());
  mesh.points.reserve(sheets.size());
  for (const SheetRecord& s : sheets) {
    mesh.vertices.push_back({s.cell, s.place});
    Vec3 at = as_vector(grid.node(s.cell));
    for (std::size_t k = 0; k < 3; ++k) at[k] += s.place[k] / kPlaces;
    mesh.points.push_back(at);
  }
}

/// Edges of the mesh, with why not two polygons are there (an image: ends).
class EdgeMaker {
 public:
  EdgeMaker(Polygons& polygons, std::vector<Vec3>& middles)
      : polygons_(polygons), middles_(middles) {}

  std::vector<SheetEdge> make() {
    made_.reserve(2 * polygons_.all.size());
    for (Index p = 0; p < polygons_.all.size(); ++p) {
      const Index e = polygons_.all[p].edge;
      for (std::size_t i = 0; i < 4; ++i) {
        const CrossedFace f = polygons_.face(polygons_.dual.side_at(e, i));
        const auto m = polygons_.members(f, f.find(e));
        if (m.polygons[0] == p) add(p, i, f, m);
      }
    }
    return std::move(made_);
  }

  std::vector<std::pair<std::uint8_t, std::uint8_t>> make_ends(std::size_t vertices) const {
    std::vector<std::pair<std::uint8_t, std::uint8_t>> r(vertices);
    for (const SheetPolygon& p : polygons_.all)
      for (std::size_t i = 0; i < 2; ++i) {
        const CrossedFace f = polygons_.face(polygons_.dual.side_at(p.edge, i));
        const std::size_t group = f.find(p.edge);
        const auto m = polygons_.members(f, group);
        r[p.corners[i]] = {static_cast<std::uint8_t>(m.count), reason(f, group, m.count)};
      }
    return r;
  }

 private:
  /// Why not two polygons of the group are kept; 0: two are.
  std::uint8_t reason(const CrossedFace& f, std::size_t group, std::size_t count) const {
    return static_cast<std::uint8_t>(count == 2 ? 0 : static_cast<int>(why(f, group)));
  }
  Reason why(const CrossedFace& f, std::size_t group) const {
    if (!f.record.tested) return f.record.listed ? Reason::undecided : Reason::border;
    if (f.record.odd()) return Reason::discontinuity;
    for (std::size_t i = 0; i < 4; ++i) {
      if (f.record.group[i] != f.record.group[group] || polygons_.of(f.edges[i]) != kernel::kNone)
        continue;
      const CriticalRecord& c = polygons_.critical(f.edges[i]);
      if (polygons_.wanted(c)) return Reason::border;
      return c.state == EdgeState::merely_critical ? Reason::inflection : Reason::undecided;
    }
    return kUnexplained;
  }

  void add(Index p, std::size_t i, const CrossedFace& f, const Polygons::Members& m) {
    SheetEdge edge;
    const auto& corners = polygons_.all[p].corners;
    edge.ends = {corners[i], corners[(i + 1) % 4]};
    edge.valence = static_cast<std::uint8_t>(m.count);
    const std::size_t group = f.find(polygons_.all[p].edge);
    edge.reason = reason(f, group, m.count);
    if (f.record.critical > 1) mark_twin(edge, f, group, m);
    for (std::size_t k = 0; k < m.count; ++k) {
      SheetPolygon& q = polygons_.all[m.polygons[k]];
      q.sides[side_in(q, f)] = static_cast<Index>(made_.size());
    }
    made_.push_back(edge);
  }
  /// Which side of the polygon crosses the face.
  std::size_t side_in(const SheetPolygon& q, const CrossedFace& f) const {
    std::size_t s = 0;
    while (polygons_.dual.edges_of(polygons_.dual.side_at(q.edge, s)) != f.edges) ++s;
    return s;
  }
  /// Does another group of the face join the same vertices? Of an ambiguous face its other arc; of
  /// one with an edge that is not tested each critical edge is a group.
  void mark_twin(SheetEdge& edge, const CrossedFace& f, std::size_t group,
                 const Polygons::Members& m) {
    bool twin = false;
    for (std::size_t other = 0; other < 4; ++other) {
      if (f.record.group[other] < 0 || f.record.group[other] == f.record.group[group]) continue;
      const auto o = polygons_.members(f, other);
      if (o.count == 0) continue;
      const SheetPolygon& q = polygons_.all[o.polygons[0]];
      const std::size_t s = side_in(q, f);
      const Index a = q.corners[s], b = q.corners[(s + 1) % 4];
      twin = twin || std::minmax(a, b) == std::minmax(edge.ends[0], edge.ends[1]);
    }
    if (!twin) return;
    Vec3 middle{};
    for (std::size_t k = 0; k < m.count; ++k)
      middle = middle + (1.0 / double(m.count)) * polygons_.all[m.polygons[k]].zero;
    edge.middle = static_cast<Index>(middles_.size());
    middles_.push_back(middle);
  }

  Polygons& polygons_;
  std::vector<Vec3>& middles_;
  std::vector<SheetEdge> made_;
};

}  // namespace

SheetMesh make_sheets(const Grid& grid, const Records& records, bool critical) {
  SheetMesh r;
  r.dimension = grid.dimension();
  const std::vector<SheetRecord>& sheets = records.sheets[critical ? 1 : 0];
  Polygons polygons(grid, records, critical);
  find_corners(grid, sheets, polygons);
  add_vertices(grid, sheets, r);
  EdgeMaker maker(polygons, r.middles);
  if (polygons.dual.plane())
    r.ends = maker.make_ends(r.vertices.size());
  else
    r.edges = maker.make();
  r.polygons = std::move(polygons.all);
  return r;
}

}  // namespace crest::extremal
