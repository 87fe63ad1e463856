// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/feature_lines/sharp_edges.hpp"

#include <algorithm>
#include <cmath>

#include "kernel/geometry/coordinate_range.hpp"

namespace crest::feature_lines {
namespace {

using kernel::cross;
using kernel::dot;
using kernel::Edge;
using kernel::TriangleMesh;
using kernel::Vec3;
using kernel::operator+;
using kernel::operator-;
using kernel::operator*;

Index third_corner(const kernel::Triangle& face, const Edge& e) {
  for (const Index v : face)
    if (v != e.v0 && v != e.v1) return v;
  return kNone;
}

bool inner(const Edge& e) {
  return e.f0 != kNone && e.f1 != kNone;
}

void mark_sharp(const TriangleMesh& mesh, const kernel::DecimalAngle& angle, SharpLines& lines) {
  lines.sharp.assign(mesh.edge_count(), 0);
  const auto& p = mesh.points();
  for (Index i = 0; i < mesh.edge_count(); ++i) {
    const Edge& e = mesh.edges()[i];
    if (!inner(e)) continue;
    const kernel::Decision decision =
        kernel::dihedral_angle({p[e.v0], p[e.v1], p[third_corner(mesh.faces()[e.f0], e)],
                                p[third_corner(mesh.faces()[e.f1], e)]},
                               angle);
    lines.decided.add(decision.stage);
    lines.sharp[i] = decision.sign == kernel::Sign::positive;
    lines.ties += decision.sign == kernel::Sign::zero;
  }
}

/// The mesh edge between two neighbours.
Index edge_between(const TriangleMesh& mesh, Index v, Index w) {
  const std::pair<Index, Index> ends = std::minmax(v, w);
  const auto& edges = mesh.edges();
  const auto at =
      std::lower_bound(edges.begin(), edges.end(), ends,
                       [](const Edge& e, const auto& to) { return std::pair(e.v0, e.v1) < to; });
  return static_cast<Index>(at - edges.begin());
}

/// Takes the edges of short lines with an open end away; returns how many lines.
Index prune(const TriangleMesh& mesh, const FeatureGraph& graph, Index longest, Marks& edges) {
  Index pruned = 0;
  for (const FeatureLine& line : graph.lines) {
    if (line.kind != LineKind::branch && line.kind != LineKind::isolated) continue;
    const bool at_node = line.kind == LineKind::branch && line.nodes != std::array{kNone, kNone};
    if (line.vertices.size() - (at_node ? 1 : 0) > longest) continue;
    ++pruned;
    for (std::size_t i = 0; i + 1 < line.vertices.size(); ++i)
      edges[edge_between(mesh, line.vertices[i], line.vertices[i + 1])] = 0;
  }
  return pruned;
}

/// The area vectors, twice as long.
std::vector<Vec3> face_normals(const TriangleMesh& mesh) {
  std::vector<Vec3> normals;
  for (const auto& [a, b, c] : mesh.faces()) {
    const Vec3& p = mesh.points()[a];
    normals.push_back(cross(mesh.points()[b] - p, mesh.points()[c] - p));
  }
  return normals;
}

/// In degrees; from the sum and difference of unit vectors, well-conditioned everywhere.
double angle_between(Vec3 m, Vec3 n) {
  const double length = kernel::norm(m), other = kernel::norm(n);
  if (!(length > 0 && other > 0)) return 0;
  m = 1 / length * m;
  n = 1 / other * n;
  return 2 * std::atan2(kernel::norm(m - n), kernel::norm(m + n)) * (180 / 3.14159265358979323846);
}

/// Collects the faces around edges.
class RingFaces {
 public:
  explicit RingFaces(const TriangleMesh& mesh)
      : mesh_(mesh),
        seen_vertex_(mesh.vertex_count(), kNone),
        seen_face_(mesh.face_count(), kNone) {}

  /// The faces with a corner at most rings - 1 edges from an end of edge i.
  const std::vector<Index>& around(Index i, Index rings) {
    const Edge& e = mesh_.edges()[i];
    faces_.clear();
    vertices_ = {e.v0, e.v1};
    seen_vertex_[e.v0] = seen_vertex_[e.v1] = i;
    for (std::size_t begin = 0; rings-- > 0;) {
      const std::size_t end = vertices_.size();
      for (; begin < end; ++begin) add(vertices_[begin], i, rings > 0);
    }
    return faces_;
  }

 private:
  void add(Index v, Index i, bool further) {
    for (const Index f : mesh_.fan(v)) {
      if (seen_face_[f] == i) continue;
      seen_face_[f] = i;
      faces_.push_back(f);
    }
    if (!further) return;
    for (const Index w : mesh_.ring(v)) {
      if (seen_vertex_[w] == i) continue;
      seen_vertex_[w] = i;
      vertices_.push_back(w);
    }
  }

  const TriangleMesh& mesh_;
  std::vector<Index> seen_vertex_, seen_face_;  ///< the last edge that met them
  std::vector<Index> vertices_, faces_;
};

}  // namespace

SharpLines extract_sharp_lines(const TriangleMesh& mesh, const kernel::DecimalAngle& angle,
                               const SharpOptions& options) {
  kernel::require_carried(mesh.points());
  SharpLines lines;
  mark_sharp(mesh, angle, lines);
  lines.edges = lines.sharp;
  lines.graph = build_edge_graph(mesh, lines.edges);
  if (options.prune > 0) {
    lines.pruned = prune(mesh, lines.graph, options.prune, lines.edges);
    if (lines.pruned > 0) lines.graph = build_edge_graph(mesh, lines.edges);
  }
  if (options.close_branches > 0) {
    const auto paths = joining_paths(mesh, lines.graph, {1, options.close_branches});
    for (const auto& path : paths)
      for (std::size_t i = 0; i + 1 < path.size(); ++i)
        lines.edges[edge_between(mesh, path[i], path[i + 1])] = 1;
    lines.joined = static_cast<Index>(paths.size());
    if (lines.joined > 0) lines.graph = build_edge_graph(mesh, lines.edges);
  }
  return lines;
}

std::vector<double> vertex_angles(const TriangleMesh& mesh, Index rings) {
  const std::vector<Vec3> normals = face_normals(mesh);
  const auto& p = mesh.points();
  std::vector<double> angles(mesh.vertex_count(), 0);
  RingFaces faces(mesh);
  for (Index i = 0; i < mesh.edge_count(); ++i) {
    const Edge& e = mesh.edges()[i];
    if (!inner(e)) continue;
    std::array<Vec3, 2> sides = {normals[e.f0], normals[e.f1]};
    if (rings > 0) {
      const auto& around = faces.around(i, rings);
      Vec3 sum{};
      for (const Index f : around) sum = sum + normals[f];
      // f0 is to the left of the way from v0 to v1.
      const Vec3 left = cross(sum, p[e.v1] - p[e.v0]), middle = 0.5 * (p[e.v0] + p[e.v1]);
      sides = {};
      for (const Index f : around) {
        const auto& [a, b, c] = mesh.faces()[f];
        const double side = dot(left, 1.0 / 3 * (p[a] + p[b] + p[c]) - middle);
        if (side != 0) sides[side > 0 ? 0 : 1] = sides[side > 0 ? 0 : 1] + normals[f];
      }
    }
    const double angle = angle_between(sides[0], sides[1]);
    for (const Index v : {e.v0, e.v1}) angles[v] = std::max(angles[v], angle);
  }
  return angles;
}

}  // namespace crest::feature_lines
