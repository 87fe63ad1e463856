// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The formulas of paper 001, section 3.2.2 and appendix A, over any number type: K and H are
// rational in corners, normals and barycentric coordinates up to the root of (n~ n~).
//
// Letters: x[i] corners, n[i] normals (of any length), n~ their linear interpolation, m~ = x_u x
// x_v the triangle's normal (twice its area long; the text's "1/2 area" is a slip). Signs:
// equation 3.14 gives a convex triangle H < 0. The determinant form as printed is the matrix of
// +dn: its half trace is -H (the appendix swaps the sign between two lines). Here the matrix is
// that of -dn, so that trace and determinant are 2 H and K. The printed root also covers the
// determinant, which it must not.
#include <array>

#include "kernel/arithmetic/vec3.hpp"

namespace crest::curvature {

using kernel::cross, kernel::determinant, kernel::dot;
using kernel::operator+, kernel::operator-, kernel::operator*;

template <class T>
using Vector = kernel::Vector3<T>;

template <class T>
struct NormalTriangle {
  std::array<Vector<T>, 3> x, n;
};

/// n~ (equation 3.10).
template <class T>
Vector<T> interpolated_normal(const NormalTriangle<T>& t, const Vector<T>& lambda) {
  Vector<T> n;
  for (std::size_t k = 0; k < 3; ++k)
    n[k] = lambda[0] * t.n[0][k] + lambda[1] * t.n[1][k] + lambda[2] * t.n[2][k];
  return n;
}

/// m~.
template <class T>
Vector<T> triangle_normal(const NormalTriangle<T>& t) {
  return cross(t.x[1] - t.x[0], t.x[2] - t.x[0]);
}

/// K (equation 3.13). Requires: (n~ m~) != 0.
template <class T>
T gaussian_curvature(const NormalTriangle<T>& t, const Vector<T>& lambda) {
  const Vector<T> n = interpolated_normal(t, lambda);
  return determinant(t.n[0], t.n[1], t.n[2]) / (dot(n, n) * dot(n, triangle_normal(t)));
}

/// H sqrt(n~ n~) (equation 3.14). Requires: (n~ m~) != 0.
template <class T>
T scaled_mean_curvature(const NormalTriangle<T>& t, const Vector<T>& lambda) {
  const Vector<T> n = interpolated_normal(t, lambda);
  Vector<T> h{T(0), T(0), T(0)};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector<T> r = t.x[(i + 2) % 3] - t.x[(i + 1) % 3];
    h = h + cross(t.n[i], r);
  }
  return dot(n, h) / (T(2) * dot(n, triangle_normal(t)));
}

/// W sqrt(n~ n~) in the basis (x_u, x_v), -dn(x_u) = w11 x_u + w21 x_v (appendix A, determinant
/// form). Requires: (n~ m~) != 0.
template <class T>
struct ScaledWeingarten {
  T w11, w12, w21, w22;
};
template <class T>
ScaledWeingarten<T> scaled_weingarten(const NormalTriangle<T>& t, const Vector<T>& lambda) {
  const Vector<T> n = interpolated_normal(t, lambda);
  const Vector<T> xu = t.x[1] - t.x[0], xv = t.x[2] - t.x[0];
  const Vector<T> nu = t.n[1] - t.n[0], nv = t.n[2] - t.n[0];
  const T d = determinant(xu, xv, n);
  return {determinant(xv, nu, n) / d, determinant(xv, nv, n) / d, determinant(nu, xu, n) / d,
          determinant(nv, xu, n) / d};
}

/// f1 - f2 with f1 = -n_u x_v, f2 = -n_v x_u (section 3.2.3), taken in an orthonormal frame of the
/// plane orthogonal to n~, that is divided by the area of x_u, x_v there: a rational, the roots
/// cancel. Requires: (n~ m~) != 0.
template <class T>
T asymmetry(const NormalTriangle<T>& t, const Vector<T>& lambda) {
  const Vector<T> n = interpolated_normal(t, lambda);
  const Vector<T> xu = t.x[1] - t.x[0], xv = t.x[2] - t.x[0];
  const Vector<T> nu = t.n[1] - t.n[0], nv = t.n[2] - t.n[0];
  const T nn = dot(n, n);
  const T numerator =
      nn * (dot(xu, nv) - dot(xv, nu)) - dot(xu, n) * dot(nv, n) + dot(xv, n) * dot(nu, n);
  return numerator / (nn * dot(n, cross(xu, xv)));
}

}  // namespace crest::curvature
