// SPDX-License-Identifier: GPL-3.0-or-later
// The normal-based tensor. At a corner the interpolated normal is the vertex's own, so all corners
// of a vertex share one tangent plane and their tensors are averaged as 2 x 2 matrices there.
#include "algorithms/curvature/methods.hpp"
#include "algorithms/curvature/normal_tensor.hpp"
#include "algorithms/curvature/tangent.hpp"

namespace crest::curvature {
namespace {

/// x_u and n_u (or x_v and n_v) in the tangent plane.
struct Side {
  Flat x, n;
};

/// W with W x_u = -n_u and W x_v = -n_v, added to `sum`; false if the triangle stands upright.
bool add_corner(const Side& u, const Side& v, Tensor& sum) {
  const double det = u.x.x * v.x.y - v.x.x * u.x.y;
  if (det == 0) return false;
  const double s = 1 / det;
  sum.a += (v.n.x * u.x.y - u.n.x * v.x.y) * s;
  sum.b += (u.n.x * v.x.x - v.n.x * u.x.x) * s;
  sum.c += (v.n.y * u.x.y - u.n.y * v.x.y) * s;
  sum.d += (u.n.y * v.x.x - v.n.y * u.x.x) * s;
  return true;
}

struct TangentPlane {
  Vec3 point, normal;
  Frame frame;
  double inverse_length;

  TangentPlane(const Vec3& p, const Vec3& n) : point(p), normal(n), inverse_length(1 / norm(n)) {
    frame = frame_of(inverse_length * n);
  }
  Side side(const Vec3& p, const Vec3& n) const {
    const Flat x = frame.flatten(p - point), dn = frame.flatten(n - normal);
    return {x, {dn.x * inverse_length, dn.y * inverse_length}};
  }
};

PointCurvature mean_at(const kernel::TriangleMesh& mesh, const std::vector<Vec3>& normals, Index v,
                       VertexFlags& flags) {
  const auto& points = mesh.points();
  const TangentPlane plane(points[v], normals[v]);
  const auto ring = mesh.ring(v);
  const bool open = mesh.on_boundary(v);
  const Index from = open ? ring.front() : ring.back();
  Side before = plane.side(points[from], normals[from]);
  Tensor sum;
  int corners = 0;
  for (std::size_t j = open ? 1 : 0; j < ring.size(); ++j) {
    const Side next = plane.side(points[ring[j]], normals[ring[j]]);
    corners += add_corner(before, next, sum) ? 1 : 0;
    before = next;
  }
  const double s = corners > 0 ? 1.0 / corners : 0.0;
  const PointCurvature mean =
      principal({sum.a * s, sum.b * s, sum.c * s, sum.d * s}, plane.frame, &flags.complex);
  flags.undetermined = corners == 0;
  return mean;
}

}  // namespace

void normal_based(const kernel::TriangleMesh& mesh, const std::vector<Vec3>& normals,
                  std::vector<PointCurvature>& out, std::vector<VertexFlags>& flags) {
  for_each_index(mesh.vertex_count(),
                 [&](Index v) { out[v] = mean_at(mesh, normals, v, flags[v]); });
}

std::vector<CornerCurvatures> corner_curvatures(const kernel::TriangleMesh& mesh,
                                                const std::vector<Vec3>& normals) {
  std::vector<CornerCurvatures> out(mesh.face_count());
  for_each_index(mesh.face_count(), [&](Index f) {
    const auto& t = mesh.faces()[f];
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = t[k], u = t[(k + 1) % 3], w = t[(k + 2) % 3];
      const TangentPlane plane(mesh.points()[v], normals[v]);
      Tensor tensor;
      if (!add_corner(plane.side(mesh.points()[u], normals[u]),
                      plane.side(mesh.points()[w], normals[w]), tensor))
        tensor.a = tensor.b = tensor.c = tensor.d = std::nan("");
      out[f][k] = principal(tensor, plane.frame);
    }
  });
  return out;
}

PointCurvature curvature_at(const kernel::TriangleMesh& mesh, const std::vector<Vec3>& normals,
                            Index face, const std::array<double, 3>& lambda) {
  NormalTriangle<double> t;
  for (std::size_t k = 0; k < 3; ++k) {
    t.x[k] = mesh.points()[mesh.faces()[face][k]];
    t.n[k] = normals[mesh.faces()[face][k]];
  }
  const Vec3 n = interpolated_normal(t, lambda);
  const double length = norm(n);
  const Frame frame = frame_of(1 / length * n);
  const Flat xu = frame.flatten(t.x[1] - t.x[0]), xv = frame.flatten(t.x[2] - t.x[0]);
  const auto w = scaled_weingarten(t, lambda);
  // From the basis (x_u, x_v) into the frame: X W X^-1.
  const double s = 1 / (length * (xu.x * xv.y - xv.x * xu.y));
  const double p = w.w11 * xu.x + w.w21 * xv.x, q = w.w12 * xu.x + w.w22 * xv.x;
  const double r = w.w11 * xu.y + w.w21 * xv.y, u = w.w12 * xu.y + w.w22 * xv.y;
  const Tensor tensor{(p * xv.y - q * xu.y) * s, (q * xu.x - p * xv.x) * s,
                      (r * xv.y - u * xu.y) * s, (u * xu.x - r * xv.x) * s};
  PointCurvature out = principal(tensor, frame);
  out.K = gaussian_curvature(t, lambda);
  out.H = scaled_mean_curvature(t, lambda) / length;
  return out;
}

}  // namespace crest::curvature
