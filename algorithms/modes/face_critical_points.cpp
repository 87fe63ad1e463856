// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/face_critical_points.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <complex>
#include <unsupported/Eigen/Polynomials>

namespace crest::modes {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Matrix3d deviator(const Tensor& t) {
  Matrix3d m;
  m << t[0], t[3], t[5], t[3], t[1], t[4], t[5], t[4], t[2];
  return m - m.trace() / 3 * Matrix3d::Identity();
}

/// det on the span of three orthonormal tensors: (f, g, h) is its gradient (equation 13).
struct Cubic {
  std::array<Matrix3d, 3> basis;

  Matrix3d tensor(const Vector3d& x) const {
    return x[0] * basis[0] + x[1] * basis[1] + x[2] * basis[2];
  }
  template <class T>
  Eigen::Matrix<T, 3, 1> gradient(const Eigen::Matrix<T, 3, 1>& x) const {
    const Eigen::Matrix<T, 3, 3> t =
        x[0] * basis[0].cast<T>() + x[1] * basis[1].cast<T>() + x[2] * basis[2].cast<T>();
    const Eigen::Matrix<T, 3, 3> square = t * t;
    Eigen::Matrix<T, 3, 1> g;
    for (int i = 0; i < 3; ++i)
      g[i] = square.cwiseProduct(basis[static_cast<std::size_t>(i)].cast<T>()).sum();
    return g;
  }
  Matrix3d hessian(const Vector3d& x) const {
    const Matrix3d t = tensor(x);
    Matrix3d h;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        h(i, j) = 2 * (t * basis[static_cast<std::size_t>(i)])
                          .cwiseProduct(basis[static_cast<std::size_t>(j)])
                          .sum();
    return (h + h.transpose()) / 2;
  }
};

/// Equations 11 and 10 as cubics in u' for a value of v', constants first.
using Coefficients = std::array<double, 4>;
struct Equations {
  Coefficients first, second;

  Equations(const Cubic& cubic, double v) {
    std::array<Coefficients, 2> values;
    Eigen::Matrix4d powers;
    for (int k = 0; k < 4; ++k) {
      const double u = k - 1.5;
      for (int p = 0; p < 4; ++p) powers(k, p) = std::pow(u, p);
      const Vector3d g = cubic.gradient<double>({u, v, 1});
      values[0][static_cast<std::size_t>(k)] = g[0] - u * g[2];
      values[1][static_cast<std::size_t>(k)] = v * g[2] - g[1];
    }
    for (int e = 0; e < 2; ++e) {
      const Eigen::Vector4d c =
          powers.fullPivLu().solve(Eigen::Vector4d(values[static_cast<std::size_t>(e)].data()));
      auto& target = e == 0 ? first : second;
      for (int p = 0; p < 4; ++p) target[static_cast<std::size_t>(p)] = c[p];
    }
  }

  /// Sylvester's matrix; its determinant has degree 9 in v'.
  double resultant() const {
    Eigen::Matrix<double, 6, 6> m = Eigen::Matrix<double, 6, 6>::Zero();
    for (int r = 0; r < 3; ++r)
      for (int p = 0; p < 4; ++p) {
        m(r, r + p) = first[static_cast<std::size_t>(p)];
        m(3 + r, r + p) = second[static_cast<std::size_t>(p)];
      }
    return m.determinant();
  }
};

/// Newton's method for gradient = lambda x, |x| = 1.
bool polish(const Cubic& cubic, Vector3d& x) {
  for (int step = 0; step < 30; ++step) {
    const Vector3d g = cubic.gradient<double>(x);
    const double lambda = g.dot(x);
    Eigen::Matrix4d m;
    m.topLeftCorner<3, 3>() = cubic.hessian(x) - lambda * Matrix3d::Identity();
    m.topRightCorner<3, 1>() = -x;
    m.bottomLeftCorner<1, 3>() = x.transpose();
    m(3, 3) = 0;
    Eigen::Vector4d residual;
    residual << g - lambda * x, 0;
    const Eigen::Vector4d move = m.fullPivLu().solve(-residual);
    if (!move.allFinite() || move.head<3>().norm() > 0.5) return false;
    x = (x + move.head<3>()).normalized();
    if (move.head<3>().norm() < 1e-14) return true;
  }
  return (cubic.gradient<double>(x) - x * x.dot(cubic.gradient<double>(x))).norm() < 1e-12;
}

/// The roots of the resultant, each with the u' that solves both equations best.
std::vector<Vector3d> guesses(const Cubic& cubic) {
  constexpr int n = 10;
  Eigen::Matrix<double, n, n> powers;
  Eigen::Matrix<double, n, 1> values;
  for (int k = 0; k < n; ++k) {
    const double v = 1.5 * std::cos((k + 0.5) * M_PI / n);
    for (int p = 0; p < n; ++p) powers(k, p) = std::pow(v, p);
    values[k] = Equations(cubic, v).resultant();
  }
  const Eigen::Matrix<double, n, 1> c = powers.fullPivLu().solve(values);
  std::vector<Vector3d> result;
  const Eigen::PolynomialSolver<double, n - 1> solver(c);
  for (const auto& root : solver.roots()) {
    if (std::fabs(root.imag()) > 1e-3 * (1 + std::abs(root))) continue;
    const double v = root.real();
    const Equations e(cubic, v);
    const Eigen::Vector4d first(e.first.data());
    if (first[3] == 0) continue;
    const Eigen::PolynomialSolver<double, 3> in_u(first);
    for (const auto& u : in_u.roots())
      if (std::fabs(u.imag()) <= 1e-2 * (1 + std::abs(u)))
        result.push_back(Vector3d(u.real(), v, 1).normalized());
  }
  return result;
}

}  // namespace

std::vector<FaceCriticalPoint> face_critical_points(const std::array<Tensor, 3>& corners) {
  Cubic cubic;
  Matrix3d triangle = Matrix3d::Zero();  // corners = triangle x basis
  for (int i = 0; i < 3; ++i) {
    Matrix3d rest = deviator(corners[static_cast<std::size_t>(i)]);
    for (int j = 0; j < i; ++j) {
      const Matrix3d& unit = cubic.basis[static_cast<std::size_t>(j)];
      triangle(i, j) = rest.cwiseProduct(unit).sum();
      rest -= triangle(i, j) * unit;
    }
    triangle(i, i) = rest.norm();
    cubic.basis[static_cast<std::size_t>(i)] = rest / rest.norm();
  }
  std::vector<Vector3d> found;
  // Two charts: a point near w = 0 in one is not in the other.
  for (int chart = 0; chart < 3; ++chart) {
    for (Vector3d x : guesses(cubic)) {
      if (!polish(cubic, x)) continue;
      bool known = false;
      for (const Vector3d& y : found) known = known || x.cross(y).norm() < 1e-7;
      if (!known) found.push_back(x);
    }
    std::rotate(cubic.basis.begin(), cubic.basis.begin() + 1, cubic.basis.end());
    for (Vector3d& x : found) x = Vector3d(x[1], x[2], x[0]);
  }
  std::vector<FaceCriticalPoint> result;
  for (const Vector3d& x : found) {
    FaceCriticalPoint p;
    const Vector3d b = triangle.transpose().fullPivLu().solve(x);
    for (int i = 0; i < 3; ++i) p.weights[static_cast<std::size_t>(i)] = b[i] / b.sum();
    const double sign = b.sum() < 0 ? -1 : 1;
    p.mode = sign * 3 * std::sqrt(6.0) * cubic.tensor(x).determinant();
    p.degenerate = std::fabs(p.mode) > 1 - 1e-9;
    // The Hessian on the sphere: that of det less the multiplier, across x.
    const double lambda = cubic.gradient<double>(x).dot(x);
    const Vector3d a = x.unitOrthogonal(), c = x.cross(a);
    const Matrix3d h = cubic.hessian(x) - lambda * Matrix3d::Identity();
    const double aa = a.dot(h * a), ac = a.dot(h * c), cc = c.dot(h * c);
    p.extremum = aa * cc - ac * ac > 0;
    result.push_back(p);
  }
  return result;
}

}  // namespace crest::modes
