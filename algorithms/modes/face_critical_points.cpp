// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/face_critical_points.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

#include "algorithms/modes/small_matrix.hpp"

namespace crest::modes {

namespace {

using kernel::Vec3;
using kernel::operator+;
using kernel::operator-;
using kernel::operator*;
using Complex = std::complex<double>;

/// det on the span of three orthonormal tensors: (f, g, h) is its gradient (equation 13).
struct Cubic {
  std::array<Matrix3, 3> basis;

  Matrix3 tensor(const Vec3& x) const {
    return sum(sum(sum({}, x[0], basis[0]), x[1], basis[1]), x[2], basis[2]);
  }
  Vec3 gradient(const Vec3& x) const {
    const Matrix3 t = tensor(x), squared = product(t, t);
    return {inner(squared, basis[0]), inner(squared, basis[1]), inner(squared, basis[2])};
  }
  Matrix3 hessian(const Vec3& x) const {
    const Matrix3 t = tensor(x);
    Matrix3 h;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        h[i][j] = inner(product(t, basis[i]), basis[j]) + inner(product(t, basis[j]), basis[i]);
    return h;
  }
};

/// The polynomial with those values; constants first.
std::vector<double> interpolated(const std::vector<double>& places,
                                 const std::vector<double>& values) {
  std::vector<std::vector<double>> rows;
  for (std::size_t k = 0; k < places.size(); ++k) {
    std::vector<double> row;
    double power = 1;
    for (std::size_t p = 0; p < places.size(); ++p, power *= places[k]) row.push_back(power);
    row.push_back(values[k]);
    rows.push_back(std::move(row));
  }
  return solved(std::move(rows));
}

/// All roots at once (Durand and Kerner).
std::vector<Complex> roots(const std::vector<double>& c) {
  const std::size_t n = c.size() - 1;
  double size = 0;
  for (std::size_t k = 0; k < n; ++k) size = std::max(size, std::fabs(c[k] / c[n]));
  std::vector<Complex> x;
  for (std::size_t k = 0; k < n; ++k)
    x.push_back(
        std::polar(std::min(1 + size, 2.0),
                   0.4 + 6.283185307179586 * static_cast<double>(k) / static_cast<double>(n)));
  for (int step = 0; step < 400; ++step) {
    double moved = 0;
    for (std::size_t i = 0; i < n; ++i) {
      Complex value = c[n], others = c[n];
      for (std::size_t k = n; k-- > 0;) value = value * x[i] + c[k];
      for (std::size_t j = 0; j < n; ++j)
        if (j != i) others *= x[i] - x[j];
      const Complex move = value / others;
      x[i] -= move;
      moved = std::max(moved, std::abs(move) / (1 + std::abs(x[i])));
    }
    if (!(moved > 1e-13)) break;
  }
  return x;
}

/// Equations 11 and 10 as cubics in u' for a value of v'.
struct Equations {
  std::vector<double> first, second;

  Equations(const Cubic& cubic, double v) {
    const std::vector<double> places{-1.5, -0.5, 0.5, 1.5};
    std::vector<double> one, two;
    for (const double u : places) {
      const Vec3 g = cubic.gradient({u, v, 1});
      one.push_back(g[0] - u * g[2]);
      two.push_back(v * g[2] - g[1]);
    }
    first = interpolated(places, one);
    second = interpolated(places, two);
  }

  /// The determinant of Sylvester's matrix; its degree in v' is 9.
  double resultant() const {
    std::vector<std::vector<double>> m(6, std::vector<double>(6, 0));
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t p = 0; p < 4; ++p) {
        m[r][r + p] = first[p];
        m[3 + r][r + p] = second[p];
      }
    double det = 1;
    for (std::size_t k = 0; k < 6; ++k) {
      std::size_t best = k;
      for (std::size_t i = k; i < 6; ++i)
        if (std::fabs(m[i][k]) > std::fabs(m[best][k])) best = i;
      if (best != k) std::swap(m[k], m[best]), det = -det;
      det *= m[k][k];
      if (m[k][k] == 0) return 0;
      for (std::size_t i = k + 1; i < 6; ++i)
        for (std::size_t j = 6; j-- > k;) m[i][j] -= m[i][k] / m[k][k] * m[k][j];
    }
    return det;
  }
};

/// Newton's method for gradient = lambda x, |x| = 1.
bool polish(const Cubic& cubic, Vec3& x) {
  for (int step = 0; step < 30; ++step) {
    const Vec3 g = cubic.gradient(x);
    const double lambda = kernel::dot(g, x);
    const Matrix3 h = cubic.hessian(x);
    std::vector<std::vector<double>> rows;
    for (std::size_t i = 0; i < 3; ++i) {
      rows.push_back({h[i][0], h[i][1], h[i][2], -x[i], lambda * x[i] - g[i]});
      rows[i][i] -= lambda;
    }
    rows.push_back({x[0], x[1], x[2], 0, 0});
    const std::vector<double> s = solved(std::move(rows));
    const Vec3 move{s[0], s[1], s[2]};
    const double length = kernel::norm(move);
    if (!(length < 0.5)) return false;
    x = x + move;
    x = 1 / kernel::norm(x) * x;
    if (length < 1e-14) return true;
  }
  const Vec3 g = cubic.gradient(x);
  return kernel::norm(g - kernel::dot(g, x) * x) < 1e-12;
}

/// The roots of the resultant, each with all u' of one equation: Newton's method sorts them out.
std::vector<Vec3> guesses(const Cubic& cubic) {
  std::vector<double> places, values;
  for (int k = 0; k < 10; ++k) {
    places.push_back(1.5 * std::cos((k + 0.5) * 0.3141592653589793));
    values.push_back(Equations(cubic, places.back()).resultant());
  }
  std::vector<Vec3> result;
  for (const Complex& root : roots(interpolated(places, values))) {
    if (!(std::fabs(root.imag()) <= 1e-3 * (1 + std::abs(root)))) continue;
    const double v = root.real();
    for (const Complex& u : roots(Equations(cubic, v).first)) {
      if (!(std::fabs(u.imag()) <= 1e-2 * (1 + std::abs(u)))) continue;
      const Vec3 x{u.real(), v, 1};
      result.push_back(1 / kernel::norm(x) * x);
    }
  }
  return result;
}

FaceCriticalPoint described(const Cubic& cubic, const Matrix3& triangle, const Vec3& x) {
  // x = sum b_i row i of the triangle.
  std::vector<std::vector<double>> rows;
  for (std::size_t k = 0; k < 3; ++k)
    rows.push_back({triangle[0][k], triangle[1][k], triangle[2][k], x[k]});
  const std::vector<double> b = solved(std::move(rows));
  const double total = b[0] + b[1] + b[2];
  FaceCriticalPoint p;
  for (std::size_t k = 0; k < 3; ++k) p.weights[k] = b[k] / total;
  p.mode = (total < 0 ? -1 : 1) * 3 * std::sqrt(6.0) * determinant(cubic.tensor(x));
  p.degenerate = std::fabs(p.mode) > 1 - 1e-9;
  // The Hessian on the sphere: that of det less the multiplier, across x.
  const double lambda = kernel::dot(cubic.gradient(x), x);
  const Vec3 a = across(x), c = kernel::cross(x, a);
  const Matrix3 h = cubic.hessian(x);
  const double aa = kernel::dot(a, product(h, a)) - lambda, ac = kernel::dot(a, product(h, c)),
               cc = kernel::dot(c, product(h, c)) - lambda;
  p.extremum = aa * cc - ac * ac > 0;
  return p;
}

}  // namespace

std::vector<FaceCriticalPoint> face_critical_points(const std::array<Tensor, 3>& corners) {
  Cubic cubic;
  Matrix3 triangle{};  // corner i = sum over k of triangle[i][k] basis[k]
  for (std::size_t i = 0; i < 3; ++i) {
    Matrix3 rest = deviator(corners[i]);
    for (std::size_t j = 0; j < i; ++j) {
      triangle[i][j] = inner(rest, cubic.basis[j]);
      rest = sum(rest, -triangle[i][j], cubic.basis[j]);
    }
    triangle[i][i] = std::sqrt(inner(rest, rest));
    cubic.basis[i] = sum({}, 1 / triangle[i][i], rest);
  }
  std::vector<Vec3> found;
  // Each basis tensor once as w: a point near w = 0 in one chart is not in another.
  for (int chart = 0; chart < 3; ++chart) {
    for (Vec3 x : guesses(cubic)) {
      if (!polish(cubic, x)) continue;
      bool known = false;
      for (const Vec3& y : found) known = known || kernel::norm(kernel::cross(x, y)) < 1e-7;
      if (!known) found.push_back(x);
    }
    std::rotate(cubic.basis.begin(), cubic.basis.begin() + 1, cubic.basis.end());
    for (Vec3& x : found) x = {x[1], x[2], x[0]};
  }
  std::vector<FaceCriticalPoint> result;
  for (const Vec3& x : found) result.push_back(described(cubic, triangle, x));
  return result;
}

}  // namespace crest::modes
