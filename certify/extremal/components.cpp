// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/extremal/components.hpp"

#include <algorithm>

#include "certify/surface/union_find.hpp"

namespace crest::certify::extremal {
namespace {

/// Classes of things of which each is turned like its representative or the other way round.
class TurnedClasses {
 public:
  explicit TurnedClasses(size_t n) : parent_(n), turned_(n, 0) {
    for (u32 i = 0; i < n; ++i) parent_[i] = i;
  }
  struct Root {
    u32 root;
    bool turned;
  };
  Root find(u32 i) {
    bool turned = false;
    u32 root = i;
    while (parent_[root] != root) {
      turned ^= turned_[root] != 0;
      root = parent_[root];
    }
    for (bool rest = turned; parent_[i] != root && i != root;) {
      const u32 next = parent_[i];
      const bool step = turned_[i] != 0;
      parent_[i] = root;
      turned_[i] = rest;
      rest ^= step;
      i = next;
    }
    return {root, turned};
  }
  /// Whether that was possible.
  bool join(u32 i, u32 j, bool turned) {
    const Root a = find(i), b = find(j);
    if (a.root == b.root) return (a.turned != b.turned) == turned;
    const u32 low = std::min(a.root, b.root), high = std::max(a.root, b.root);
    parent_[high] = low;
    turned_[high] = (a.turned != b.turned) != turned;
    return true;
  }

 private:
  std::vector<u32> parent_;
  std::vector<std::uint8_t> turned_;
};

/// The mesh as fans of triangles (a point on the polygon's edge, the two ends of a side). Nodes are
/// the vertices, then those points. Cut, a triangle keeps a piece next to its kept corners, so the
/// mesh shrinks to what is spanned by kept nodes alone.
struct Fan {
  const Mesh& mesh;
  const Kept& kept;
  u32 m, vertices;            ///< corners of a polygon; vertices of the mesh
  std::vector<u32> number{};  ///< of a kept node's component

  Fan(const Mesh& of, const Kept& parts)
      : mesh(of), kept(parts), m(of.corners), vertices(static_cast<u32>(parts.vertices.size())) {}
  u32 polygons() const { return static_cast<u32>(mesh.polygons.size()); }
  u32 nodes() const { return vertices + polygons(); }
  u32 fan(u32 polygon) const { return vertices + polygon; }
  bool is_kept(u32 node) const {
    return node < vertices ? kept.vertices[node] != 0 : kept.fans[node - vertices] != 0;
  }
  u32 corner(u32 polygon, u32 i) const { return mesh.vertex[m * polygon + i % m]; }
  /// Ends of a seam of a volume.
  std::array<u32, 2> ends(const Seam& seam) const {
    const SideEnds ends = side_ends(seam.sides[0].side);
    return {corner(seam.sides[0].polygon, ends.low), corner(seam.sides[0].polygon, ends.high)};
  }
  template <class Visit>
  void for_spokes(const Visit& visit) const {
    for (u32 polygon = 0; polygon < mesh.polygons.size(); ++polygon)
      for (u32 i = 0; i < m; ++i) visit(fan(polygon), corner(polygon, i));
  }
};

/// Components of the boundary: seams with one polygon, and the cuts through triangles, which meet
/// where they leave the triangles' sides.
void count_loops(const Fan& fan, std::vector<ExtremalComponent>& list) {
  const size_t spokes = size_t{fan.m} * fan.mesh.polygons.size();
  // Vertices, cut spokes, cut seams.
  UnionFind classes(fan.vertices + spokes + fan.mesh.seams.size());
  std::vector<u32> owner(fan.vertices + spokes + fan.mesh.seams.size(), kNothing);
  const auto join = [&](u32 component, u32 a, u32 b) {
    owner[a] = owner[b] = component;
    classes.join(a, b);
  };
  std::vector<u32> seam_of(spokes, kNothing);
  for (u32 i = 0; i < fan.mesh.seams.size(); ++i) {
    const Seam& seam = fan.mesh.seams[i];
    for (unsigned k = 0; k < seam.count; ++k)
      seam_of[fan.m * seam.sides[k].polygon + seam.sides[k].side] = i;
    const auto [a, b] = fan.ends(seam);
    if (seam.count != 1 || (!fan.is_kept(a) && !fan.is_kept(b))) continue;
    const u32 cut = fan.vertices + static_cast<u32>(spokes) + i;
    join(fan.number[fan.is_kept(a) ? a : b], fan.is_kept(a) ? a : cut, fan.is_kept(b) ? b : cut);
  }
  for (u32 polygon = 0; polygon < fan.mesh.polygons.size(); ++polygon)
    for (u32 i = 0; i < fan.m; ++i) {
      const std::array<u32, 3> nodes = {fan.fan(polygon), fan.corner(polygon, i),
                                        fan.corner(polygon, i + 1)};
      const std::array<u32, 3> cuts = {
          fan.vertices + fan.m * polygon + i,
          fan.vertices + static_cast<u32>(spokes) + seam_of[fan.m * polygon + i],
          fan.vertices + fan.m * polygon + (i + 1) % fan.m};
      std::array<u32, 2> found{};
      unsigned count = 0;
      for (unsigned k = 0; k < 3; ++k)
        if (fan.is_kept(nodes[k]) != fan.is_kept(nodes[(k + 1) % 3])) found[count++] = cuts[k];
      if (count == 0) continue;
      const u32 kept = fan.is_kept(nodes[0])   ? nodes[0]
                       : fan.is_kept(nodes[1]) ? nodes[1]
                                               : nodes[2];
      join(fan.number[kept], found[0], found[1]);
    }
  for (u32 i = 0; i < owner.size(); ++i)
    if (owner[i] != kNothing && classes.find(i) == i) ++list[owner[i]].loops;
}

/// Triangles with something kept are turned alike across spokes; across seams of valence 2 if
/// they run along it in opposite directions.
void orient(const Fan& fan, std::vector<ExtremalComponent>& list) {
  TurnedClasses classes(size_t{fan.m} * fan.mesh.polygons.size());
  const auto join = [&](u32 a, u32 b, bool turned, u32 kept) {
    if (!classes.join(a, b, turned)) list[fan.number[kept]].orientable = false;
  };
  for (u32 polygon = 0; polygon < fan.mesh.polygons.size(); ++polygon)
    for (u32 i = 0; i < fan.m; ++i) {
      const u32 end = fan.corner(polygon, i), centre = fan.fan(polygon);
      if (fan.is_kept(end) || fan.is_kept(centre))
        join(fan.m * polygon + i, fan.m * polygon + (i + fan.m - 1) % fan.m, false,
             fan.is_kept(end) ? end : centre);
    }
  for (const Seam& seam : fan.mesh.seams) {
    const auto [a, b] = fan.ends(seam);
    if (seam.count != 2 || (!fan.is_kept(a) && !fan.is_kept(b))) continue;
    const Side &first = seam.sides[0], &second = seam.sides[1];
    join(fan.m * first.polygon + first.side, fan.m * second.polygon + second.side,
         side_ends(first.side).upwards == side_ends(second.side).upwards, fan.is_kept(a) ? a : b);
  }
}

/// Classes of kept nodes that kept edges join.
UnionFind join_nodes(const Fan& fan) {
  UnionFind nodes(fan.nodes());
  const auto join = [&](u32 a, u32 b) {
    if (fan.is_kept(a) && fan.is_kept(b)) nodes.join(a, b);
  };
  fan.for_spokes(join);
  if (fan.m == 4)
    for (const Seam& seam : fan.mesh.seams) join(fan.ends(seam)[0], fan.ends(seam)[1]);
  return nodes;
}

/// By the lowest polygon, then by the lowest kept vertex there, its fan's point last.
void number_components(Fan& fan, Components& out) {
  UnionFind nodes = join_nodes(fan);
  std::vector<u32> numbers(fan.nodes(), kNothing);  // of representatives
  u32 next = 0;
  for (u32 polygon = 0; polygon < fan.polygons(); ++polygon) {
    std::array<u32, 5> corners;
    corners.fill(fan.fan(polygon));  // which comes last
    for (u32 i = 0; i < fan.m; ++i) corners[i] = fan.corner(polygon, i);
    std::ranges::sort(corners);
    std::array<u32, 5> seen;
    unsigned count = 0;
    bool whole = true;
    for (const u32 node : corners) {
      if (!fan.is_kept(node)) {
        whole = false;
        continue;
      }
      u32& number = numbers[nodes.find(node)];
      if (number == kNothing) number = next++;
      if (std::find(seen.begin(), seen.begin() + count, number) == seen.begin() + count)
        seen[count++] = number;
    }
    out.list.resize(next);
    for (unsigned i = 0; i < count; ++i) {
      ++out.list[seen[i]].polygons;
      out.list[seen[i]].cut |= !whole;
    }
  }
  out.of_vertex.assign(fan.vertices, kNothing);
  fan.number.assign(fan.nodes(), kNothing);
  for (u32 node = 0; node < fan.nodes(); ++node) {
    if (!fan.is_kept(node)) continue;
    fan.number[node] = numbers[nodes.find(node)];
    if (node < fan.vertices) out.of_vertex[node] = fan.number[node];
  }
}

/// What kept nodes alone span, without the edges of the mesh.
void count_fans(const Fan& fan, Components& out) {
  const auto at = [&](u32 node) -> std::int32_t& {
    return out.list[fan.number[node]].euler_characteristic;
  };
  for (u32 node = 0; node < fan.nodes(); ++node)
    if (fan.is_kept(node)) ++at(node);
  fan.for_spokes([&](u32 centre, u32 vertex) {
    if (fan.is_kept(centre) && fan.is_kept(vertex)) --at(centre);
  });
  if (fan.m != 4) return;
  for (u32 polygon = 0; polygon < fan.polygons(); ++polygon)
    for (u32 i = 0; i < fan.m; ++i) {
      const u32 a = fan.fan(polygon), b = fan.corner(polygon, i), c = fan.corner(polygon, i + 1);
      const int kept = fan.is_kept(a) + fan.is_kept(b) + fan.is_kept(c);
      if (kept == 3) ++at(a);
      out.valences.one[2] += kept == 1 || kept == 2;
    }
}

void count_valence(const Seam& seam, ExtremalValences& valences) {
  if (seam.count == 2)
    ++valences.two;
  else if (seam.count == 3)
    ++valences.three;
  else
    ++valences.one[seam.reason - 1U];
}
void count_seams(const Fan& fan, Components& out) {
  for (const Seam& seam : fan.mesh.seams) {
    const auto [a, b] = fan.ends(seam);
    if (fan.is_kept(a) && fan.is_kept(b)) --out.list[fan.number[a]].euler_characteristic;
    if (fan.is_kept(a) || fan.is_kept(b)) count_valence(seam, out.valences);
  }
}

/// Of curves: vertices of valence 1, cuts.
void count_ends(const Fan& fan, Components& out) {
  for (const Seam& seam : fan.mesh.seams) {
    const u32 vertex = fan.corner(seam.sides[0].polygon, seam.sides[0].side);
    if (!fan.is_kept(vertex)) continue;
    count_valence(seam, out.valences);
    out.list[fan.number[vertex]].loops += seam.count == 1;
  }
  fan.for_spokes([&](u32 centre, u32 vertex) {
    if (fan.is_kept(centre) == fan.is_kept(vertex)) return;
    ++out.valences.one[2];
    ++out.list[fan.number[fan.is_kept(vertex) ? vertex : centre]].loops;
  });
}

}  // namespace

Components count_components(const Mesh& mesh, const Kept& kept) {
  Components out;
  Fan fan(mesh, kept);
  number_components(fan, out);
  count_fans(fan, out);
  if (fan.m == 4) {
    count_seams(fan, out);
    count_loops(fan, out.list);
    orient(fan, out.list);
  } else {
    count_ends(fan, out);
  }
  return out;
}

}  // namespace crest::certify::extremal
