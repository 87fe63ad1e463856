// SPDX-License-Identifier: GPL-3.0-or-later
// Sides of tiles that the level crosses are chained through the tiles; then places are computed
// face by face: on mesh edges, and in fans on the sides from the face-critical node.
#include "algorithms/reeb/contours.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "algorithms/reeb/conic_arc.hpp"
#include "algorithms/reeb/exact_node_value.hpp"

namespace crest::reeb {
namespace {

using kernel::QuadraticMesh;
using kernel::Rational;
using kernel::Vec3;

constexpr int kArcDepth = 4;

/// The face-critical point of a face that has one, by the formulas of SPEC.md.
class ExactFace {
 public:
  ExactFace(const QuadraticMesh& mesh, Index face) {
    std::array<Rational, 3> f, m;
    for (std::size_t k = 0; k < 3; ++k) {
      f[k] = mesh.values()[mesh.faces()[face][k]];
      m[k] = mesh.edge_values()[mesh.face_edges()[face][k]];
    }
    corner_ = f[0];
    g_ = 4 * m[0] - 3 * f[0] - f[1];
    h_ = 4 * m[2] - 3 * f[0] - f[2];
    p_ = 4 * (f[0] + f[1] - 2 * m[0]);
    r_ = 4 * (f[0] + f[2] - 2 * m[2]);
    q_ = 4 * (f[0] + m[1] - m[0] - m[2]);
    det_ = p_ * r_ - q_ * q_;
  }
  Rational s() const { return (h_ * q_ - g_ * r_) / det_; }
  Rational t() const { return (g_ * q_ - h_ * p_) / det_; }
  Rational centre_value() const { return corner_ + (g_ * s() + h_ * t()) / 2; }

 private:
  Rational corner_, g_, h_, p_, q_, r_, det_;
};

/// A side of a tile: one node below the level, one above.
struct Side {
  Index low, high;  ///< by number
  friend auto operator<=>(const Side&, const Side&) = default;
};

/// A tile crossed by the level: its two crossed sides, and its face.
struct Crossed {
  std::array<Index, 2> sides;
  Index face;
};

struct Crossings {
  std::vector<Side> sides;  ///< ascending
  std::vector<Crossed> pieces;
  std::vector<std::array<Index, 2>> pieces_of;  ///< by side; kNone on the boundary
};

Crossings find_crossings(const QuadraticMesh& mesh, const TileComplex& tiles, Index below) {
  std::vector<std::array<Side, 2>> crossed;
  std::vector<Index> faces;
  Crossings result;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const Index begin = tiles.tile_begin.empty() ? f : tiles.tile_begin[f];
    const Index end = tiles.tile_begin.empty() ? f + 1 : tiles.tile_begin[f + 1];
    for (Index t = begin; t < end; ++t) {
      std::array<Side, 2> sides{};
      std::size_t count = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const Index a = tiles.tiles[t][k], b = tiles.tiles[t][(k + 1) % 3];
        if ((tiles.rank[a] < below) == (tiles.rank[b] < below)) continue;
        sides[count++] = {std::min(a, b), std::max(a, b)};
      }
      if (count == 0) continue;
      crossed.push_back(sides);
      faces.push_back(f);
      result.sides.insert(result.sides.end(), sides.begin(), sides.end());
    }
  }
  std::sort(result.sides.begin(), result.sides.end());
  result.sides.erase(std::unique(result.sides.begin(), result.sides.end()), result.sides.end());
  result.pieces_of.assign(result.sides.size(), {kNone, kNone});
  for (std::size_t i = 0; i < crossed.size(); ++i) {
    Crossed piece{{}, faces[i]};
    for (std::size_t k = 0; k < 2; ++k) {
      const auto at = std::lower_bound(result.sides.begin(), result.sides.end(), crossed[i][k]);
      piece.sides[k] = static_cast<Index>(at - result.sides.begin());
      auto& of = result.pieces_of[piece.sides[k]];
      of[of[0] == kNone ? 0 : 1] = static_cast<Index>(i);
    }
    result.pieces.push_back(piece);
  }
  return result;
}

/// Successive sides and the faces between them (one less for a path).
struct Line {
  std::vector<Index> sides, faces;
  bool closed;
};

/// Which way a cycle runs depends on its sides alone: towards the lesser neighbour of its least.
Index first_piece(const Crossings& crossings, Index side) {
  const auto [p, q] = crossings.pieces_of[side];
  if (q == kNone) return p;
  const auto other = [&](Index piece) {
    const auto& s = crossings.pieces[piece].sides;
    return s[0] == side ? s[1] : s[0];
  };
  return other(p) <= other(q) ? p : q;
}

std::vector<Line> chain(const Crossings& crossings) {
  std::vector<Line> lines;
  std::vector<bool> seen(crossings.sides.size(), false);
  const auto follow = [&](Index start) {
    Line line{{start}, {}, false};
    seen[start] = true;
    Index side = start, piece = first_piece(crossings, start);
    while (piece != kNone) {
      const Crossed& p = crossings.pieces[piece];
      side = p.sides[0] == side ? p.sides[1] : p.sides[0];
      line.faces.push_back(p.face);
      if (side == start) {
        line.closed = true;
        break;
      }
      seen[side] = true;
      line.sides.push_back(side);
      const auto& of = crossings.pieces_of[side];
      piece = of[0] == piece ? of[1] : of[0];
    }
    lines.push_back(std::move(line));
  };
  for (const bool paths : {true, false}) {
    for (Index s = 0; s < crossings.sides.size(); ++s)
      if (!seen[s] && (!paths || crossings.pieces_of[s][1] == kNone)) follow(s);
  }
  return lines;
}

class Placer {
 public:
  Placer(const QuadraticMesh& mesh, const TileComplex& tiles, double level)
      : mesh_(mesh), tiles_(tiles), level_(level) {}

  /// Sides inside faces without a face-critical node are only a means of chaining.
  bool has_place(const Side& side) const {
    return side.high >= first_face_node() || edge_of(side) != kNone;
  }

  /// In the coordinates of a face that has the side.
  Vec2 place(const Side& side, Index face) const {
    if (side.high >= first_face_node()) return on_spoke(side, face);
    const Index edge = edge_of(side);
    const kernel::Edge& e = mesh_.edges()[edge];
    const double a = mesh_.values()[e.v0], b = mesh_.values()[e.v1];
    const double m = mesh_.linear() ? 0.5 * a + 0.5 * b : mesh_.edge_values()[edge];
    double u = parameter(side.low, edge), v = parameter(side.high, edge);
    if (u > v) std::swap(u, v);
    const double x = crossing_parameter(a, m, b, level_, u, v);
    const Vec2 p = corner(e.v0, face), q = corner(e.v1, face);
    return p + x * (q - p);
  }

  Vec3 world(const Vec2& p, Index face) const {
    const Triangle& f = mesh_.faces()[face];
    Vec3 result{};
    for (std::size_t i = 0; i < 3; ++i) {
      result[i] = (1 - p[0] - p[1]) * mesh_.points()[f[0]][i] + p[0] * mesh_.points()[f[1]][i] +
                  p[1] * mesh_.points()[f[2]][i];
    }
    return result;
  }

  double level() const { return level_; }

  FaceFunction function(Index face) const {
    std::array<double, 3> corners{}, middles{};
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = mesh_.values()[mesh_.faces()[face][k]];
      middles[k] = mesh_.edge_values()[mesh_.face_edges()[face][k]];
    }
    return face_function(corners, middles);
  }

 private:
  Index first_face_node() const {
    return tiles_.vertex_count + static_cast<Index>(tiles_.critical_edges.size());
  }

  /// The mesh edge that the side is a part of, or kNone.
  Index edge_of(const Side& side) const {
    if (side.low >= tiles_.vertex_count) return kNone;
    if (side.high >= tiles_.vertex_count) {
      const Index edge = tiles_.critical_edges[side.high - tiles_.vertex_count];
      const kernel::Edge& e = mesh_.edges()[edge];
      return e.v0 == side.low || e.v1 == side.low ? edge : kNone;
    }
    const auto at = std::lower_bound(mesh_.edges().begin(), mesh_.edges().end(), side,
                                     [](const kernel::Edge& e, const Side& s) {
                                       return std::pair(e.v0, e.v1) < std::pair(s.low, s.high);
                                     });
    return static_cast<Index>(at - mesh_.edges().begin());
  }

  double parameter(Index node, Index edge) const {
    const kernel::Edge& e = mesh_.edges()[edge];
    if (node < tiles_.vertex_count) return node == e.v0 ? 0 : 1;
    const double a = mesh_.values()[e.v0], b = mesh_.values()[e.v1];
    const double start = 4 * mesh_.edge_values()[edge] - 3 * a - b;
    const double end = 3 * b + a - 4 * mesh_.edge_values()[edge];
    return std::clamp(start / (start - end), 0.0, 1.0);
  }

  Vec2 corner(Index vertex, Index face) const {
    const Triangle& f = mesh_.faces()[face];
    return {vertex == f[1] ? 1.0 : 0.0, vertex == f[2] ? 1.0 : 0.0};
  }

  Vec2 boundary_node(Index node, Index face) const {
    if (node < tiles_.vertex_count) return corner(node, face);
    const Index edge = tiles_.critical_edges[node - tiles_.vertex_count];
    const double x = parameter(node, edge);
    const Vec2 p = corner(mesh_.edges()[edge].v0, face), q = corner(mesh_.edges()[edge].v1, face);
    return p + x * (q - p);
  }

  /// From the face-critical node the function changes with the square of the distance. Its place
  /// and value are rounded from exact ones: H may be next to nothing.
  Vec2 on_spoke(const Side& side, Index face) const {
    const ExactFace f(mesh_, face);
    const Vec2 centre = {f.s().convert_to<double>(), f.t().convert_to<double>()};
    const Vec2 end = boundary_node(side.low, face);
    const double v = f.centre_value().convert_to<double>(), w = function(face).at(end);
    const double share = std::sqrt(std::clamp((level_ - v) / (w - v), 0.0, 1.0));
    const double x = std::isfinite(share) ? share : 0.5;
    return centre + x * (end - centre);
  }

  const QuadraticMesh& mesh_;
  const TileComplex& tiles_;
  double level_;
};

/// Rotates a closed line to start at a side that has a place. Every cycle has one: it surrounds a
/// face-critical node or leaves its face.
void start_at_place(const Crossings& crossings, const Placer& placer, Line& line) {
  if (!line.closed) return;
  std::size_t shift = 0;
  while (!placer.has_place(crossings.sides[line.sides[shift]])) ++shift;
  const auto by = static_cast<std::ptrdiff_t>(shift);
  std::rotate(line.sides.begin(), line.sides.begin() + by, line.sides.end());
  std::rotate(line.faces.begin(), line.faces.begin() + by, line.faces.end());
}

Contour place_line(const QuadraticMesh& mesh, const Crossings& crossings, const Placer& placer,
                   Line line) {
  start_at_place(crossings, placer, line);
  Contour contour{line.closed, {}};
  std::vector<Vec2> arc;
  Index from = line.sides[0];
  const std::size_t steps = line.faces.size();
  for (std::size_t i = 0; i < steps; ++i) {
    const Index face = line.faces[i];
    const Index to = line.sides[(i + 1) % line.sides.size()];
    if (!placer.has_place(crossings.sides[to])) continue;
    const Vec2 p = placer.place(crossings.sides[from], face);
    const Vec2 q = placer.place(crossings.sides[to], face);
    contour.points.push_back(placer.world(p, face));
    if (!mesh.linear()) {
      arc.clear();
      sample_arc(placer.function(face), placer.level(), p, q, kArcDepth, arc);
      for (const Vec2& x : arc) contour.points.push_back(placer.world(x, face));
    }
    if (i + 1 == steps && !line.closed) contour.points.push_back(placer.world(q, face));
    from = to;
  }
  return contour;
}

}  // namespace

Rational exact_node_value(const QuadraticMesh& mesh, const TileComplex& tiles, Index node) {
  const auto& values = mesh.values();
  if (node < tiles.vertex_count) return values[node];
  const auto lines = static_cast<Index>(tiles.critical_edges.size());
  if (node < tiles.vertex_count + lines) {
    const Index edge = tiles.critical_edges[node - tiles.vertex_count];
    const Rational a = values[mesh.edges()[edge].v0], b = values[mesh.edges()[edge].v1];
    const Rational m = mesh.edge_values()[edge];
    const Rational da = 4 * m - 3 * a - b, db = 3 * b + a - 4 * m;
    return a + da * da / (2 * (da - db));
  }
  const Index face = tiles.critical_faces[node - tiles.vertex_count - lines];
  return ExactFace(mesh, face).centre_value();
}

Index nodes_below(const QuadraticMesh& mesh, const TileComplex& tiles, double level) {
  const Rational exact = level;
  const auto at = std::partition_point(tiles.order.begin(), tiles.order.end(), [&](Index node) {
    return exact_node_value(mesh, tiles, node) < exact;
  });
  return static_cast<Index>(at - tiles.order.begin());
}

std::vector<Contour> contours(const QuadraticMesh& mesh, const TileComplex& tiles, double level) {
  const Crossings crossings = find_crossings(mesh, tiles, nodes_below(mesh, tiles, level));
  const Placer placer(mesh, tiles, level);
  std::vector<Contour> result;
  for (Line& line : chain(crossings))
    result.push_back(place_line(mesh, crossings, placer, std::move(line)));
  return result;
}

}  // namespace crest::reeb
