// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/extremal/octree_mesh.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_sort.h>

#include <algorithm>

#include "kernel/geometry/disjoint_sets.hpp"
#include "kernel/geometry/parallel.hpp"

namespace crest::extremal {
namespace {

/// A minimal face: its lowest node and the axis across.
struct FaceName {
  Place low;
  int normal, size;
  friend auto operator<=>(const FaceName&, const FaceName&) = default;
};

/// The edges of a minimal face's border in cyclic order, with groups as Face has them.
class BorderedFace {
 public:
  struct Side {
    Index edge;  ///< kNone: nothing is known of it
    Node from;   ///< the node before it
    int group;   ///< its lowest member; -1: not critical
  };
  std::vector<Side> sides;
  int critical = 0;
  bool tested = true, undecided = false;

  BorderedFace(const PointTree& tree, const FaceName& name) {
    const auto k = static_cast<std::size_t>(name.normal);
    const std::size_t a = next(k), b = after_next(k);
    const Node p = unpacked(name.low);
    add(tree, p, a, name.size, false);
    add(tree, moved(p, a, name.size), b, name.size, false);
    add(tree, moved(p, b, name.size), a, name.size, true);
    add(tree, p, b, name.size, true);
    for (int i = 0; i < static_cast<int>(sides.size()); ++i) decide(tree, i);
    if (tested && critical > 1) join(tree, name);
  }
  bool odd() const { return tested && critical % 2 == 1; }
  bool ambiguous() const { return tested && critical > 3 && critical % 2 == 0; }
  int group_of(Index edge) const {
    for (const Side& s : sides)
      if (s.edge == edge) return s.group;
    return -1;
  }

 private:
  void add(const PointTree& tree, const Node& low, std::size_t axis, int size, bool backward) {
    const auto put = [&](const Node& v, int length) {
      sides.push_back({tree.find_edge(packed(v), axis), backward ? moved(v, axis, length) : v, -1});
    };
    const Node middle = moved(low, axis, size / 2);
    if (size == 1 || !tree.is_node(middle)) {
      put(low, size);
    } else if (backward) {
      put(middle, size / 2);
      put(low, size / 2);
    } else {
      put(low, size / 2);
      put(middle, size / 2);
    }
  }
  void decide(const PointTree& tree, int i) {
    Side& s = sides[static_cast<std::size_t>(i)];
    const EdgeState state =
        s.edge == kernel::kNone ? EdgeState::untested : tree.edges()[s.edge].state;
    tested = tested && state != EdgeState::untested && state != EdgeState::undecided;
    undecided = undecided || state == EdgeState::undecided;
    if (state < EdgeState::merely_critical || state > EdgeState::type_undecided) return;
    s.group = i;
    ++critical;
  }
  /// 2, 3 or an odd number: all; else consecutive pairs that cut off what has not the sign of g at
  /// the face's centre.
  void join(const PointTree& tree, const FaceName& name) {
    std::vector<std::size_t> at;
    for (std::size_t i = 0; i < sides.size(); ++i)
      if (sides[i].group >= 0) at.push_back(i);
    if (critical == 2 || critical % 2 == 1) {
      for (const std::size_t i : at) sides[i].group = static_cast<int>(at[0]);
      return;
    }
    const std::size_t shift = starts_second(tree, name, at[0]) ? 1 : 0;
    for (std::size_t i = 0; i < at.size(); i += 2) {
      const std::size_t a = at[(i + shift) % at.size()], b = at[(i + shift + 1) % at.size()];
      sides[a].group = sides[b].group = static_cast<int>(std::min(a, b));
    }
  }
  bool starts_second(const PointTree& tree, const FaceName& name, std::size_t first) const {
    const auto k = static_cast<std::size_t>(name.normal);
    const Node p = unpacked(name.low);
    Vec3 centre = as_vector(p);
    Node inside;
    for (std::size_t i = 0; i < 3; ++i) {
      inside[i] = i == k ? 2 * p[i] : 2 * p[i] + name.size;
      if (i != k) centre[i] += 0.5 * name.size;
    }
    for (const int by : {0, -1}) {
      const Index leaf = tree.tree().leaf_at(moved(inside, k, by));
      if (leaf == kernel::kNone || !tree.box(leaf).passed) continue;
      const Vec3& w = tree.box(leaf).w;
      // The border between the first critical edge and the second.
      const OctreeNode& v = tree.node(sides[(first + 1) % sides.size()].from);
      const int sign = v.sign * side(v.direction, w);
      return (tree.oriented(centre, w) > 0) == (sign > 0);
    }
    return false;
  }
};

/// A polygon's side: it crosses a face, from one leaf to another.
struct Use {
  FaceName face;
  int group;
  Index polygon, side;
  std::array<Index, 2> leaves;
  std::uint8_t reason;  ///< unless two polygons are there
  friend bool same_edge(const Use& a, const Use& b) {
    return a.face == b.face && a.group == b.group;
  }
};

class OctreePolygons {
 public:
  std::vector<SheetPolygon> polygons;
  std::vector<Use> uses;
  std::vector<Index> leaf_of;  ///< a corner's, four a polygon; kNone: it has three

  OctreePolygons(const PointTree& tree, bool critical) : tree_(tree), critical_(critical) {
    for (Index e = 0; e < tree.edges().size(); ++e)
      if (wanted(e)) add(e);
    tbb::parallel_sort(uses.begin(), uses.end(), [](const Use& a, const Use& b) {
      return std::tuple(a.face, a.polygon, a.side) < std::tuple(b.face, b.polygon, b.side);
    });
  }

  /// Should the edge have a polygon, its type says?
  bool wanted(Index e) const {
    const EdgeState s = tree_.edges()[e].state;
    return s == EdgeState::extremal || (critical_ && s == EdgeState::merely_critical);
  }
  /// kNone: the edge has none.
  Index of(Index e) const {
    const auto at =
        std::lower_bound(polygon_of_.begin(), polygon_of_.end(), std::pair(e, Index{0}));
    return at != polygon_of_.end() && at->first == e ? at->second : kernel::kNone;
  }

 private:
  void add(Index e) {
    const OctreeEdge& edge = tree_.edges()[e];
    const std::size_t a = edge.axis, b = next(a), c = after_next(a);
    const Node low = unpacked(edge.low);
    Node middle = {2 * low[0], 2 * low[1], 2 * low[2]};
    middle[a] += edge.size > 1 ? edge.size : 0;
    static constexpr std::array<std::array<int, 2>, 4> kRound = {
        {{-1, -1}, {0, -1}, {0, 0}, {-1, 0}}};
    std::array<Index, 4> round;
    for (std::size_t i = 0; i < 4; ++i)
      round[i] = tree_.tree().leaf_at(moved(moved(middle, b, kRound[i][0]), c, kRound[i][1]));
    if (std::find(round.begin(), round.end(), kernel::kNone) != round.end()) return;
    SheetPolygon p{};
    p.edge = e;
    p.extremal = edge.state == EdgeState::extremal;
    p.zero = edge.zero;
    p.count = 0;
    const auto number = static_cast<Index>(polygons.size());
    for (std::size_t i = 0; i < 4; ++i) {
      const Index from = round[i], to = round[(i + 1) % 4];
      if (from == to) continue;
      const std::size_t normal = i % 2 == 0 ? b : c;
      const auto& leaves = tree_.tree().leaves();
      const OctreeLeaf& smaller = leaves[from].size < leaves[to].size ? leaves[from] : leaves[to];
      Node face = smaller.low;
      face[normal] = low[normal];
      uses.push_back({{packed(face), static_cast<int>(normal), smaller.size},
                      -1,
                      number,
                      p.count,
                      {from, to},
                      0});
      leaf_of.resize(4 * std::size_t{number} + 4, kernel::kNone);
      leaf_of[4 * std::size_t{number} + p.count++] = from;
    }
    polygons.push_back(p);
    polygon_of_.emplace_back(e, number);
  }

  const PointTree& tree_;
  bool critical_;
  std::vector<std::pair<Index, Index>> polygon_of_;  ///< edge, polygon; ascending
};

/// As on the uniform grid: the zeros' centroid, then along n, inside the leaf.
void place_vertices(const PointTree& tree, SheetMesh& mesh) {
  std::vector<int> count(mesh.vertices.size(), 0);
  mesh.points.assign(mesh.vertices.size(), Vec3{});
  for (const SheetPolygon& p : mesh.polygons)
    for (std::size_t i = 0; i < p.count; ++i) {
      Vec3& at = mesh.points[p.corners[i]];
      at = at + p.zero;
      ++count[p.corners[i]];
    }
  const double unit = tree.grid().spacing[0];
  kernel::parallel_for(tbb::blocked_range<std::size_t>(0, count.size(), 64), [&](const auto& r) {
    for (std::size_t i = r.begin(); i < r.end(); ++i) {
      Vec3& at = mesh.points[i];
      const OctreeLeaf& leaf = tree.tree().leaves()[mesh.vertices[i].cell];
      at = (1.0 / count[i]) * at;
      for (int step = 0; step < 3; ++step) {
        for (std::size_t k = 0; k < 3; ++k)
          at[k] = std::clamp(at[k], leaf.low[k] + leaf.size / 64.0,
                             leaf.low[k] + leaf.size * 63 / 64.0);
        if (step == 2) break;
        const Local l = tree.sums(at).local;
        const Vec3 n = dominant_direction(l.tensor);
        const double bend = kernel::dot(n, product(l.hessian, n));
        if (bend == 0) break;
        const double move = kernel::dot(n, l.gradient) / bend / unit;
        at = at - std::clamp(move, -double(leaf.size), double(leaf.size)) * n;
      }
    }
  });
}

class OctreeMesher {
 public:
  OctreeMesher(const PointTree& tree, bool critical, Counts& counts)
      : tree_(tree), counts_(counts), polygons_(tree, critical), uses_(polygons_.uses) {
    mesh_.polygons = std::move(polygons_.polygons);
  }

  SheetMesh make() {
    make_groups();
    make_vertices();
    make_edges();
    return std::move(mesh_);
  }

 private:
  /// Each face once; its uses in order of groups, then.
  void make_groups() {
    for (std::size_t i = 0, end; i < uses_.size(); i = end) {
      for (end = i; end < uses_.size() && uses_[end].face == uses_[i].face;) ++end;
      const BorderedFace face(tree_, uses_[i].face);
      counts_.odd_faces += face.odd() ? 1 : 0;
      counts_.junction_edges += face.odd() && face.critical > 1 ? 1 : 0;
      counts_.ambiguous_faces += face.ambiguous() ? 1 : 0;
      for (std::size_t k = i; k < end; ++k) {
        uses_[k].group = face.group_of(mesh_.polygons[uses_[k].polygon].edge);
        uses_[k].reason = static_cast<std::uint8_t>(why(face, uses_[k].group));
      }
      std::stable_sort(uses_.begin() + static_cast<std::ptrdiff_t>(i),
                       uses_.begin() + static_cast<std::ptrdiff_t>(end),
                       [](const Use& a, const Use& b) { return a.group < b.group; });
    }
  }
  Reason why(const BorderedFace& face, int group) const {
    if (!face.tested) return face.undecided ? Reason::undecided : Reason::border;
    if (face.odd()) return Reason::discontinuity;
    for (const auto& s : face.sides)
      if (s.group == group && polygons_.of(s.edge) == kernel::kNone)
        return polygons_.wanted(s.edge) ? Reason::border : Reason::inflection;
    return kUnexplained;
  }

  Index corner_in(Index polygon, Index leaf) const {
    Index i = 0;
    while (polygons_.leaf_of[4 * std::size_t{polygon} + i] != leaf) ++i;
    return 4 * polygon + i;
  }

  void make_vertices() {
    const auto count = static_cast<Index>(4 * mesh_.polygons.size());
    kernel::DisjointSets sets(count);
    for (std::size_t i = 1; i < uses_.size(); ++i) {
      if (!same_edge(uses_[i - 1], uses_[i])) continue;
      for (const Index leaf : uses_[i].leaves)
        sets.unite(corner_in(uses_[i - 1].polygon, leaf), corner_in(uses_[i].polygon, leaf));
    }
    std::vector<std::pair<Index, Index>> roots;
    for (Index c = 0; c < count; ++c)
      if (polygons_.leaf_of[c] != kernel::kNone && sets.find(c) == c)
        roots.emplace_back(polygons_.leaf_of[c], c);
    tbb::parallel_sort(roots.begin(), roots.end());
    std::vector<Index> number(count);
    std::size_t before = ~std::size_t{0};
    bool counted = false;
    for (const auto& [leaf, root] : roots) {
      counted = leaf == before && counted;
      if (leaf == before && !counted) {
        ++counts_.sheets_split;
        counted = true;
      }
      before = leaf;
      number[root] = static_cast<Index>(mesh_.vertices.size());
      mesh_.vertices.push_back({leaf, {}});
    }
    for (Index c = 0; c < count; ++c)
      if (polygons_.leaf_of[c] != kernel::kNone)
        mesh_.polygons[c / 4].corners[c % 4] = number[sets.find(c)];
    place_vertices(tree_, mesh_);
  }

  void make_edges() {
    std::size_t first = 0;  // Of the face's edges of the mesh.
    std::vector<Vec3> middles;
    for (std::size_t i = 0, end; i < uses_.size(); i = end) {
      for (end = i; end < uses_.size() && same_edge(uses_[i], uses_[end]);) ++end;
      SheetEdge edge;
      const Use& u = uses_[i];
      const SheetPolygon& p = mesh_.polygons[u.polygon];
      edge.ends = {p.corners[u.side], p.corners[(u.side + 1) % p.count]};
      edge.valence = static_cast<std::uint8_t>(end - i);
      edge.reason = end - i == 2 ? 0 : u.reason;
      const auto number = static_cast<Index>(mesh_.edges.size());
      if (i == 0 || uses_[i - 1].face != u.face) {
        first = number;
        middles.clear();
      }
      Vec3& middle = middles.emplace_back();
      for (std::size_t k = i; k < end; ++k) {
        mesh_.polygons[uses_[k].polygon].sides[uses_[k].side] = number;
        middle = middle + (1.0 / double(end - i)) * mesh_.polygons[uses_[k].polygon].zero;
      }
      for (std::size_t k = first; k < mesh_.edges.size(); ++k) {
        if (std::minmax(edge.ends[0], edge.ends[1]) !=
            std::minmax(mesh_.edges[k].ends[0], mesh_.edges[k].ends[1]))
          continue;
        put_middle(mesh_.edges[k], middles[k - first]);
        put_middle(edge, middle);
      }
      mesh_.edges.push_back(edge);
    }
  }
  /// The edge is a twin.
  void put_middle(SheetEdge& edge, const Vec3& middle) {
    if (edge.middle != kernel::kNone) return;
    edge.middle = static_cast<Index>(mesh_.middles.size());
    mesh_.middles.push_back(middle);
  }

  const PointTree& tree_;
  Counts& counts_;
  OctreePolygons polygons_;
  std::vector<Use>& uses_;
  SheetMesh mesh_;
};

}  // namespace

SheetMesh make_octree_sheets(const PointTree& tree, bool critical, Counts& counts) {
  return OctreeMesher(tree, critical, counts).make();
}

}  // namespace crest::extremal
