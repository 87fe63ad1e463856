// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/modes/positions.hpp"

#include <algorithm>
#include <map>

#include "certify/container/reject.hpp"
#include "certify/exact/filtered.hpp"
#include "certify/modes/polygons.hpp"
#include "certify/modes/root_places.hpp"
#include "certify/surface/union_find.hpp"

namespace crest::certify::modes {
namespace {

using kernel::Rational;

template <class Number, class Convert>
auto orientation(const std::array<std::array<double, 3>, 4>& p, const Convert& number) {
  std::array<std::array<decltype(number(0.0) - number(0.0)), 3>, 3> d;
  for (unsigned i = 0; i < 3; ++i)
    for (unsigned k = 0; k < 3; ++k) d[i][k] = number(p[i + 1][k]) - number(p[0][k]);
  return d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) -
         d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) +
         d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
}

int orientation(const std::array<std::array<double, 3>, 4>& p) {
  const auto near = orientation<double>(p, [](double x) { return filtered(x); });
  if (const auto sign = certain_sign(near)) return static_cast<int>(*sign);
  const auto exact = orientation<Rational>(p, [](double x) { return Rational(x); });
  return exact > 0 ? 1 : exact < 0 ? -1 : 0;
}

}  // namespace

bool is_embedded(const ModesCertificate& c, const Domain& domain) {
  auto tets = c.tets;
  std::vector<std::int8_t> signs;
  for (auto& t : tets) {
    std::ranges::sort(t);
    const int sign = orientation({c.points[t[0]], c.points[t[1]], c.points[t[2]], c.points[t[3]]});
    if (sign == 0) return false;
    signs.push_back(static_cast<std::int8_t>(sign));
  }
  // The side of a face, corners ascending, on which the tetrahedron's other corner is.
  const auto side = [&](const TetFace& face, u32 t) {
    unsigned apart = 3;
    while (apart > 0 && tets[t][apart] == face.corners[apart - 1]) --apart;
    return apart % 2 == 1 ? signs[t] : -signs[t];
  };
  const auto on_two_sides = [&](const TetFace& face) {
    return face.tets[1] == kNone || side(face, face.tets[0]) != side(face, face.tets[1]);
  };
  // Zeros have no positions: of the tetrahedra as they are given.
  if (c.zeros.empty()) return std::ranges::all_of(domain.faces, on_two_sides);
  return std::ranges::all_of(list_faces(tets, c.points.size()), on_two_sides);
}

Positions::Positions(const LevelContext& context) : context_(context) {
  const ModeLevel& level = context.stated;
  if (level.root_places.empty() && level.arc_points.empty() && level.points.empty()) {
    require(level.placed == 0 && level.not_placed == 0, "positions: pieces without any");
    require(level.inner.empty() && level.near == 0, "positions: vertices without any");
    return;
  }
  first_point_.push_back(0);
  for (const auto count : level.arc_points) first_point_.push_back(first_point_.back() + count);
  require(level.root_places.size() == level.roots.size() &&
              level.arc_points.size() == level.arcs.size() &&
              level.points.size() == first_point_.back(),
          "positions: not one a root, an arc, a point");
  for (const EdgeNode& edge : context.trees.edges) {
    double last = 0;
    for (u32 i = edge.root; i < edge.root + edge.roots; ++i) {
      const auto& [low, high, sign] = level.roots[i];
      const double place = level.root_places[i];
      require(last < place && place < 1 && (low == high || (low <= place && place <= high)),
              "edge ({}, {}): a root's place {}", edge.first, edge.second, place);
      last = place;
    }
  }
  for (const auto& [a, b] : level.points)
    require(a > 0 && b > 0 && a + b < 1, "positions: a point that is not inside its face");
}

namespace {

/// More are not looked at: their pairs may all be close.
constexpr std::size_t kMostVertices = 1024;

template <class Number>
using Weights = std::array<Number, 4>;

template <class Number>
Weights<Number> between(const Weights<Number>& a, const Weights<Number>& b, const Number& t) {
  Weights<Number> c;
  for (unsigned i = 0; i < 4; ++i) c[i] = a[i] + t * (b[i] - a[i]);
  return c;
}

/// An arc with its points, roots at both ends.
template <class Number>
struct Polyline {
  u32 first, second;
  std::vector<Weights<Number>> points;
};

/// The polylines of one level on faces, in the barycentrics of a simplex. Doubles are wrong by at
/// most 2 kPlaceError: a level of splits adds 3 u to corners and to places on edges.
template <class Number>
class PolylineList {
 public:
  PolylineList(const LevelContext& context, const std::vector<std::size_t>& first_point, int level)
      : context_(context), first_point_(first_point), level_(level) {}

  void add(u32 face, const std::array<Weights<Number>, 3>& corners) {
    const FaceNode& node = context_.trees.faces[face];
    if (node.leaf()) return add_leaf(node, corners);
    const unsigned k = node.code, next = (k + 1) % 3;
    const EdgeNode& edge = context_.trees.edges[node.edges[k].node];
    const unsigned n = context_.field.parts(context_.trees.edges[edge.other].first).n;
    auto near = corners, far = corners;
    near[next] = far[k] =
        between(corners[k], corners[next], Number((node.edges[k].reversed ? 64 - n : n) / 64.0));
    add(node.near, near);
    add(node.far, far);
  }

  std::vector<Polyline<Number>> list;

 private:
  void add_leaf(const FaceNode& face, const std::array<Weights<Number>, 3>& corners) {
    if (face.arcs == 0) return;
    const ModeLevel& stated = context_.stated;
    const auto roots = list_roots<Number>(context_, face);
    const auto place = [&](unsigned i) {
      const auto& root = roots[i];
      return between(corners[root.edge], corners[(root.edge + 1) % 3],
                     root.place(stated.root_places[root.root]));
    };
    for (u32 arc = face.arc; arc < face.arc + face.arcs; ++arc) {
      const auto [first, second] = stated.arcs[arc];
      if (stated.roots[roots[first].root].level != level_) continue;
      Polyline<Number> line = {roots[first].root, roots[second].root, {place(first)}};
      // Along a side: a segment without length, so not simple.
      if (first_point_[arc] == first_point_[arc + 1] && roots[first].edge == roots[second].edge)
        line.points.push_back(line.points.front());
      for (std::size_t i = first_point_[arc]; i < first_point_[arc + 1]; ++i) {
        const Number a(stated.points[i][0]), b(stated.points[i][1]), c(1 - a - b);
        Weights<Number> p;
        for (unsigned k = 0; k < 4; ++k)
          p[k] = a * corners[0][k] + b * corners[1][k] + c * corners[2][k];
        line.points.push_back(p);
      }
      line.points.push_back(place(second));
      list.push_back(std::move(line));
    }
  }

  const LevelContext& context_;
  const std::vector<std::size_t>& first_point_;
  int level_;
};

/// What is constant along w, in the barycentrics of a cell.
struct Projection {
  std::array<unsigned, 3> of = {2, 0, 1};  ///< coordinates: the one that is eliminated, two others
  std::array<std::int32_t, 3> w = {1, 0, 0};

  Projection() = default;
  explicit Projection(const Direction<4>& direction) {
    unsigned most = 0;
    for (unsigned i = 1; i < 4; ++i)
      if (std::abs(direction[i]) > std::abs(direction[most])) most = i;
    of = {most, most == 0 ? 1U : 0U, most <= 1 ? 2U : 1U};
    for (unsigned i = 0; i < 3; ++i) w[i] = direction[of[i]];
  }

  template <class Number>
  Planar<Number> operator()(const Weights<Number>& b) const {
    return {w[0] * b[of[1]] - w[1] * b[of[0]], w[0] * b[of[2]] - w[2] * b[of[0]]};
  }
  /// Of coordinates that come from doubles wrong by 2 kPlaceError.
  double error() const { return widened(2 * std::abs(w[0]) * (2 * kPlaceError + 4 * kUnit)); }
};

/// Polylines in the plane: points, a number for each root and each inner point.
template <class Number>
std::vector<Planar<Number>> projected(const std::vector<Polyline<Number>>& list,
                                      const Projection& projection,
                                      std::vector<std::vector<u32>>* paths = nullptr) {
  std::vector<Planar<Number>> points;
  std::map<u32, u32> vertex_of;
  for (const auto& line : list) {
    std::vector<u32> path;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      auto at = static_cast<u32>(points.size());
      if (i == 0 || i + 1 == line.points.size())
        at = vertex_of.try_emplace(i == 0 ? line.first : line.second, at).first->second;
      if (at == points.size()) points.push_back(projection(line.points[i]));
      path.push_back(at);
    }
    if (paths) paths->push_back(std::move(path));
  }
  return points;
}

/// Paths joined to polygons. Requires: each end is one of two paths.
std::vector<std::vector<u32>> join(std::vector<std::vector<u32>> paths) {
  std::map<u32, std::vector<std::size_t>> at;
  for (std::size_t i = 0; i < paths.size(); ++i)
    for (const u32 end : {paths[i].front(), paths[i].back()}) at[end].push_back(i);
  std::vector<std::uint8_t> used(paths.size(), 0);
  std::vector<std::vector<u32>> polygons;
  for (std::size_t start = 0; start < paths.size(); ++start) {
    if (used[start] != 0) continue;
    std::vector<u32> polygon;
    std::size_t path = start;
    u32 from = paths[start].front();
    while (used[path] == 0) {
      used[path] = 1;
      if (paths[path].front() != from) std::ranges::reverse(paths[path]);
      polygon.insert(polygon.end(), paths[path].begin(), paths[path].end() - 1);
      from = paths[path].back();
      const auto& both = at[from];
      path = both[0] == path ? both[1] : both[0];
    }
    polygons.push_back(std::move(polygon));
  }
  return polygons;
}

/// Disks: none holds another. One piece: one polygon holds the others, which hold none.
bool are_nested(const PlanarPoints& points, const std::vector<std::vector<u32>>& polygons,
                bool disks) {
  std::size_t outer = 0;
  for (const auto& polygon : polygons) {
    const auto inside = std::ranges::count_if(polygons, [&](const auto& other) {
      return &other != &polygon && holds(points, polygon, other[0]);
    });
    if (inside == 0) continue;
    if (disks || inside + 1 != std::ssize(polygons)) return false;
    ++outer;
  }
  return disks || outer == 1;
}

std::vector<Segment> segments(const std::vector<std::vector<u32>>& paths) {
  std::vector<Segment> list;
  for (const auto& path : paths)
    for (std::size_t i = 0; i + 1 < path.size(); ++i) list.push_back({path[i], path[i + 1]});
  return list;
}

template <class Number>
Weights<Number> corner(unsigned i) {
  Weights<Number> b{};
  b[i] = 1;
  return b;
}

template <class Number>
std::vector<Polyline<Number>> of_cell(const LevelContext& context,
                                      const std::vector<std::size_t>& first_point, const Cell& cell,
                                      int level) {
  PolylineList<Number> lines(context, first_point, level);
  for (unsigned i = 0; i < 4; ++i) {
    const FaceNode& facet = context.trees.faces[cell.facets[i]];
    std::array<Weights<Number>, 3> corners;
    for (unsigned k = 0; k < 3; ++k)
      corners[k] = corner<Number>(static_cast<unsigned>(
          std::ranges::find(cell.corners, facet.corners[k]) - cell.corners.begin()));
    lines.add(cell.facets[i], corners);
  }
  return std::move(lines.list);
}

template <class Number>
std::vector<Polyline<Number>> of_face(const LevelContext& context,
                                      const std::vector<std::size_t>& first_point, u32 face,
                                      int level) {
  PolylineList<Number> lines(context, first_point, level);
  lines.add(face, {corner<Number>(0), corner<Number>(1), corner<Number>(2)});
  return std::move(lines.list);
}

}  // namespace

PlacedPieces Positions::place_cell(const Cell& cell, const CellPieces& pieces) const {
  const auto& v = context_.stated.tet_witnesses[cell.witness].w;
  const Projection projection(Direction<4>{v[0], v[1], v[2], -(v[0] + v[1] + v[2])});
  PlacedPieces found;
  for (const int level : {1, -1}) {
    const auto count = static_cast<std::size_t>(std::ranges::count(pieces.levels, level));
    if (count == 0) continue;
    std::vector<std::vector<u32>> paths;
    auto near = projected(of_cell<double>(context_, first_point_, cell, level), projection, &paths);
    bool good = near.size() <= kMostVertices;
    if (good) {
      const PlanarPoints points(std::move(near), projection.error(), [&] {
        return projected(of_cell<Rational>(context_, first_point_, cell, level), projection);
      });
      good = are_simple(points, segments(paths));
      if (good) {
        const auto polygons = join(std::move(paths));
        good = are_nested(points, polygons, count == polygons.size());
      }
    }
    (good ? found.placed : found.not_placed) += static_cast<u32>(count);
  }
  return found;
}

PlacedPieces Positions::place_cones(u32 face) const {
  const Projection projection;
  PlacedPieces found;
  for (const int level : {1, -1}) {
    std::vector<std::vector<u32>> paths;
    auto near = projected(of_face<double>(context_, first_point_, face, level), projection, &paths);
    UnionFind curves(near.size());
    for (const auto& path : paths) curves.join(path.front(), path.back());
    std::vector<u32> names;
    for (const auto& path : paths) names.push_back(curves.find(path.front()));
    std::ranges::sort(names);
    names.erase(std::unique(names.begin(), names.end()), names.end());
    bool good = near.size() <= kMostVertices;
    if (good) {
      const PlanarPoints points(std::move(near), projection.error(), [&] {
        return projected(of_face<Rational>(context_, first_point_, face, level), projection);
      });
      good = are_simple(points, segments(paths));
    }
    (good ? found.placed : found.not_placed) += static_cast<u32>(names.size());
  }
  return found;
}

}  // namespace crest::certify::modes
