// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/mode_geometry.hpp"

#include <Eigen/Dense>
#include <cmath>

namespace crest::modes {

namespace {

Eigen::Matrix3d deviator(const Tensor& t) {
  Eigen::Matrix3d m;
  m << t[0], t[3], t[5], t[3], t[1], t[4], t[5], t[4], t[2];
  return m - m.trace() / 3 * Eigen::Matrix3d::Identity();
}
kernel::Vec3 plain(const Eigen::Vector3d& v) {
  return {v[0], v[1], v[2]};
}

}  // namespace

ModeGeometry mode_geometry(const std::array<kernel::Vec3, 4>& corners,
                           const std::array<Tensor, 4>& tensors,
                           const std::array<double, 4>& weights) {
  Eigen::Matrix3d t = Eigen::Matrix3d::Zero(), edges;
  std::array<Eigen::Matrix3d, 3> change;
  for (std::size_t k = 0; k < 4; ++k) t += weights[k] * deviator(tensors[k]);
  for (std::size_t k = 0; k < 3; ++k) {
    change[k] = deviator(tensors[k + 1]) - deviator(tensors[0]);
    for (std::size_t i = 0; i < 3; ++i)
      edges(static_cast<int>(k), static_cast<int>(i)) = corners[k + 1][i] - corners[0][i];
  }
  // W_i, the field's derivative along axis i.
  const Eigen::Matrix3d inverse = edges.inverse();
  std::array<Eigen::Matrix3d, 3> w;
  for (int i = 0; i < 3; ++i)
    w[static_cast<std::size_t>(i)] =
        inverse(i, 0) * change[0] + inverse(i, 1) * change[1] + inverse(i, 2) * change[2];

  // mode = 3 sqrt6 d n^(-3/2) with d = det T, n = |T|^2; d_i = <T^2, W_i>, d_ij = 2 <T W_i, W_j>.
  const double d = t.determinant(), n = t.squaredNorm(),
               c = 3 * std::sqrt(6.0) / (n * std::sqrt(n));
  const Eigen::Matrix3d square = t * t;
  Eigen::Vector3d slope, growth;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Matrix3d& wi = w[static_cast<std::size_t>(i)];
    slope[i] = square.cwiseProduct(wi).sum();
    growth[i] = 2 * t.cwiseProduct(wi).sum();
  }
  Eigen::Matrix3d hessian;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const Eigen::Matrix3d &wi = w[static_cast<std::size_t>(i)],
                            &wj = w[static_cast<std::size_t>(j)];
      const double dij = ((t * wi).cwiseProduct(wj).sum() + (t * wj).cwiseProduct(wi).sum());
      const double nij = 2 * wi.cwiseProduct(wj).sum();
      hessian(i, j) = c * (dij - 1.5 * (slope[i] * growth[j] + slope[j] * growth[i] + d * nij) / n +
                           3.75 * d * growth[i] * growth[j] / (n * n));
    }
  const Eigen::Vector3d gradient = c * (slope - 1.5 * d / n * growth);
  const double length = gradient.norm();
  const Eigen::Vector3d normal = gradient / length, p = normal.unitOrthogonal(),
                        q = normal.cross(p);
  Eigen::Matrix2d
      shape;  // the surface's second fundamental form: -H / |gradient| across the normal
  shape << p.dot(hessian * p), p.dot(hessian * q), p.dot(hessian * q), q.dot(hessian * q);
  shape /= -length;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(shape);
  const auto direction = [&](int k) {
    return plain(solver.eigenvectors()(0, k) * p + solver.eigenvectors()(1, k) * q);
  };
  return {c * d,
          plain(gradient),
          plain(normal),
          solver.eigenvalues()[1],
          solver.eigenvalues()[0],
          direction(1),
          direction(0)};
}

}  // namespace crest::modes
