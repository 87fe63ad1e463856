// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/sphere.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace crest::modes {

namespace {

using kernel::Vec3;
using kernel::operator*;

Eigen::Matrix3d deviator(const Tensor& t) {
  Eigen::Matrix3d m;
  m << t[0], t[3], t[5], t[3], t[1], t[4], t[5], t[4], t[2];
  return m - m.trace() / 3 * Eigen::Matrix3d::Identity();
}
Eigen::Matrix3d eigen(const Matrix3& a) {
  Eigen::Matrix3d m;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      m(i, j) = a[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  return m;
}
Eigen::Vector3d eigen(const Vec3& v) {
  return {v[0], v[1], v[2]};
}
Vec3 plain(const Eigen::Vector3d& v) {
  return {v[0], v[1], v[2]};
}
Matrix3 plain(const Eigen::Matrix3d& m) {
  return {plain(Eigen::Vector3d(m.row(0))), plain(Eigen::Vector3d(m.row(1))),
          plain(Eigen::Vector3d(m.row(2)))};
}
/// Orthonormal coordinates of traceless symmetric matrices.
Eigen::Matrix<double, 5, 1> coordinates(const Eigen::Matrix3d& m) {
  constexpr double h = std::numbers::sqrt2 / 2;
  return {(2 * m(2, 2) - m(0, 0) - m(1, 1)) * h * std::numbers::inv_sqrt3, (m(0, 0) - m(1, 1)) * h,
          2 * h * m(0, 1), 2 * h * m(1, 2), 2 * h * m(0, 2)};
}
Eigen::Matrix3d matrix(const Eigen::Matrix<double, 5, 1>& x) {
  constexpr double h = std::numbers::sqrt2 / 2, g = h * std::numbers::inv_sqrt3;
  Eigen::Matrix3d m;
  m << h * x[1] - g * x[0], h * x[2], h * x[4], h * x[2], -h * x[1] - g * x[0], h * x[3], h * x[4],
      h * x[3], 2 * g * x[0];
  return m;
}

/// Tbar across v.
struct Across {
  double alpha, beta, rho;
  Eigen::Vector3d major, minor;

  Across(const LinearTensors& field, const Vec3& direction) {
    const Eigen::Matrix3d bar = eigen(field.characteristic());
    const Eigen::Vector3d v = eigen(direction), image = bar * v;
    alpha = v.dot(image);
    beta = image.squaredNorm();
    const Eigen::Vector3d p = v.unitOrthogonal(), q = v.cross(p);
    const double half = (p.dot(bar * p) - q.dot(bar * q)) / 2, mixed = p.dot(bar * q);
    rho = std::hypot(half, mixed);
    const double turn = std::atan2(mixed, half) / 2;
    major = std::cos(turn) * p + std::sin(turn) * q;
    minor = v.cross(major);
  }
};

}  // namespace

LinearTensors::LinearTensors(const std::array<Tensor, 4>& corners) {
  Eigen::Matrix<double, 4, 5> t;
  for (int i = 0; i < 4; ++i)
    t.row(i) = coordinates(deviator(corners[static_cast<std::size_t>(i)])).transpose();
  const Eigen::JacobiSVD<Eigen::Matrix<double, 4, 5>> svd(
      t, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d bar = matrix(svd.matrixV().col(4));
  if (bar.determinant() > 0) bar = -bar;
  bar_ = plain(bar);
  bar_mode_ = 3 * std::sqrt(6.0) * bar.determinant();
  // The dual basis: rows of (t t^T)^-1 t.
  Eigen::Matrix<double, 4, 5> dual = Eigen::Matrix<double, 4, 5>::Zero();
  for (int k = 0; k < 4; ++k)
    dual += svd.matrixU().col(k) * svd.matrixV().col(k).transpose() / svd.singularValues()[k];
  for (int i = 0; i < 4; ++i)
    dual_[static_cast<std::size_t>(i)] = plain(matrix(dual.row(i).transpose()));
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(bar);
  for (int k = 0; k < 3; ++k) {
    frame_[static_cast<std::size_t>(k)] = plain(Eigen::Vector3d(solver.eigenvectors().col(2 - k)));
    eigenvalues_[static_cast<std::size_t>(k)] = solver.eigenvalues()[2 - k];
  }
}

LinearTensors::Place LinearTensors::place(const Matrix3& u) const {
  Place p{};
  double sum = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    for (std::size_t i = 0; i < 3; ++i) p.weights[k] += kernel::dot(dual_[k][i], u[i]);
    sum += p.weights[k];
  }
  if (sum == 0) return p;
  p.s = 1 / sum;
  for (double& w : p.weights) w *= p.s;
  return p;
}

double sine_of_theta(double mu) {
  return std::numbers::sqrt3 * std::tan(std::asin(std::fabs(mu)) / 3);
}

double real_domain(const LinearTensors& field, const Vec3& v, double mu) {
  const Across c(field, v);
  const double s = c.alpha * sine_of_theta(mu);
  return c.rho * c.rho - s * s / 4;
}

std::optional<std::array<ModePoint, 2>> mode_points(const LinearTensors& field, const Vec3& v,
                                                    double mu) {
  const Across c(field, v);
  const double cosine = c.alpha * sine_of_theta(mu) / (2 * c.rho);
  if (!(std::fabs(cosine) <= 1)) return std::nullopt;
  const double a = std::asin(std::fabs(mu)) / 3, unit = std::sqrt(2.0 / 3);
  const double upper = unit * std::sin(2 * std::numbers::pi / 3 - a), middle = -unit * std::sin(a);
  const Eigen::Vector3d axis = eigen(v);
  std::array<ModePoint, 2> result;
  double turn = std::acos(cosine) / 2;
  for (ModePoint& p : result) {
    const Eigen::Vector3d d = std::cos(turn) * c.major + std::sin(turn) * c.minor,
                          e = axis.cross(d);
    p.tensor = plain(Eigen::Matrix3d(middle * axis * axis.transpose() + upper * d * d.transpose() -
                                     (middle + upper) * e * e.transpose()));
    p.dominant = plain(d);
    const auto place = field.place(p.tensor);
    p.weights = place.weights;
    p.sign = place.s > 0 ? 1 : place.s < 0 ? -1 : 0;
    turn = -turn;
  }
  return result;
}

IrregularPoints irregular_points(const LinearTensors& field) {
  const Vec3& l = field.eigenvalues();
  return {std::sqrt((l[0] - l[1]) / (l[0] - l[2])), std::sqrt((l[1] - l[2]) / (l[0] - l[2]))};
}

std::optional<Vec3> boundary_point(const LinearTensors& field, double alpha, double mu) {
  const Vec3& l = field.eigenvalues();
  const double sine = sine_of_theta(mu);
  const double beta = (1 + (1 - sine * sine) * alpha * alpha / 2) / 2;
  // sum x_i^2 = 1, sum l_i x_i^2 = alpha, sum l_i^2 x_i^2 = beta.
  Vec3 x;
  for (std::size_t i = 0; i < 3; ++i) {
    const double j = l[(i + 1) % 3], k = l[(i + 2) % 3];
    const double square = (beta - (j + k) * alpha + j * k) / ((l[i] - j) * (l[i] - k));
    if (!(square >= 0)) return std::nullopt;
    x[i] = std::sqrt(square);
  }
  return x;
}

Vec3 quad_grid(const IrregularPoints& p, double theta, double eta) {
  const double f = p.a * p.a / (p.c * p.c) - 1, cosine = std::cos(eta);
  const Vec3 v{std::cos(theta) * std::sqrt(f * cosine * cosine + 1),
               std::sin(theta) * std::sin(eta), cosine};
  return (1 / kernel::norm(v)) * v;
}

Vec3 spheroconal_grid(const IrregularPoints& p, double theta, double eta) {
  const double ct = std::cos(theta), ce = std::cos(eta);
  return {ct * std::sqrt(1 - p.c * p.c * ce * ce), std::sin(theta) * std::sin(eta),
          ce * std::sqrt(1 - p.a * p.a * ct * ct)};
}

}  // namespace crest::modes
