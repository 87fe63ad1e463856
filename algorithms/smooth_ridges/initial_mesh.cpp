// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/smooth_ridges/initial_mesh.hpp"

#include <algorithm>
#include <cstdio>
#include <set>
#include <utility>

#include "algorithms/smooth_ridges/surface_net.hpp"

namespace crest::smooth_ridges {
namespace {

std::string text(const Vec3& p) {
  char line[96];
  std::snprintf(line, sizeof line, "(%.6g, %.6g, %.6g)", p[0], p[1], p[2]);
  return line;
}

std::string text(const Surface::Box& b) {
  char line[192];
  std::snprintf(line, sizeof line, "[%.6g, %.6g] x [%.6g, %.6g] x [%.6g, %.6g]", b[0], b[1], b[2],
                b[3], b[4], b[5]);
  return line;
}

/// A closed mesh whose vertices are moved along the surface and whose edges are flipped.
class Workpiece {
 public:
  Workpiece(Projection& f, SurfaceNet net, double cell)
      : f_(f), points_(std::move(net.points)), faces_(std::move(net.faces)), cell_(cell) {}

  /// False if the mesh is no manifold, or does not follow the surface.
  bool improve() {
    constexpr int kRounds = 3;
    try {
      neighbours_ = pair_edges(faces_);
    } catch (const std::invalid_argument&) {
      return false;
    }
    if (!every_vertex_has_one_fan() || !project_all()) return false;
    for (int round = 0; round < kRounds; ++round) {
      if (!relax() || !relax()) return false;
      flip_all();
    }
    return normals_agree();
  }
  /// A vertex is near p, on the same side of the surface.
  bool has_vertex_near(const Vec3& p) const {
    const Vertex seed = f_.vertex(p);
    return std::any_of(vertices_.begin(), vertices_.end(), [&](const Vertex& v) {
      return norm(position(v) - p) < 1.5 * cell_ && dot(normal(v), normal(seed)) > 0.5;
    });
  }
  const std::vector<Triangle>& faces() const { return faces_; }
  const std::vector<Vertex>& vertices() const { return vertices_; }

 private:
  bool every_vertex_has_one_fan() const {
    std::vector<Index> faces_at(points_.size(), 0), first(points_.size(), kNone);
    for (Index f = 0; f < faces_.size(); ++f)
      for (const Index v : faces_[f]) {
        ++faces_at[v];
        first[v] = f;
      }
    for (Index v = 0; v < points_.size(); ++v) {
      Index walked = 0, f = first[v];
      do {
        const std::size_t k = corner_of(f, v);
        f = neighbours_[f][k];
        if (f == kNone) return false;
        ++walked;
      } while (f != first[v] && walked <= faces_at[v]);
      if (walked != faces_at[v] || walked < 3) return false;
    }
    return true;
  }
  std::size_t corner_of(Index f, Index v) const {
    return faces_[f][0] == v ? 0 : faces_[f][1] == v ? 1 : 2;
  }

  bool project_all() {
    vertices_.resize(points_.size());
    for (std::size_t v = 0; v < points_.size(); ++v) {
      const auto x = f_.onto(points_[v], 2 * cell_);
      if (!x) return false;
      points_[v] = *x;
      vertices_[v] = f_.vertex(*x);
      if (!std::isfinite(vertices_[v][3])) return false;
    }
    return true;
  }

  /// Halfway to the mean of the neighbours, along the tangent plane.
  bool relax() {
    std::vector<Vec3> sum(points_.size(), Vec3{});
    std::vector<double> count(points_.size(), 0);
    for (const Triangle& f : faces_)
      for (std::size_t k = 0; k < 3; ++k) {
        // In a closed mesh every neighbour follows the vertex in exactly one face.
        sum[f[k]] = sum[f[k]] + points_[f[(k + 1) % 3]];
        count[f[k]] += 1;
      }
    for (std::size_t v = 0; v < points_.size(); ++v) {
      const Vec3 n = normal(vertices_[v]);
      Vec3 move{};
      for (std::size_t k = 0; k < 3; ++k) move[k] = sum[v][k] / count[v] - points_[v][k];
      move = move - dot(move, n) * n;
      points_[v] = points_[v] + 0.5 * move;
    }
    return project_all();
  }

  using Edge = std::pair<Index, Index>;
  static Edge edge(Index a, Index b) { return {std::min(a, b), std::max(a, b)}; }

  void flip_all() {
    constexpr int kPasses = 4;
    std::set<Edge> edges;
    degree_.assign(points_.size(), 0);
    for (const Triangle& f : faces_)
      for (std::size_t k = 0; k < 3; ++k) {
        edges.insert(edge(f[k], f[(k + 1) % 3]));
        ++degree_[f[k]];
      }
    for (int pass = 0; pass < kPasses; ++pass) {
      bool changed = false;
      for (Index f = 0; f < faces_.size(); ++f)
        for (std::size_t k = 0; k < 3; ++k) changed |= flip(f, k, edges);
      if (!changed) return;
    }
  }

  /// The angle's cotangent at c in the triangle (a, b, c).
  double cotangent(Index a, Index b, Index c) const {
    const Vec3 p = points_[a] - points_[c], q = points_[b] - points_[c];
    return dot(p, q) / norm(cross(p, q));
  }
  /// The least cosine between the triangle's normal and those of its corners.
  double agreement(Index a, Index b, Index c) const {
    const Vec3 n = cross(points_[b] - points_[a], points_[c] - points_[a]);
    double least = 1;
    for (const Index v : {a, b, c}) least = std::min(least, dot(n, normal(vertices_[v])));
    return least / norm(n);
  }

  /// Turns the edge from corner k if the opposite angles exceed pi together.
  bool flip(Index f, std::size_t k, std::set<Edge>& edges) {
    const Index g = neighbours_[f][k];
    const Index a = faces_[f][k], b = faces_[f][(k + 1) % 3], c = faces_[f][(k + 2) % 3];
    const std::size_t j = corner_of(g, b);
    const Index d = faces_[g][(j + 2) % 3];
    if (!(cotangent(a, b, c) + cotangent(b, a, d) < -1e-3)) return false;
    if (degree_[a] <= 4 || degree_[b] <= 4 || edges.contains(edge(c, d))) return false;
    if (std::min(agreement(a, d, c), agreement(b, c, d)) < 0.5) return false;
    const Index bc = neighbours_[f][(k + 1) % 3], ca = neighbours_[f][(k + 2) % 3];
    const Index ad = neighbours_[g][(j + 1) % 3], db = neighbours_[g][(j + 2) % 3];
    faces_[f] = {a, d, c};
    faces_[g] = {b, c, d};
    neighbours_[f] = {ad, g, ca};
    neighbours_[g] = {bc, f, db};
    neighbours_[ad][corner_of(ad, d)] = f;
    neighbours_[bc][corner_of(bc, c)] = g;
    edges.erase(edge(a, b));
    edges.insert(edge(c, d));
    --degree_[a], --degree_[b], ++degree_[c], ++degree_[d];
    return true;
  }

  bool normals_agree() const {
    return std::all_of(faces_.begin(), faces_.end(),
                       [&](const Triangle& f) { return agreement(f[0], f[1], f[2]) > 0.5; });
  }

  Projection& f_;
  std::vector<Vec3> points_;
  std::vector<Vertex> vertices_;
  std::vector<Triangle> faces_;
  std::vector<std::array<Index, 3>> neighbours_;
  std::vector<int> degree_;
  double cell_;
};

SurfaceNet checked_net(Projection& f, const Surface::Box& box, const Grid& grid) {
  SurfaceNet net = surface_net(f, box, grid);
  if (net.on_boundary)
    throw MeshError(MeshError::Reason::boundary,
                    "the surface reaches the boundary of the box near " + text(*net.on_boundary) +
                        ": it is not closed inside");
  return net;
}

struct Extent {
  Vec3 low{HUGE_VAL, HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  void add(const Vec3& t) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], t[k]);
      high[k] = std::max(high[k], t[k]);
    }
  }
  double size() const { return std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]}); }
};

Extent extent_of(const Surface::Box& box) {
  Extent e;
  for (const double x : {box[0], box[1]})
    for (const double y : {box[2], box[3]})
      for (const double z : {box[4], box[5]}) e.add(along_generic_axes({x, y, z}));
  return e;
}

Triangulation net_mesh(const Surface& surface, int target, const std::vector<Vec3>& points) {
  constexpr double kFirstCells = 44, kLargestGrid = 0x1p25;
  constexpr int kTries = 14;
  Projection f(surface);
  Extent all = extent_of(surface.box());
  double cell = all.size() / kFirstCells;
  const SurfaceNet first = checked_net(f, surface.box(), generic_grid(all.low, all.high, cell));
  if (first.faces.empty() && points.empty())
    throw MeshError(MeshError::Reason::empty,
                    "the expression has no zero in the box " + text(surface.box()));
  Extent used;
  if (!first.faces.empty()) used.add(first.low), used.add(first.high);
  for (const Vec3& p : points) used.add(along_generic_axes(p));
  for (std::size_t k = 0; k < 3; ++k) used.low[k] -= 1.5 * cell, used.high[k] += 1.5 * cell;
  cell *= first.faces.empty() ? 0.25 : std::sqrt(static_cast<double>(first.faces.size()) / target);
  for (int i = 0; i < kTries; ++i, cell *= 0.7) {
    const Grid grid = generic_grid(used.low, used.high, cell);
    if (static_cast<double>(grid.size()) > kLargestGrid) break;
    SurfaceNet net = checked_net(f, surface.box(), grid);
    if (net.faces.empty()) continue;
    Workpiece work(f, std::move(net), cell);
    if (!work.improve()) continue;
    if (!std::all_of(points.begin(), points.end(),
                     [&](const Vec3& p) { return work.has_vertex_near(p); }))
      continue;
    return {work.vertices(), work.faces(), {}, edge_rules(surface)};
  }
  throw MeshError(MeshError::Reason::rough,
                  "no grid down to cells of " + std::to_string(cell) +
                      " resolves the surface: is it singular, or very thin?");
}

}  // namespace

Triangulation initial_mesh(const Surface& surface, int target, const std::vector<Vec3>& points) {
  if (target < 8 || target > 10000000)
    throw std::invalid_argument("the number of triangles to start with must be from 8 to 10^7");
  return surface.is_implicit() ? net_mesh(surface, target, points) : grid_mesh(surface, target);
}

}  // namespace crest::smooth_ridges
