// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/ridges/local_frame.hpp"

#include <tbb/blocked_range.h>

#include <algorithm>
#include <cmath>

#include "kernel/geometry/parallel.hpp"

namespace crest::ridges {
namespace {

using kernel::cross;
using kernel::dot;
using kernel::Vec3;
using kernel::operator-;

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
  const double l = kernel::norm(v);
  if (!(l > 0) || !std::isfinite(l)) return false;
  for (double& x : v) x /= l;
  return true;
}

// Rows of the four neighbourhoods relative to their first points.
void gather(const std::vector<Vec3>& points, const std::array<Support, kLanes>& around,
            NeighbourhoodLanes& local) {
  std::size_t first = 0, second = 0;
  for (std::size_t l = 0; l < kLanes; ++l) {
    local.inner[l] = around[l].inner;
    local.all[l] = around[l].points.size();
    first = std::max(first, local.inner[l]);
    second = std::max(second, local.all[l] - local.inner[l]);
  }
  local.split = first + first % 2;
  local.rows.assign(local.split + second + second % 2, PointLanes{});
  for (std::size_t l = 0; l < kLanes; ++l) {
    const std::vector<kernel::Index>& found = around[l].points;
    if (found.empty()) continue;
    const Vec3 origin = points[found[0]];
    for (std::size_t i = 0; i < found.size(); ++i) {
      const Vec3& p = points[found[i]];
      PointLanes& row = local.rows[i < around[l].inner ? i : local.split + i - around[l].inner];
      row.x[l] = p[0] - origin[0];
      row.y[l] = p[1] - origin[1];
      row.z[l] = p[2] - origin[2];
      row.live[l] = 1;
    }
  }
}

struct Spread {
  Lanes square, xx, xy, xz, yy, yz, zz;  // sums over the points, about the mean but for square
};

CREST_CLONES void measure(std::span<const PointLanes> rows, Spread& s) {
  s = Spread{};
  Lanes x = {}, y = {}, z = {}, n = {};
  for (const PointLanes& p : rows) {
    x += p.x;
    y += p.y;
    z += p.z;
    n += p.live;
    s.square += p.x * p.x + p.y * p.y + p.z * p.z;
  }
  x /= n;
  y /= n;
  z /= n;
  for (const PointLanes& p : rows) {
    const Lanes dx = (p.x - x) * p.live, dy = (p.y - y) * p.live, dz = (p.z - z) * p.live;
    s.xx += dx * dx;
    s.xy += dx * dy;
    s.xz += dx * dz;
    s.yy += dy * dy;
    s.yz += dy * dz;
    s.zz += dz * dz;
  }
  s.square /= n;
}

struct Rotation {
  Lanes row[3][3];
};

CREST_CLONES void rotate(const Rotation& r, std::vector<PointLanes>& rows) {
  for (PointLanes& p : rows) {
    const Lanes x = p.x, y = p.y, z = p.z;
    p.x = r.row[0][0] * x + r.row[0][1] * y + r.row[0][2] * z;
    p.y = r.row[1][0] * x + r.row[1][1] * y + r.row[1][2] * z;
    p.z = r.row[2][0] * x + r.row[2][1] * y + r.row[2][2] * z;
  }
}

void orient(LocalFrame& frame, Covariance c, const Vec3& vertex_normal) {
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
}

}  // namespace

std::array<LocalFrame, kLanes> local_frames(const std::vector<Vec3>& points,
                                            const std::array<Support, kLanes>& around,
                                            const std::array<Vec3, kLanes>& normals,
                                            NeighbourhoodLanes& local) {
  gather(points, around, local);
  Spread s;
  measure(local.first(), s);
  std::array<LocalFrame, kLanes> frames{};
  Rotation rotation{};
  for (std::size_t l = 0; l < kLanes; ++l) {
    if (around[l].points.empty()) continue;
    LocalFrame& f = frames[l];
    f.scale = std::sqrt(s.square[l]);
    if (!(f.scale > 0)) f.scale = 1;
    orient(f, {s.xx[l], s.xy[l], s.xz[l], s.yy[l], s.yz[l], s.zz[l]}, normals[l]);
    const Vec3* const axes[] = {&f.x, &f.y, &f.z};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) rotation.row[i][k][l] = (*axes[i])[k] / f.scale;
  }
  rotate(rotation, local.rows);
  return frames;
}

std::vector<Vec3> vertex_normals(const kernel::TriangleMesh& mesh) {
  std::vector<Vec3> normals(mesh.vertex_count());
  const auto& p = mesh.points();
  auto area_vector = [&](kernel::Index f) {
    const auto [a, b, c] = mesh.faces()[f];
    return cross(p[b] - p[a], p[c] - p[a]);
  };
  kernel::parallel_for(tbb::blocked_range<kernel::Index>(0, mesh.vertex_count(), 4096),
                       [&](const auto& range) {
                         std::vector<kernel::Index> faces;
                         for (kernel::Index v = range.begin(); v != range.end(); ++v) {
                           // By number: the sum's last bits do not depend on where the fan starts.
                           const auto fan = mesh.fan(v);
                           faces.assign(fan.begin(), fan.end());
                           std::sort(faces.begin(), faces.end());
                           for (const kernel::Index f : faces) {
                             const Vec3 n = area_vector(f);
                             for (std::size_t k = 0; k < 3; ++k) normals[v][k] += n[k];
                           }
                           if (normalise(normals[v])) continue;
                           normals[v] = area_vector(faces.back());  // opposite faces cancelled
                           if (!normalise(normals[v])) normals[v] = {0, 0, 1};
                         }
                       });
  return normals;
}

}  // namespace crest::ridges
