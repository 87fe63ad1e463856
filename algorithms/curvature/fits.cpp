// SPDX-License-Identifier: GPL-3.0-or-later
// Least-squares patches. Lengths are divided by the mean distance of the neighbours, so that the
// weight of slopes against heights (cf) and the rank decisions do not depend on units. Where the
// neighbours do not determine the patch, the smallest solution is taken; mixed monomials carry the
// root of their binomial coefficient, so that "smallest" does not depend on the frame's axes.
#include <Eigen/QR>
#include <numbers>

#include "algorithms/curvature/methods.hpp"
#include "algorithms/curvature/tangent.hpp"

namespace crest::curvature {
namespace {

using Matrix = Eigen::MatrixXd;
using Row = Eigen::Index;

/// A vertex, its neighbours in its frame, in units of `scale`.
struct Neighbourhood {
  Frame frame;
  double scale = 1;
  std::vector<Index> vertices;  ///< without the centre
  std::vector<Vec3> local;      ///< x, y, z
};

Neighbourhood neighbourhood_of(const kernel::TriangleMesh& mesh, const Vec3& normal, Index v,
                               std::vector<Index> vertices) {
  Neighbourhood n;
  n.frame = frame_of(1 / norm(normal) * normal);
  n.vertices = std::move(vertices);
  double sum = 0;
  for (const Index w : n.vertices) {
    const Vec3 d = mesh.points()[w] - mesh.points()[v];
    sum += norm(d);
    n.local.push_back({dot(d, n.frame.t1), dot(d, n.frame.t2), dot(d, n.frame.n)});
  }
  n.scale = sum / static_cast<double>(n.vertices.size());
  for (Vec3& p : n.local) p = 1 / n.scale * p;
  return n;
}

constexpr double kRoot2 = std::numbers::sqrt2, kRoot3 = std::numbers::sqrt3;

/// Pivots below this share of the largest count as zero: a smaller one would turn the rounding of
/// heights (about 1e-16) into curvatures.
constexpr double kRank = 1e-8;

Matrix solve(const Matrix& a, const Matrix& b, VertexFlags& flags) {
  Eigen::CompleteOrthogonalDecomposition<Matrix> decomposition;
  decomposition.setThreshold(kRank);
  decomposition.compute(a);
  flags.lowered = decomposition.rank() < a.cols();
  return decomposition.solve(b);
}

double power(double x, int n) {
  double product = 1;
  for (int i = 0; i < n; ++i) product *= x;
  return product;
}

std::vector<Index> one_ring(const kernel::TriangleMesh& mesh, Index v) {
  const auto ring = mesh.ring(v);
  return {ring.begin(), ring.end()};
}

/// z = (a20 x^2 + 2 a11 x y + a02 y^2) / 2.
PointCurvature quadratic(const kernel::TriangleMesh& mesh, const std::vector<Vec3>& normals,
                         Index v, VertexFlags& flags) {
  const Neighbourhood n = neighbourhood_of(mesh, normals[v], v, one_ring(mesh, v));
  const auto count = static_cast<Row>(n.local.size());
  Matrix a(count, 3), b(count, 1);
  for (Row i = 0; i < count; ++i) {
    const auto [x, y, z] = n.local[static_cast<std::size_t>(i)];
    a.row(i) << 0.5 * x * x, x * y / kRoot2, 0.5 * y * y;
    b(i, 0) = z;
  }
  const Matrix c = solve(a, b, flags) / n.scale;
  const double mixed = c(1) / kRoot2;
  return principal({c(0), mixed, mixed, c(2)}, n.frame);
}

/// Equation 3.9 for heights and, by the neighbours' normals, for both slopes.
PointCurvature cubic(const kernel::TriangleMesh& mesh, const std::vector<Vec3>& normals, Index v,
                     VertexFlags& flags) {
  const Neighbourhood n = neighbourhood_of(mesh, normals[v], v, one_ring(mesh, v));
  const auto count = static_cast<Row>(n.local.size());
  Matrix a = Matrix::Zero(3 * count, 7), b = Matrix::Zero(3 * count, 1);
  for (Row i = 0; i < count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const auto [x, y, z] = n.local[k];
    a.row(3 * i) << 0.5 * x * x, x * y / kRoot2, 0.5 * y * y, x * x * x, kRoot3 * x * x * y,
        kRoot3 * x * y * y, y * y * y;
    b(3 * i, 0) = z;
    const Vec3& m = normals[n.vertices[k]];
    const double up = dot(m, n.frame.n);
    // A normal at or below the horizon is the normal of no height function.
    if (!(up > 0)) continue;
    a.row(3 * i + 1) << x, y / kRoot2, 0, 3 * x * x, kRoot3 * 2 * x * y, kRoot3 * y * y, 0;
    b(3 * i + 1, 0) = -dot(m, n.frame.t1) / up;
    a.row(3 * i + 2) << 0, x / kRoot2, y, 0, kRoot3 * x * x, kRoot3 * 2 * x * y, 3 * y * y;
    b(3 * i + 2, 0) = -dot(m, n.frame.t2) / up;
  }
  const Matrix c = solve(a, b, flags) / n.scale;
  const double mixed = c(1) / kRoot2;
  return principal({c(0), mixed, mixed, c(2)}, n.frame);
}

/// Parameters of the neighbours: distance and angle, the angles of a closed fan stretched to a full
/// turn (the exponential map of the one-ring, Welch and Witkin 1994).
std::vector<Flat> exponential_map(const kernel::TriangleMesh& mesh, Index v) {
  const auto ring = mesh.ring(v);
  std::vector<double> angle(ring.size()), radius(ring.size());
  std::vector<Vec3> spoke(ring.size());
  for (std::size_t j = 0; j < ring.size(); ++j) {
    spoke[j] = mesh.points()[ring[j]] - mesh.points()[v];
    radius[j] = norm(spoke[j]);
  }
  const auto between = [&](std::size_t i, std::size_t j) {
    const Vec3 n = cross(spoke[i], spoke[j]);
    return std::atan2(norm(n), dot(spoke[i], spoke[j]));
  };
  for (std::size_t j = 1; j < ring.size(); ++j) angle[j] = angle[j - 1] + between(j - 1, j);
  double stretch = 1;
  if (!mesh.on_boundary(v))
    stretch = 2 * std::numbers::pi / (angle.back() + between(ring.size() - 1, 0));
  std::vector<Flat> map;
  for (std::size_t j = 0; j < ring.size(); ++j) {
    map.push_back(
        {radius[j] * std::cos(stretch * angle[j]), radius[j] * std::sin(stretch * angle[j])});
  }
  return map;
}

/// f(u, v) = f_u u + f_v v + u^2 f_uu / 2 + u v f_uv + v^2 f_vv / 2, then equations 3.1 to 3.3.
PointCurvature quadratic_over_exponential(const kernel::TriangleMesh& mesh,
                                          const std::vector<Vec3>& normals, Index v,
                                          VertexFlags& flags) {
  const Neighbourhood n = neighbourhood_of(mesh, normals[v], v, one_ring(mesh, v));
  const std::vector<Flat> map = exponential_map(mesh, v);
  const auto count = static_cast<Row>(map.size());
  Matrix a(count, 5), b(count, 3);
  for (Row i = 0; i < count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double s = map[k].x / n.scale, t = map[k].y / n.scale;
    a.row(i) << s, t, 0.5 * s * s, s * t / kRoot2, 0.5 * t * t;
    b.row(i) << n.local[k][0], n.local[k][1], n.local[k][2];
  }
  const Matrix c = solve(a, b, flags);
  const auto world = [&](Row i) {
    return c(i, 0) * n.frame.t1 + c(i, 1) * n.frame.t2 + c(i, 2) * n.frame.n;
  };
  const Vec3 fu = world(0), fv = world(1);
  Vec3 up = cross(fu, fv);
  const double length = norm(up);
  if (!(length > 0)) {
    flags.undetermined = true;
    return {};
  }
  // The map turns as the mesh does; a fit turned over by noise still gets the vertex's side.
  const bool over = dot(up, normals[v]) < 0;
  up = 1 / length * up;
  if (over) up = Vec3{} - up;
  const Frame frame = frame_of(up);
  return principal(
      tensor_of_forms(frame.flatten(fu), frame.flatten(fv),
                      {dot(world(2), up) / n.scale, dot(world(3), up) / (kRoot2 * n.scale),
                       dot(world(4), up) / n.scale}),
      frame);
}

/// The height polynomial of the degree, or of the largest lower degree that the points determine
/// by number (at least 2).
PointCurvature jet(const kernel::TriangleMesh& mesh, const std::vector<Vec3>& normals, Index v,
                   const Options& options, VertexFlags& flags) {
  thread_local std::vector<Index> found;
  collect_rings(mesh, v, 1, static_cast<std::size_t>(options.jet_points), found);
  const Neighbourhood n = neighbourhood_of(mesh, normals[v], v, {found.begin() + 1, found.end()});
  const auto count = static_cast<Row>(n.local.size()) + 1;
  int degree = options.degree;
  while (degree > 2 && (degree + 1) * (degree + 2) / 2 > count) --degree;
  Matrix a(count, (degree + 1) * (degree + 2) / 2), b(count, 1);
  for (Row i = 0; i < count; ++i) {
    const Vec3 p = i == 0 ? Vec3{0, 0, 0} : n.local[static_cast<std::size_t>(i - 1)];
    b(i, 0) = p[2];
    Row column = 0;
    // By degree; within a degree the powers of x descend.
    for (int d = 0; d <= degree; ++d) {
      double binomial = 1;
      for (int k = 0; k <= d; ++k) {
        a(i, column++) = std::sqrt(binomial) * power(p[0], d - k) * power(p[1], k);
        binomial = binomial * (d - k) / (k + 1);
      }
    }
  }
  const Matrix c = solve(a, b, flags);
  flags.lowered = flags.lowered || degree < options.degree;
  const double zx = c(1), zy = c(2), g = std::sqrt(1 + zx * zx + zy * zy);
  const Vec3 pu = n.frame.t1 + zx * n.frame.n, pv = n.frame.t2 + zy * n.frame.n;
  const Vec3 up = cross(pu, pv);
  const Frame frame = frame_of(1 / g * up);
  const double s = 1 / (g * n.scale);
  return principal(tensor_of_forms(frame.flatten(pu), frame.flatten(pv),
                                   {2 * c(3) * s, kRoot2 * c(4) * s, 2 * c(5) * s}),
                   frame);
}

}  // namespace

void fit(const kernel::TriangleMesh& mesh, const std::vector<Vec3>& normals, const Options& options,
         std::vector<PointCurvature>& out, std::vector<VertexFlags>& flags) {
  for_each_index(mesh.vertex_count(), [&](Index v) {
    switch (options.method) {
      case Method::qf:
        out[v] = quadratic(mesh, normals, v, flags[v]);
        break;
      case Method::cf:
        out[v] = cubic(mesh, normals, v, flags[v]);
        break;
      case Method::qt:
        out[v] = quadratic_over_exponential(mesh, normals, v, flags[v]);
        break;
      default:
        out[v] = jet(mesh, normals, v, options, flags[v]);
    }
  });
}

}  // namespace crest::curvature
