// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/reeb/slab_oracle.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "kernel/geometry/disjoint_sets.hpp"

namespace crest::reeb {
namespace {

class Slabs {
 public:
  explicit Slabs(const OrderedComplex& complex) : complex_(complex) {
    std::map<std::array<Index, 2>, Index> number;
    for (const auto& t : complex.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        std::array<Index, 2> e = {t[k], t[(k + 1) % 3]};
        if (complex.rank[e[0]] > complex.rank[e[1]]) std::swap(e[0], e[1]);
        const auto [it, fresh] = number.try_emplace(e, static_cast<Index>(edges_.size()));
        if (fresh) {
          edges_.push_back(e);
          faces_.push_back(0);
        }
        ++faces_[it->second];
        sides_.push_back(it->second);
      }
    }
    arc_at_edge_.assign(edges_.size(), kNone);
    around_.resize(complex.rank.size());
    for (Index t = 0; t < complex.triangles.size(); ++t)
      for (const Index v : complex.triangles[t]) around_[v].push_back(t);
    out_.arc_of_vertex.resize(complex.rank.size());
  }

  OracleGraph run() {
    for (const Index v : complex_.order) pass(v);
    std::vector<OracleArc> named;
    for (const Arc& a : arcs_) named.push_back({a.lower, a.upper, a.strand, a.open});
    for (std::size_t v = 0; v < arc_of_.size(); ++v)
      if (arc_of_[v] != kNone) out_.arc_of_vertex[v] = named[arc_of_[v]];
    for (const auto& t : triangle_arcs_)
      out_.arcs_of_triangle.push_back({named[t[0]], named[t[1]], named[t[2]]});
    std::sort(named.begin(), named.end());
    out_.arcs = named;
    kernel::DisjointSets sets(static_cast<Index>(complex_.rank.size()));
    for (const auto& e : edges_) sets.unite(e[0], e[1]);
    out_.components = sets.count();
    return out_;
  }

 private:
  struct Arc {
    Index lower, upper, strand;
    bool open;
  };

  /// Types from the link taken apart into its lower and its upper part.
  void note_triangles(Index v, bool below) {
    triangle_arcs_.resize(complex_.triangles.size());
    for (const Index t : around_[v]) {
      auto corners = complex_.triangles[t];
      std::sort(corners.begin(), corners.end(),
                [&](Index a, Index b) { return complex_.rank[a] < complex_.rank[b]; });
      for (std::size_t k = 0; k < 3; ++k) {
        if (corners[k] != v || below != (k == 2)) continue;
        // An edge of the triangle that the contour crosses.
        const std::array<Index, 2> ends = {corners[k == 2 ? 1 : k], corners[k == 0 ? 1 : 2]};
        for (std::size_t i = 0; i < 3; ++i) {
          const Index e = sides_[3 * t + i];
          if (edges_[e] == ends) triangle_arcs_[t][k] = arc_at_edge_[e];
        }
      }
    }
  }
  bool add_if_node(Index v) {
    std::map<Index, Index> place;
    std::vector<std::array<Index, 2>> sides;
    std::map<Index, int> uses;
    for (const Index number : around_[v]) {
      const auto& t = complex_.triangles[number];
      for (std::size_t k = 0; k < 3; ++k)
        if (t[k] == v) sides.push_back({t[(k + 1) % 3], t[(k + 2) % 3]});
    }
    for (const auto& s : sides) {
      for (const Index w : s) {
        place.try_emplace(w, static_cast<Index>(place.size()));
        ++uses[w];
      }
    }
    kernel::DisjointSets sets(static_cast<Index>(place.size()));
    const auto lower = [&](Index w) { return complex_.rank[w] < complex_.rank[v]; };
    int lower_sides = 0, lower_vertices = 0;
    for (const auto& s : sides) {
      if (lower(s[0]) != lower(s[1])) continue;
      sets.unite(place[s[0]], place[s[1]]);
      lower_sides += lower(s[0]);
    }
    std::set<Index> lower_runs, upper_runs;
    bool boundary = false;
    for (const auto& [w, i] : place) {
      (lower(w) ? lower_runs : upper_runs).insert(sets.find(i));
      lower_vertices += lower(w);
      boundary = boundary || uses[w] == 1;
    }
    const auto l = lower_runs.size(), u = upper_runs.size();
    if (l == 1 && u == 1) return false;
    const NodeKind kind = l == 0   ? NodeKind::minimum
                          : u == 0 ? NodeKind::maximum
                                   : NodeKind::saddle;
    const auto multiplicity =
        kind == NodeKind::saddle ? static_cast<std::uint32_t>(std::max(l, u) - 1) : 1u;
    out_.nodes.push_back({v, kind, boundary, multiplicity, 1 - (lower_vertices - lower_sides)});
    return true;
  }

  /// The contours just above v, each a set of crossed edges.
  std::vector<std::vector<Index>> contours_above(Index v) const {
    const Index level = complex_.rank[v];
    const auto crossed = [&](Index e) {
      return complex_.rank[edges_[e][0]] <= level && complex_.rank[edges_[e][1]] > level;
    };
    kernel::DisjointSets sets(static_cast<Index>(edges_.size()));
    std::vector<std::uint8_t> is_crossed(edges_.size());
    for (Index e = 0; e < edges_.size(); ++e) is_crossed[e] = crossed(e);
    for (std::size_t t = 0; t < complex_.triangles.size(); ++t) {
      Index last = kNone;
      for (std::size_t k = 0; k < 3; ++k) {
        const Index e = sides_[3 * t + k];
        if (!is_crossed[e]) continue;
        if (last != kNone) sets.unite(last, e);
        last = e;
      }
    }
    std::vector<Index> place(edges_.size(), kNone);
    std::vector<std::vector<Index>> out;
    for (Index e = 0; e < edges_.size(); ++e) {
      if (!is_crossed[e]) continue;
      Index& at = place[sets.find(e)];
      if (at == kNone) {
        at = static_cast<Index>(out.size());
        out.emplace_back();
      }
      out[at].push_back(e);
    }
    return out;
  }

  void pass(Index v) {
    note_triangles(v, true);
    const bool node = add_if_node(v);
    Index through = kNone;  // the arc below a regular vertex
    for (Index e = 0; e < edges_.size(); ++e) {
      if (edges_[e][1] != v) continue;
      through = arc_at_edge_[e];
      if (node) arcs_[through].upper = complex_.rank[v];
    }
    arc_of_.resize(complex_.rank.size(), kNone);
    if (!node) arc_of_[v] = through;
    for (const auto& contour : contours_above(v)) {
      Index strand = kNone;
      for (const Index e : contour)
        if (edges_[e][0] == v) strand = std::min(strand, edges_[e][1]);
      if (strand == kNone) continue;
      Index arc = through;
      if (node) {
        arc = static_cast<Index>(arcs_.size());
        const bool open =
            std::any_of(contour.begin(), contour.end(), [&](Index e) { return faces_[e] == 1; });
        arcs_.push_back({complex_.rank[v], kNone, complex_.rank[strand], open});
      }
      for (const Index e : contour) arc_at_edge_[e] = arc;
    }
    note_triangles(v, false);
  }

  const OrderedComplex& complex_;
  std::vector<std::array<Index, 2>> edges_;  ///< lower end first
  std::vector<int> faces_;                   ///< by edge: how many
  std::vector<std::vector<Index>> around_;   ///< triangles by vertex
  std::vector<Index> sides_, arc_at_edge_, arc_of_;
  std::vector<Arc> arcs_;
  std::vector<std::array<Index, 3>> triangle_arcs_;
  OracleGraph out_;
};

}  // namespace

OracleGraph slab_oracle(const OrderedComplex& complex) {
  return Slabs(complex).run();
}

OracleArc named(const OrderedComplex& complex, const ReebGraph& graph, Index arc) {
  const ReebArc& a = graph.arcs[arc];
  return {complex.rank[graph.nodes[a.lower].vertex], complex.rank[graph.nodes[a.upper].vertex],
          complex.rank[a.strand], a.open_below != 0};
}

OracleGraph named(const OrderedComplex& complex, const ReebGraph& graph,
                  const std::vector<Index>& arc_of_vertex) {
  OracleGraph out;
  for (const auto& n : graph.nodes)
    out.nodes.push_back({n.vertex, n.kind, n.on_boundary != 0, n.multiplicity, n.index});
  const auto name = [&](Index a) { return named(complex, graph, a); };
  for (Index a = 0; a < graph.arcs.size(); ++a) out.arcs.push_back(name(a));
  out.arc_of_vertex.resize(arc_of_vertex.size());
  for (std::size_t v = 0; v < arc_of_vertex.size(); ++v)
    if (arc_of_vertex[v] != kNone) out.arc_of_vertex[v] = name(arc_of_vertex[v]);
  out.components = graph.components;
  return out;
}

}  // namespace crest::reeb
