// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Tensors of a tangent plane in an orthonormal frame.
#include <cmath>

#include "algorithms/curvature/curvature.hpp"

namespace crest::curvature {

using kernel::cross, kernel::dot, kernel::norm;
using kernel::operator+, kernel::operator-, kernel::operator*;

struct Flat {
  double x, y;
};

/// (t1, t2, n) direct and orthonormal.
struct Frame {
  Vec3 t1, t2, n;
  Flat flatten(const Vec3& a) const { return {dot(a, t1), dot(a, t2)}; }
  Vec3 lift(const Flat& a) const { return a.x * t1 + a.y * t2; }
};

/// The frame of a unit normal, without a branch on its direction but the sign of n[2]
/// (T. Duff et al., Building an orthonormal basis, revisited, 2017).
inline Frame frame_of(const Vec3& n) {
  const double s = std::copysign(1.0, n[2]);
  const double a = -1 / (s + n[2]), b = n[0] * n[1] * a;
  return {{1 + s * n[0] * n[0] * a, s * b, -s * n[0]}, {b, s + n[1] * n[1] * a, -n[1]}, n};
}

/// -dn in a frame: (x, y) -> (a x + b y, c x + d y).
struct Tensor {
  double a = 0, b = 0, c = 0, d = 0;
};

inline Flat unit(const Flat& f) {
  const double scale = 1 / std::sqrt(f.x * f.x + f.y * f.y);
  return {f.x * scale, f.y * scale};
}

/// Eigenvalues and eigenvectors. Where they are not real, or where the tensor is a multiple of the
/// identity: see PointCurvature.
inline PointCurvature principal(const Tensor& w, const Frame& frame, bool* complex = nullptr) {
  PointCurvature out;
  const double m = 0.5 * (w.a - w.d);
  const double discriminant = m * m + w.b * w.c;
  out.H = 0.5 * (w.a + w.d);
  out.K = w.a * w.d - w.b * w.c;
  out.asymmetry = std::abs(w.b - w.c);
  Flat e1{1, 0}, e2{0, 1};
  if (discriminant > 0) {
    const double root = std::sqrt(discriminant);
    out.k1 = out.H + root;
    out.k2 = out.H - root;
    // The larger of the two forms of each eigenvector.
    e1 = unit(m >= 0 ? Flat{root + m, w.c} : Flat{w.b, root - m});
    e2 = unit(m >= 0 ? Flat{-w.b, root + m} : Flat{root - m, -w.c});
  } else {
    if (complex != nullptr) *complex = discriminant < 0;
    out.k1 = out.k2 = out.H;
    const double s = 0.5 * (w.b + w.c), r = std::sqrt(m * m + s * s);
    if (r > 0) {
      e1 = unit(m >= 0 ? Flat{r + m, s} : Flat{s, r - m});
      e2 = {-e1.y, e1.x};
    }
  }
  out.d1 = frame.lift(e1);
  out.d2 = frame.lift(e2);
  return out;
}

/// The symmetric tensor with the second form ii[0] = II(pu, pu), ii[1] = II(pu, pv), ii[2] =
/// II(pv, pv) for tangent vectors pu, pv (equations 3.1 to 3.3).
inline Tensor tensor_of_forms(const Flat& pu, const Flat& pv, const std::array<double, 3>& ii) {
  const double det = pu.x * pv.y - pv.x * pu.y;
  // Columns of the inverse of (pu pv): coordinates of the frame's axes.
  const Flat first{pv.y / det, -pu.y / det}, second{-pv.x / det, pu.x / det};
  const auto form = [&](const Flat& s, const Flat& t) {
    return ii[0] * s.x * t.x + ii[1] * (s.x * t.y + s.y * t.x) + ii[2] * s.y * t.y;
  };
  const double mixed = form(first, second);
  return {form(first, first), mixed, mixed, form(second, second)};
}

inline bool is_finite(const PointCurvature& c) {
  return std::isfinite(c.k1) && std::isfinite(c.k2) && std::isfinite(c.K) &&
         std::isfinite(dot(c.d1, c.d1)) && std::isfinite(dot(c.d2, c.d2));
}

}  // namespace crest::curvature
