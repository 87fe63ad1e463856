// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/modes/surface.hpp"

#include <algorithm>
#include <tuple>

#include "certify/container/reject.hpp"
#include "certify/surface/union_find.hpp"

namespace crest::certify::modes {
namespace {

/// One side of an arc, or of a segment from a root to a vertex where the tensor is zero.
struct Half {
  u32 piece = kNone, first = kNone, second = kNone;  ///< vertices
};

/// A segment in the face of a zero vertex and a root's edge.
struct Spoke {
  u32 zero, root, tet;
  std::array<u32, 2> edge;
  Half half;
};

/// A corner whose tensor is zero, by its place among these.
u32 zero_of(const LevelContext& context, const std::array<u32, 4>& tet, unsigned index) {
  for (const u32 v : tet)
    if (context.field.zero(v) && index-- == 0) return v;
  throw std::logic_error("a tetrahedron without that zero");
}

/// The pieces in cells, cones and fans, not glued yet.
class Collector {
 public:
  Collector(const LevelContext& context, const Domain& domain)
      : context_(context), domain_(domain), halves_(context.stated.arcs.size()) {}

 protected:
  struct Piece {
    std::int8_t level;
    std::int32_t characteristic;  ///< of its interior, with compact supports
  };
  /// An arc of the boundary, or one between two pieces, once glued.
  struct Line {
    u32 piece, first, second;
    bool boundary;
  };

  u32 add_vertex(u32 piece) {
    vertex_piece_.push_back(piece);
    return static_cast<u32>(vertex_piece_.size() - 1);
  }
  u32 add_piece(std::int8_t level, std::int32_t characteristic) {
    pieces_.push_back({level, characteristic});
    return static_cast<u32>(pieces_.size() - 1);
  }
  void add_half(u32 arc, const Half& half) {
    auto& [one, two] = halves_[arc];
    require(two.piece == kNone, "arc {}: more than two pieces at it", arc);
    (one.piece == kNone ? one : two) = half;
  }

  void add_cell(const CellPieces& cell) {
    const auto first_piece = static_cast<u32>(pieces_.size());
    const auto first_vertex = static_cast<u32>(vertex_piece_.size());
    for (std::size_t i = 0; i < cell.levels.size(); ++i)
      add_piece(cell.levels[i], 2 - static_cast<std::int32_t>(cell.loops[i]));
    vertex_piece_.resize(first_vertex + cell.roots, kNone);
    for (const HalfArc& arc : cell.arcs) {
      const Half half = {first_piece + arc.piece, first_vertex + arc.first,
                         first_vertex + arc.second};
      add_half(arc.arc, half);
      vertex_piece_[half.first] = vertex_piece_[half.second] = half.piece;
    }
  }

  void add_zero_tets() {
    std::size_t next_open = 0;
    const auto& open = context_.trees.open_tets;
    for (u32 t = 0; t < domain_.tets.size(); ++t) {
      if (next_open < open.size() && open[next_open] == t) {
        ++next_open;
        continue;
      }
      const auto corners = nonzero_corners(context_.field, domain_.tets[t]);
      if (corners.size() == 3) add_cone(t, {corners[0], corners[1], corners[2]});
      if (corners.size() == 2) add_fan(t, {corners[0], corners[1]});
    }
  }

  /// Over every path and loop in the opposite face.
  void add_cone(u32 tet, const std::array<u32, 3>& corners) {
    const u32 zero = zero_of(context_, domain_.tets[tet], 0);
    std::vector<u32> leaves;
    list_leaves(context_.trees, context_.trees.face(corners), leaves);
    std::vector<FaceArc> arcs;
    for (const u32 leaf : leaves) list_arcs(context_, leaf, arcs);
    if (arcs.empty()) return;
    std::vector<u32> roots;
    for (const FaceArc& arc : arcs) roots.insert(roots.end(), {arc.first, arc.second});
    std::ranges::sort(roots);
    auto distinct = roots;
    distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
    const auto local = [&](u32 root) {
      return static_cast<u32>(std::ranges::lower_bound(distinct, root) - distinct.begin());
    };
    UnionFind curves(distinct.size());
    for (const FaceArc& arc : arcs) curves.join(local(arc.first), local(arc.second));
    std::vector<u32> piece(distinct.size(), kNone), vertex(distinct.size()),
        apex(distinct.size(), kNone);
    for (const FaceArc& arc : arcs) {
      u32& of_curve = piece[curves.find(local(arc.first))];
      if (of_curve == kNone) of_curve = add_piece(arc.level, 1);
    }
    for (u32 i = 0; i < distinct.size(); ++i) vertex[i] = add_vertex(piece[curves.find(i)]);
    for (const FaceArc& arc : arcs)
      add_half(arc.arc, {piece[curves.find(local(arc.first))], vertex[local(arc.first)],
                         vertex[local(arc.second)]});
    // Ends of paths: roots of one arc. Both ends of a path have the same apex.
    for (u32 i = 0; i < distinct.size(); ++i) {
      const auto [from, to] = std::ranges::equal_range(roots, distinct[i]);
      if (to - from != 1) continue;
      const u32 curve = curves.find(i);
      if (apex[curve] == kNone) apex[curve] = add_vertex(piece[curve]);
      spokes_.push_back({zero,
                         distinct[i],
                         tet,
                         edge_of(corners, distinct[i]),
                         {piece[curve], vertex[i], apex[curve]}});
    }
    cones_ += static_cast<u32>(std::ranges::count_if(piece, [](u32 p) { return p != kNone; }));
  }

  /// The roots on an edge of the complex.
  void list_roots(std::array<u32, 2> ends, std::vector<u32>& roots) const {
    std::vector<u32> stack = {context_.trees.edge(ends[0], ends[1])};
    while (!stack.empty()) {
      const u32 node = stack.back();
      const EdgeNode& edge = context_.trees.edges[node];
      stack.pop_back();
      if (!edge.leaf()) stack.insert(stack.end(), {node + 1, edge.other});
      require(!edge.open, "edge ({}, {}): open, yet opposite to an edge of zeros", edge.first,
              edge.second);
      for (u32 i = 0; i < edge.roots; ++i) roots.push_back(edge.root + i);
    }
  }
  std::array<u32, 2> edge_of(const std::array<u32, 3>& corners, u32 root) const {
    for (const auto [i, j] : {std::array{0U, 1U}, std::array{0U, 2U}, std::array{1U, 2U}}) {
      std::vector<u32> roots;
      list_roots({corners[i], corners[j]}, roots);
      if (std::ranges::find(roots, root) != roots.end()) return {corners[i], corners[j]};
    }
    throw Reject(
        fmt::format("face ({}, {}, {}): a curve ends inside", corners[0], corners[1], corners[2]));
  }

  void add_fan(u32 tet, const std::array<u32, 2>& ends) {
    std::vector<u32> roots;
    list_roots(ends, roots);
    for (const u32 root : roots) {
      const u32 piece = add_piece(context_.stated.roots[root].level, 1);
      const u32 vertex = add_vertex(piece);
      std::array<u32, 2> apexes{};
      for (unsigned i = 0; i < 2; ++i) {
        apexes[i] = add_vertex(piece);
        spokes_.push_back(
            {zero_of(context_, domain_.tets[tet], i), root, tet, ends, {piece, vertex, apexes[i]}});
      }
      lines_.push_back({piece, apexes[0], apexes[1], true});  // along the edge of zeros
      ++fans_;
    }
  }

  const LevelContext& context_;
  const Domain& domain_;
  std::vector<std::array<Half, 2>> halves_;  ///< of arcs
  std::vector<Piece> pieces_;
  std::vector<u32> vertex_piece_;  ///< a vertex of a piece, before they are glued
  std::vector<Spoke> spokes_;
  std::vector<Line> lines_;
  std::vector<u32> touched_;
  u32 cones_ = 0, fans_ = 0;
};

class Gluer : public Collector {
 public:
  using Collector::Collector;

  LevelSurfaces glue(const std::vector<CellPieces>& cells) {
    for (const CellPieces& cell : cells) add_cell(cell);
    add_zero_tets();
    UnionFind pieces(pieces_.size()), vertices(vertex_piece_.size());
    join_arcs(pieces, vertices);
    join_spokes(pieces, vertices);
    return count(pieces, vertices);
  }

 private:
  void join(const Half& a, const Half& b, UnionFind& pieces, UnionFind& vertices) {
    pieces.join(a.piece, b.piece);
    vertices.join(a.first, b.first);
    vertices.join(a.second, b.second);
    lines_.push_back({a.piece, a.first, a.second, false});
  }
  /// One side is a piece; the other is the domain's boundary, or nothing is claimed there.
  void end(const Half& half, bool open) {
    lines_.push_back({half.piece, half.first, half.second, !open});
    if (open) touched_.push_back(half.piece);
  }

  void join_arcs(UnionFind& pieces, UnionFind& vertices) {
    for (const FaceNode& face : context_.trees.faces) {
      for (u32 arc = face.arc; arc < face.arc + face.arcs; ++arc) {
        const auto& [one, two] = halves_[arc];
        const unsigned found = (one.piece != kNone) + (two.piece != kNone);
        require(found + face.open_sides == face.sides,
                "face ({}, {}, {}): pieces at {} of {} sides of an arc", face.corners[0],
                face.corners[1], face.corners[2], found, face.sides - face.open_sides);
        if (found == 2) join(one, two, pieces, vertices);
        if (found == 1) end(one, face.open_sides > 0);
      }
    }
  }

  void join_spokes(UnionFind& pieces, UnionFind& vertices) {
    const auto key = [](const Spoke& s) { return std::tuple(s.zero, s.root, s.tet); };
    std::ranges::sort(spokes_, {}, key);
    for (std::size_t i = 0; i < spokes_.size(); ++i) {
      const Spoke& one = spokes_[i];
      const bool paired = i + 1 < spokes_.size() && spokes_[i + 1].zero == one.zero &&
                          spokes_[i + 1].root == one.root;
      if (paired) {
        join(one.half, spokes_[++i].half, pieces, vertices);
        continue;
      }
      std::array<u32, 3> corners = {one.zero, one.edge[0], one.edge[1]};
      std::ranges::sort(corners);
      const auto [first, second] = domain_.faces[domain_.find(corners)].tets;
      const u32 other = first == one.tet ? second : first;
      const bool open =
          other != kNone && std::ranges::binary_search(context_.trees.open_tets, other);
      require(other == kNone || open, "face ({}, {}, {}): a piece at one of its sides", corners[0],
              corners[1], corners[2]);
      end(one.half, open);
    }
  }

  LevelSurfaces count(UnionFind& pieces, UnionFind& vertices) {
    std::vector<std::int64_t> characteristic(pieces_.size(), 0), loops(pieces_.size(), 0);
    std::vector<std::uint8_t> touched(pieces_.size(), 0), ends(vertex_piece_.size(), 0);
    for (u32 i = 0; i < pieces_.size(); ++i)
      characteristic[pieces.find(i)] += pieces_[i].characteristic;
    for (const u32 piece : touched_) touched[pieces.find(piece)] = 1;
    for (u32 i = 0; i < vertex_piece_.size(); ++i)
      if (vertices.find(i) == i && vertex_piece_[i] != kNone)
        ++characteristic[pieces.find(vertex_piece_[i])];
    // Loops of the boundary: classes of its vertices.
    UnionFind rims(vertex_piece_.size());
    for (const Line& line : lines_) {
      --characteristic[pieces.find(line.piece)];
      if (!line.boundary) continue;
      const u32 a = vertices.find(line.first), b = vertices.find(line.second);
      rims.join(a, b);
      for (const u32 v : {a, b}) ends[v] = static_cast<std::uint8_t>(std::min(3, ends[v] + 1));
    }
    for (u32 v = 0; v < ends.size(); ++v) {
      if (ends[v] == 0) continue;
      const u32 component = pieces.find(vertex_piece_[v]);
      require(ends[v] == 2 || touched[component] != 0, "surface: its boundary is no loop");
      loops[component] += rims.find(v) == v;
    }
    LevelSurfaces surfaces;
    surfaces.cones = cones_, surfaces.fans = fans_;
    for (u32 i = 0; i < pieces_.size(); ++i) {
      if (pieces.find(i) != i) continue;
      SurfaceCounts& counts = pieces_[i].level > 0 ? surfaces.positive : surfaces.negative;
      if (touched[i] != 0)
        ++counts.touched;
      else
        counts.components.push_back(
            {static_cast<std::int32_t>(characteristic[i]), static_cast<u32>(loops[i])});
    }
    std::ranges::sort(surfaces.positive.components);
    std::ranges::sort(surfaces.negative.components);
    return surfaces;
  }
};

}  // namespace

LevelSurfaces glue_pieces(const LevelContext& context, const Domain& domain,
                          const std::vector<CellPieces>& cells) {
  return Gluer(context, domain).glue(cells);
}

}  // namespace crest::certify::modes
