// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/small_matrix.hpp"

#include <algorithm>
#include <cmath>

namespace crest::modes {

using kernel::Vec3;
using kernel::operator+;
using kernel::operator*;

Matrix3 deviator(const Tensor& t) {
  const double m = (t[0] + t[1] + t[2]) / 3;
  return {Vec3{t[0] - m, t[3], t[5]}, Vec3{t[3], t[1] - m, t[4]}, Vec3{t[5], t[4], t[2] - m}};
}

Matrix3 product(const Matrix3& a, const Matrix3& b) {
  Matrix3 p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = a[i][0] * b[0] + a[i][1] * b[1] + a[i][2] * b[2];
  return p;
}

Vec3 product(const Matrix3& a, const Vec3& v) {
  return {kernel::dot(a[0], v), kernel::dot(a[1], v), kernel::dot(a[2], v)};
}

double inner(const Matrix3& a, const Matrix3& b) {
  return kernel::dot(a[0], b[0]) + kernel::dot(a[1], b[1]) + kernel::dot(a[2], b[2]);
}

double determinant(const Matrix3& a) {
  return kernel::determinant(a[0], a[1], a[2]);
}

Matrix3 sum(const Matrix3& a, double s, const Matrix3& b) {
  return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]};
}

Matrix3 square(double s, const Vec3& v) {
  return {s * v[0] * v, s * v[1] * v, s * v[2] * v};
}

Vec3 across(const Vec3& v) {
  std::size_t least = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (std::fabs(v[k]) < std::fabs(v[least])) least = k;
  Vec3 e{};
  e[least] = 1;
  const Vec3 w = kernel::cross(v, e);
  return (1 / kernel::norm(w)) * w;
}

Eigensystem eigensystem(const Matrix3& symmetric) {
  Matrix3 a = symmetric, v{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  for (int sweep = 0; sweep < 40; ++sweep) {
    double off = 0;
    for (std::size_t p = 0; p < 3; ++p) {
      const std::size_t q = (p + 1) % 3;
      off += std::fabs(a[p][q]);
      if (a[p][q] == 0) continue;
      const double turn = (a[q][q] - a[p][p]) / (2 * a[p][q]);
      const double t = std::copysign(1, turn) / (std::fabs(turn) + std::hypot(turn, 1));
      const double c = 1 / std::hypot(t, 1), s = t * c;
      for (std::size_t k = 0; k < 3; ++k) {
        const double x = a[k][p], y = a[k][q];
        a[k][p] = c * x - s * y;
        a[k][q] = s * x + c * y;
      }
      const Vec3 x = a[p], y = a[q], e = v[p], f = v[q];
      a[p] = c * x + -s * y;
      a[q] = s * x + c * y;
      v[p] = c * e + -s * f;
      v[q] = s * e + c * f;
    }
    if (off == 0) break;
  }
  std::array<std::size_t, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(), [&](auto i, auto j) { return a[i][i] > a[j][j]; });
  Eigensystem e;
  for (std::size_t k = 0; k < 3; ++k) {
    e.values[k] = a[order[k]][order[k]];
    e.vectors[k] = v[order[k]];
  }
  if (determinant(e.vectors) < 0) e.vectors[2] = -1 * e.vectors[2];
  return e;
}

std::vector<double> solved(std::vector<std::vector<double>> rows) {
  const std::size_t n = rows.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t best = k;
    for (std::size_t i = k; i < n; ++i)
      if (std::fabs(rows[i][k]) > std::fabs(rows[best][k])) best = i;
    std::swap(rows[k], rows[best]);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      const double f = rows[i][k] / rows[k][k];
      for (std::size_t j = k; j <= n; ++j) rows[i][j] -= f * rows[k][j];
    }
  }
  std::vector<double> x(n);
  for (std::size_t k = 0; k < n; ++k) x[k] = rows[k][n] / rows[k][k];
  return x;
}

}  // namespace crest::modes
