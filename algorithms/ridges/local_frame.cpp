// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/ridges/local_frame.hpp"

#include <cmath>

namespace crest::ridges {
namespace {

using kernel::Vec3;

Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Vec3& a, const Vec3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vec3 sub(const Vec3& a, const Vec3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

struct Covariance {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
};

// Eigenvector of the least eigenvalue of a covariance of trace 1. Newton's method from 0 meets the
// smallest root of the characteristic polynomial from below (all roots are real and not negative).
Vec3 least_direction(const Covariance& c) {
  const double minors =
      c.xx * c.yy - c.xy * c.xy + c.yy * c.zz - c.yz * c.yz + c.zz * c.xx - c.xz * c.xz;
  const double det = c.xx * (c.yy * c.zz - c.yz * c.yz) - c.xy * (c.xy * c.zz - c.yz * c.xz) +
                     c.xz * (c.xy * c.yz - c.yy * c.xz);
  double root = 0;
  for (int i = 0; i < 30; ++i) {
    const double value = ((1 - root) * root - minors) * root + det;
    const double slope = (2 - 3 * root) * root - minors;
    if (!(slope < 0)) break;
    const double next = root - value / slope;
    if (!(next > root)) break;
    root = next;
  }
  const Vec3 r0 = {c.xx - root, c.xy, c.xz}, r1 = {c.xy, c.yy - root, c.yz},
             r2 = {c.xz, c.yz, c.zz - root};
  Vec3 best = cross(r0, r1);
  for (const Vec3& candidate : {cross(r1, r2), cross(r2, r0)})
    if (dot(candidate, candidate) > dot(best, best)) best = candidate;
  return best;
}

bool normalise(Vec3& v) {
  const double l = std::sqrt(dot(v, v));
  if (!(l > 0) || !std::isfinite(l)) return false;
  for (double& x : v) x /= l;
  return true;
}

}  // namespace

LocalFrame local_frame(const std::vector<Vec3>& points, std::span<const kernel::Index> around,
                       const Vec3& vertex_normal, std::vector<Vec3>& local) {
  LocalFrame frame;
  frame.origin = points[around[0]];
  local.resize(around.size());
  Vec3 mean{};
  double square = 0;
  for (std::size_t i = 0; i < around.size(); ++i) {
    local[i] = sub(points[around[i]], frame.origin);
    for (std::size_t k = 0; k < 3; ++k) mean[k] += local[i][k];
    square += dot(local[i], local[i]);
  }
  const double n = static_cast<double>(around.size());
  for (double& m : mean) m /= n;
  frame.scale = std::sqrt(square / n);
  if (!(frame.scale > 0)) frame.scale = 1;
  Covariance c;
  for (const Vec3& p : local) {
    const Vec3 d = sub(p, mean);
    c.xx += d[0] * d[0];
    c.xy += d[0] * d[1];
    c.xz += d[0] * d[2];
    c.yy += d[1] * d[1];
    c.yz += d[1] * d[2];
    c.zz += d[2] * d[2];
  }
  const double trace = c.xx + c.yy + c.zz;
  if (trace > 0)
    for (double* x : {&c.xx, &c.xy, &c.xz, &c.yy, &c.yz, &c.zz}) *x /= trace;
  frame.z = least_direction(c);
  if (!normalise(frame.z)) frame.z = vertex_normal;
  if (dot(frame.z, vertex_normal) < 0)
    for (double& x : frame.z) x = -x;
  if (dot(frame.z, vertex_normal) < 0.5) frame.z = vertex_normal;

  // x: the coordinate axis least aligned with z, projected.
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (std::fabs(frame.z[k]) < std::fabs(frame.z[axis])) axis = k;
  Vec3 e{};
  e[axis] = 1;
  frame.y = cross(frame.z, e);
  normalise(frame.y);
  frame.x = cross(frame.y, frame.z);
  for (Vec3& p : local)
    p = {dot(frame.x, p) / frame.scale, dot(frame.y, p) / frame.scale,
         dot(frame.z, p) / frame.scale};
  return frame;
}

std::vector<Vec3> vertex_normals(const kernel::TriangleMesh& mesh) {
  std::vector<Vec3> normals(mesh.vertex_count(), Vec3{});
  std::vector<kernel::Index> some_face(mesh.vertex_count());
  const auto& p = mesh.points();
  auto area_vector = [&](kernel::Index f) {
    const auto [a, b, c] = mesh.faces()[f];
    return cross(sub(p[b], p[a]), sub(p[c], p[a]));
  };
  for (kernel::Index f = 0; f < mesh.face_count(); ++f) {
    const Vec3 n = area_vector(f);
    for (kernel::Index v : mesh.faces()[f]) {
      some_face[v] = f;
      for (std::size_t k = 0; k < 3; ++k) normals[v][k] += n[k];
    }
  }
  for (kernel::Index v = 0; v < mesh.vertex_count(); ++v) {
    if (normalise(normals[v])) continue;
    normals[v] = area_vector(some_face[v]);  // opposite faces cancelled
    if (!normalise(normals[v])) normals[v] = {0, 0, 1};
  }
  return normals;
}

}  // namespace crest::ridges
