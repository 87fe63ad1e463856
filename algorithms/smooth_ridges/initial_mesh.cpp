// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/smooth_ridges/initial_mesh.hpp"

#include <algorithm>
#include <cstdio>
#include <map>
#include <set>
#include <utility>

#include "algorithms/smooth_ridges/surface_net.hpp"

namespace crest::smooth_ridges {

std::string text(const Vec3& p) {
  char line[96];
  std::snprintf(line, sizeof line, "(%.6g, %.6g, %.6g)", p[0], p[1], p[2]);
  return line;
}

namespace {

std::string box_text(const Surface::Box& b) {
  char line[192];
  std::snprintf(line, sizeof line, "[%.6g, %.6g] x [%.6g, %.6g] x [%.6g, %.6g]", b[0], b[1], b[2],
                b[3], b[4], b[5]);
  return line;
}

using Edge = std::pair<Index, Index>;
Edge edge(Index a, Index b) {
  return {std::min(a, b), std::max(a, b)};
}

/// Ends of edges that are not between two faces, once in each direction.
std::set<Index> ends_of_spoiled_edges(const std::vector<Triangle>& faces) {
  std::map<Edge, std::array<int, 2>> uses;
  for (const Triangle& f : faces)
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = f[k], b = f[(k + 1) % 3];
      ++uses[edge(a, b)][a < b ? 0 : 1];
    }
  std::set<Index> ends;
  for (const auto& [e, use] : uses)
    if (use != std::array{1, 1}) ends.insert({e.first, e.second});
  return ends;
}

std::size_t corner_of(const Triangle& f, Index v) {
  return f[0] == v ? 0 : f[1] == v ? 1 : 2;
}

/// Vertices whose faces are not one closed fan.
std::set<Index> spoiled_fans(const std::vector<Triangle>& faces,
                             const std::vector<std::array<Index, 3>>& neighbours,
                             std::size_t vertices) {
  std::vector<Index> faces_at(vertices, 0), first(vertices, kNone);
  for (Index f = 0; f < faces.size(); ++f)
    for (const Index v : faces[f]) {
      ++faces_at[v];
      first[v] = f;
    }
  std::set<Index> spoiled;
  for (Index v = 0; v < vertices; ++v) {
    Index walked = 0, f = first[v];
    do {
      f = neighbours[f][corner_of(faces[f], v)];
      ++walked;
    } while (f != first[v] && walked <= faces_at[v]);
    if (walked != faces_at[v] || walked < 3) spoiled.insert(v);
  }
  return spoiled;
}

/// A closed mesh whose vertices are moved along the surface and whose edges are flipped.
class Workpiece {
 public:
  Workpiece(Projection& f, SurfaceNet net)
      : f_(f),
        points_(std::move(net.points)),
        cells_(std::move(net.cells)),
        faces_(std::move(net.faces)) {}

  /// Gives the places where the mesh is no manifold, or does not follow the surface: none if it is
  /// good.
  std::vector<FineSpot> improve() {
    constexpr int kRounds = 3;
    bad_ = ends_of_spoiled_edges(faces_);
    if (!bad_.empty()) return spots();
    neighbours_ = pair_edges(faces_);
    bad_ = spoiled_fans(faces_, neighbours_, points_.size());
    if (!bad_.empty()) return spots();
    if (!project_all()) return spots();
    for (int round = 0; round < kRounds; ++round) {
      if (!relax() || !relax()) return spots();
      flip_all();
    }
    find_wrong_normals();
    return spots();
  }
  /// A vertex is near p, on the same side of the surface.
  bool has_vertex_near(const Vec3& p) const {
    const Vertex seed = f_.vertex(p);
    for (std::size_t v = 0; v < vertices_.size(); ++v)
      if (norm(position(vertices_[v]) - p) < 1.5 * cells_[v] &&
          dot(normal(vertices_[v]), normal(seed)) > 0.5)
        return true;
    return false;
  }
  const std::vector<Triangle>& faces() const { return faces_; }
  const std::vector<Vertex>& vertices() const { return vertices_; }

 private:
  /// Where half as large cells may help: at the bad vertices.
  std::vector<FineSpot> spots() const {
    std::vector<FineSpot> all;
    for (const Index v : bad_) all.push_back({points_[v], cells_[v] / 2});
    return all;
  }

  bool project_all() {
    vertices_.resize(points_.size());
    for (Index v = 0; v < points_.size(); ++v) {
      const auto x = f_.onto(points_[v], 2 * cells_[v]);
      if (x) vertices_[v] = f_.vertex(*x);
      if (x && std::isfinite(vertices_[v][3]))
        points_[v] = *x;
      else
        bad_.insert(v);
    }
    return bad_.empty();
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
    const std::size_t j = corner_of(faces_[g], b);
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
    neighbours_[ad][corner_of(faces_[ad], d)] = f;
    neighbours_[bc][corner_of(faces_[bc], c)] = g;
    edges.erase(edge(a, b));
    edges.insert(edge(c, d));
    --degree_[a], --degree_[b], ++degree_[c], ++degree_[d];
    return true;
  }

  void find_wrong_normals() {
    for (const Triangle& f : faces_)
      if (!(agreement(f[0], f[1], f[2]) > 0.5)) bad_.insert(f.begin(), f.end());
  }

  Projection& f_;
  std::vector<Vec3> points_;
  std::vector<double> cells_;  ///< sides
  std::vector<Vertex> vertices_;
  std::vector<Triangle> faces_;
  std::vector<std::array<Index, 3>> neighbours_;
  std::vector<int> degree_;
  std::set<Index> bad_;  ///< vertices
};

SurfaceNet checked_net(Projection& f, const Surface::Box& box, const Grid& grid,
                       const std::vector<FineSpot>& spots) {
  SurfaceNet net = surface_net(f, box, grid, spots);
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

/// Asks for smaller cells, half as large each time, at the points that no vertex is near to.
void ask_for(const std::vector<FineSpot>& points, const Workpiece& work, double cell,
             const std::vector<FineSpot>& spots, std::vector<FineSpot>& wanted) {
  for (const FineSpot& p : points) {
    if (work.has_vertex_near(p.place)) continue;
    double size = (p.size > 0 ? std::min(p.size, cell) : cell) / 2;
    for (const FineSpot& s : spots)
      if (s.place == p.place) size = std::min(size, s.size / 2);
    wanted.push_back({p.place, size});
  }
}

class NetMesher {
 public:
  NetMesher(const Surface& surface, int target, const StartPoints& points, const Stop& stop)
      : surface_(surface), target_(target), points_(points), stop_(stop), f_(surface) {}

  Triangulation run() {
    constexpr double kLargestGrid = 0x1p25, kSmallest = 0x1p-18;
    constexpr std::size_t kTries = 30, kMostSpots = 20000;
    bound();
    const double least = kSmallest * cell_;
    std::vector<FineSpot> spots = points_.fine, bad;
    for (std::size_t i = 0; i < kTries && spots.size() < kMostSpots; ++i) {
      const Grid grid = generic_grid(used_.low, used_.high, cell_);
      if (static_cast<double>(grid.size()) > kLargestGrid) break;
      if (is_over(stop_))
        throw MeshError(MeshError::Reason::stopped,
                        "stopped while the first triangulation was made");
      SurfaceNet net = checked_net(f_, surface_.box(), grid, spots);
      const std::size_t vertices = net.points.size();
      Workpiece work(f_, std::move(net));
      bad = work.improve();
      if (vertices == 0 || 4 * bad.size() > vertices) {  // too coarse nearly everywhere
        cell_ *= 0.7;
        if (vertices > 0 || points_.known.empty()) continue;
      }
      if (bad.empty()) ask_for(points_.known, work, cell_, spots, bad);
      if (bad.empty()) return {work.vertices(), work.faces(), {}, edge_rules(surface_)};
      spots.insert(spots.end(), bad.begin(), bad.end());
      if (std::any_of(bad.begin(), bad.end(), [&](const FineSpot& s) { return s.size < least; }))
        break;
    }
    throw MeshError(MeshError::Reason::rough, refusal(bad));
  }

 private:
  /// The part of the box that the surface needs, and how large cells are to be.
  void bound() {
    constexpr double kFirstCells = 44;
    const Extent all = extent_of(surface_.box());
    cell_ = all.size() / kFirstCells;
    const SurfaceNet first =
        checked_net(f_, surface_.box(), generic_grid(all.low, all.high, cell_), {});
    if (first.faces.empty() && points_.known.empty())
      throw MeshError(MeshError::Reason::empty,
                      "the expression has no zero in the box " + box_text(surface_.box()));
    if (!first.faces.empty()) used_.add(first.low), used_.add(first.high);
    for (const FineSpot& p : points_.known) used_.add(along_generic_axes(p.place));
    for (std::size_t k = 0; k < 3; ++k) used_.low[k] -= 1.5 * cell_, used_.high[k] += 1.5 * cell_;
    cell_ *=
        first.faces.empty() ? 0.25 : std::sqrt(static_cast<double>(first.faces.size()) / target_);
  }

  static std::string refusal(const std::vector<FineSpot>& bad) {
    const auto least = std::min_element(
        bad.begin(), bad.end(), [](const auto& a, const auto& b) { return a.size < b.size; });
    if (least == bad.end()) return "no grid resolves the surface: is it very thin?";
    char size[32];
    std::snprintf(size, sizeof size, "%.3g", least->size);
    return std::string("no grid down to cells of ") + size + " resolves the surface near " +
           text(least->place) + ": is it singular, or very thin?";
  }

  const Surface& surface_;
  const int target_;
  const StartPoints& points_;
  const Stop& stop_;
  Projection f_;
  Extent used_;
  double cell_ = 0;
};

}  // namespace

Triangulation initial_mesh(const Surface& surface, int target, const StartPoints& points,
                           const Stop& stop) {
  if (target < 8 || target > 10000000)
    throw std::invalid_argument("the number of triangles to start with must be from 8 to 10^7");
  return surface.is_implicit() ? NetMesher(surface, target, points, stop).run()
                               : grid_mesh(surface, target);
}

}  // namespace crest::smooth_ridges
