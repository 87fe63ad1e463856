// SPDX-License-Identifier: GPL-3.0-or-later
// T(B) = sum over edges of beta(e) |e in B| e e^T / |B| (Cohen-Steiner and Morvan 2003), in the
// tangent plane, with its eigenvectors swapped: an edge bends across itself. B: the barycentric
// cells of v and of its neighbours up to a ring; a cell has half of each edge of its vertex and a
// third of each triangle, so that the cells share out the mesh without gap or overlap.
#include "algorithms/curvature/methods.hpp"
#include "algorithms/curvature/tangent.hpp"

namespace crest::curvature {
namespace {

/// Of a cell: xx, xy, xz, yy, yz, zz of the sum, and the area.
struct Moments {
  std::array<double, 6> sum{};
  double area = 0;
};

/// Signed dihedral angles, 0 on the boundary; negative at a convex edge as convex curvatures are.
std::vector<double> dihedral_angles(const kernel::TriangleMesh& mesh) {
  std::vector<Vec3> normals(mesh.face_count());
  const auto& p = mesh.points();
  for_each_index(mesh.face_count(), [&](Index f) {
    const auto& t = mesh.faces()[f];
    const Vec3 n = cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]);
    normals[f] = 1 / norm(n) * n;
  });
  std::vector<double> angles(mesh.edge_count(), 0.0);
  for_each_index(mesh.edge_count(), [&](Index i) {
    const kernel::Edge& e = mesh.edges()[i];
    if (e.f0 == kernel::kNone || e.f1 == kernel::kNone) return;
    const Vec3 along = p[e.v1] - p[e.v0];
    const double sine = dot(cross(normals[e.f0], normals[e.f1]), along);
    angles[i] = -std::atan2(sine, dot(normals[e.f0], normals[e.f1]) * norm(along));
  });
  return angles;
}

Moments cell_of(const kernel::TriangleMesh& mesh, const std::vector<double>& angles, Index v) {
  Moments m;
  const auto& p = mesh.points();
  for (const Index f : mesh.fan(v)) {
    const auto& t = mesh.faces()[f];
    const std::size_t k = t[0] == v ? 0 : t[1] == v ? 1 : 2;
    const Vec3 e = p[t[(k + 1) % 3]] - p[v];
    const Vec3 n = cross(e, p[t[(k + 2) % 3]] - p[v]);
    m.area += norm(n) / 6;
    const double weight = 0.5 * angles[mesh.face_edges()[f][k]] / norm(e);
    std::size_t at = 0;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = i; j < 3; ++j) m.sum[at++] += weight * e[i] * e[j];
  }
  return m;
}

}  // namespace

void normal_cycle(const kernel::TriangleMesh& mesh, const std::vector<Vec3>& normals, int rings,
                  std::vector<PointCurvature>& out, std::vector<VertexFlags>& flags) {
  const std::vector<double> angles = dihedral_angles(mesh);
  std::vector<Moments> cells(mesh.vertex_count());
  for_each_index(mesh.vertex_count(), [&](Index v) { cells[v] = cell_of(mesh, angles, v); });
  for_each_index(mesh.vertex_count(), [&](Index v) {
    thread_local std::vector<Index> region;
    collect_rings(mesh, v, rings, 0, region);
    Moments m;
    for (const Index w : region) {
      for (std::size_t i = 0; i < 6; ++i) m.sum[i] += cells[w].sum[i];
      m.area += cells[w].area;
    }
    const double s = 1 / m.area;
    const auto& q = m.sum;
    const Frame frame = frame_of(1 / norm(normals[v]) * normals[v]);
    const auto apply = [&](const Vec3& a) {
      return Vec3{(q[0] * a[0] + q[1] * a[1] + q[2] * a[2]) * s,
                  (q[1] * a[0] + q[3] * a[1] + q[4] * a[2]) * s,
                  (q[2] * a[0] + q[4] * a[1] + q[5] * a[2]) * s};
    };
    const double xx = dot(frame.t1, apply(frame.t1)), yy = dot(frame.t2, apply(frame.t2));
    const double xy = dot(frame.t1, apply(frame.t2));
    out[v] = principal({yy, -xy, -xy, xx}, frame);
    flags[v].undetermined = !(m.area > 0);
  });
}

}  // namespace crest::curvature
