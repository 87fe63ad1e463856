// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/extremal/components.hpp"

#include <algorithm>

#include "certify/surface/union_find.hpp"

namespace crest::certify::extremal {
namespace {

using modes::UnionFind;

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

/// The fans are triangles (a point on the polygon's edge, the two ends of a side). Cut, each keeps
/// a piece next to its kept corners; the mesh shrinks to what is spanned by kept corners alone.
class Counter {
 public:
  Counter(const Mesh& mesh, const Kept& kept)
      : mesh_(mesh),
        kept_(kept),
        m_(mesh.corners),
        vertices_(static_cast<u32>(kept.vertices.size())),
        nodes_(vertices_ + mesh.polygons.size()) {}

  Components count() {
    join();
    number();
    for (u32 node = 0; node < nodes_.size(); ++node)
      if (is_kept(node)) ++at(node).euler_characteristic;
    for_spokes([&](u32 fan, u32 vertex) { add_edge(fan, vertex); });
    if (m_ == 4) {
      count_triangles();
      count_seams();
      count_loops();
      orient();
    } else {
      count_ends();
    }
    return std::move(out_);
  }

 private:
  class Nodes : public UnionFind {
   public:
    explicit Nodes(size_t n) : UnionFind(n), size_(n) {}
    size_t size() const { return size_; }

   private:
    size_t size_;
  };

  u32 fan(u32 polygon) const { return vertices_ + polygon; }
  bool is_kept(u32 node) const {
    return node < vertices_ ? kept_.vertices[node] != 0 : kept_.fans[node - vertices_] != 0;
  }
  u32 corner(u32 polygon, u32 i) const { return mesh_.vertex[m_ * polygon + i % m_]; }
  /// Ends of a seam of a volume.
  std::array<u32, 2> ends(const Seam& seam) const {
    const SideEnds ends = side_ends(seam.sides[0].side);
    return {corner(seam.sides[0].polygon, ends.low), corner(seam.sides[0].polygon, ends.high)};
  }
  template <class Visit>
  void for_spokes(const Visit& visit) const {
    for (u32 polygon = 0; polygon < mesh_.polygons.size(); ++polygon)
      for (u32 i = 0; i < m_; ++i) visit(fan(polygon), corner(polygon, i));
  }

  void join() {
    const auto join = [&](u32 a, u32 b) {
      if (is_kept(a) && is_kept(b)) nodes_.join(a, b);
    };
    for_spokes(join);
    if (m_ == 4)
      for (const Seam& seam : mesh_.seams) join(ends(seam)[0], ends(seam)[1]);
  }

  /// By the lowest polygon, then by the lowest kept corner there, its fan's point last.
  void number() {
    std::vector<u32> numbers(nodes_.size(), kNothing);  // of representatives
    u32 next = 0;
    for (u32 polygon = 0; polygon < mesh_.polygons.size(); ++polygon) {
      std::array<u32, 5> corners;
      corners.fill(fan(polygon));  // which comes last
      for (u32 i = 0; i < m_; ++i) corners[i] = corner(polygon, i);
      std::ranges::sort(corners);
      std::array<u32, 5> seen;
      unsigned count = 0;
      bool whole = true;
      for (const u32 node : corners) {
        if (!is_kept(node)) {
          whole = false;
          continue;
        }
        u32& number = numbers[nodes_.find(node)];
        if (number == kNothing) number = next++;
        if (std::find(seen.begin(), seen.begin() + count, number) == seen.begin() + count)
          seen[count++] = number;
      }
      out_.list.resize(next);
      for (unsigned i = 0; i < count; ++i) {
        ++out_.list[seen[i]].polygons;
        out_.list[seen[i]].cut |= !whole;
      }
    }
    out_.of_vertex.assign(vertices_, kNothing);
    number_.assign(nodes_.size(), kNothing);
    for (u32 node = 0; node < nodes_.size(); ++node) {
      if (!is_kept(node)) continue;
      number_[node] = numbers[nodes_.find(node)];
      if (node < vertices_) out_.of_vertex[node] = number_[node];
    }
  }
  ExtremalComponent& at(u32 node) { return out_.list[number_[node]]; }

  void add_edge(u32 a, u32 b) {
    if (is_kept(a) && is_kept(b)) --at(a).euler_characteristic;
  }
  void count_triangles() {
    for (u32 polygon = 0; polygon < mesh_.polygons.size(); ++polygon)
      for (u32 i = 0; i < m_; ++i) {
        const u32 a = fan(polygon), b = corner(polygon, i), c = corner(polygon, i + 1);
        const int kept = is_kept(a) + is_kept(b) + is_kept(c);
        if (kept == 3) ++at(a).euler_characteristic;
        out_.valences.one[2] += kept == 1 || kept == 2;
      }
  }
  void count_valence(const Seam& seam) {
    if (seam.count == 2)
      ++out_.valences.two;
    else if (seam.count == 3)
      ++out_.valences.three;
    else
      ++out_.valences.one[seam.reason - 1U];
  }
  void count_seams() {
    for (const Seam& seam : mesh_.seams) {
      const auto [a, b] = ends(seam);
      add_edge(a, b);
      if (is_kept(a) || is_kept(b)) count_valence(seam);
    }
  }

  /// Components of the boundary: seams with one polygon, and the cuts through triangles, which meet
  /// where they leave the triangles' sides.
  void count_loops() {
    const size_t spokes = size_t{m_} * mesh_.polygons.size();
    // Vertices, cut spokes, cut seams.
    UnionFind classes(vertices_ + spokes + mesh_.seams.size());
    std::vector<u32> owner(vertices_ + spokes + mesh_.seams.size(), kNothing);
    const auto join = [&](u32 component, u32 a, u32 b) {
      owner[a] = owner[b] = component;
      classes.join(a, b);
    };
    std::vector<u32> seam_of(spokes, kNothing);
    for (u32 i = 0; i < mesh_.seams.size(); ++i) {
      const Seam& seam = mesh_.seams[i];
      for (unsigned k = 0; k < seam.count; ++k)
        seam_of[m_ * seam.sides[k].polygon + seam.sides[k].side] = i;
      const auto [a, b] = ends(seam);
      if (seam.count != 1 || (!is_kept(a) && !is_kept(b))) continue;
      const u32 cut = vertices_ + static_cast<u32>(spokes) + i;
      join(number_[is_kept(a) ? a : b], is_kept(a) ? a : cut, is_kept(b) ? b : cut);
    }
    for (u32 polygon = 0; polygon < mesh_.polygons.size(); ++polygon)
      for (u32 i = 0; i < m_; ++i) {
        const std::array<u32, 3> nodes = {fan(polygon), corner(polygon, i), corner(polygon, i + 1)};
        const std::array<u32, 3> cuts = {
            vertices_ + m_ * polygon + i,
            vertices_ + static_cast<u32>(spokes) + seam_of[m_ * polygon + i],
            vertices_ + m_ * polygon + (i + 1) % m_};
        std::array<u32, 2> found{};
        unsigned count = 0;
        for (unsigned k = 0; k < 3; ++k)
          if (is_kept(nodes[k]) != is_kept(nodes[(k + 1) % 3])) found[count++] = cuts[k];
        if (count == 0) continue;
        const u32 kept = is_kept(nodes[0]) ? nodes[0] : is_kept(nodes[1]) ? nodes[1] : nodes[2];
        join(number_[kept], found[0], found[1]);
      }
    for (u32 i = 0; i < owner.size(); ++i)
      if (owner[i] != kNothing && classes.find(i) == i) ++out_.list[owner[i]].loops;
  }

  /// Triangles with something kept are turned alike across spokes; across seams of valence 2 if
  /// they run along it in opposite directions.
  void orient() {
    TurnedClasses classes(size_t{m_} * mesh_.polygons.size());
    const auto join = [&](u32 a, u32 b, bool turned, u32 kept) {
      if (!classes.join(a, b, turned)) at(kept).orientable = false;
    };
    for (u32 polygon = 0; polygon < mesh_.polygons.size(); ++polygon)
      for (u32 i = 0; i < m_; ++i) {
        const u32 end = corner(polygon, i), centre = fan(polygon);
        if (is_kept(end) || is_kept(centre))
          join(m_ * polygon + i, m_ * polygon + (i + m_ - 1) % m_, false,
               is_kept(end) ? end : centre);
      }
    for (const Seam& seam : mesh_.seams) {
      const auto [a, b] = ends(seam);
      if (seam.count != 2 || (!is_kept(a) && !is_kept(b))) continue;
      const Side &first = seam.sides[0], &second = seam.sides[1];
      join(m_ * first.polygon + first.side, m_ * second.polygon + second.side,
           side_ends(first.side).upwards == side_ends(second.side).upwards, is_kept(a) ? a : b);
    }
  }

  /// Of curves: vertices of valence 1, cuts.
  void count_ends() {
    for (const Seam& seam : mesh_.seams) {
      const u32 vertex = corner(seam.sides[0].polygon, seam.sides[0].side);
      if (!is_kept(vertex)) continue;
      count_valence(seam);
      at(vertex).loops += seam.count == 1;
    }
    for_spokes([&](u32 centre, u32 vertex) {
      if (is_kept(centre) == is_kept(vertex)) return;
      ++out_.valences.one[2];
      ++at(is_kept(vertex) ? vertex : centre).loops;
    });
  }

  const Mesh& mesh_;
  const Kept& kept_;
  u32 m_, vertices_;
  Nodes nodes_;
  std::vector<u32> number_;
  Components out_;
};

}  // namespace

Components count_components(const Mesh& mesh, const Kept& kept) {
  return Counter(mesh, kept).count();
}

}  // namespace crest::certify::extremal
