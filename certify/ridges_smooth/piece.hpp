// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Pieces of a face, and models on them. A piece is a triangle, a segment or a point in the face's
// barycentric coordinates; what holds on every piece of a division holds on the face.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "certify/ridges_smooth/surface.hpp"

namespace crest::certify::smooth {

using Barycentric = std::array<double, 3>;

/// Images of the model triangle's corners. Coordinates are dyadic and exact down to depth 50.
struct Piece {
  std::array<Barycentric, 3> corner;
  bool whole = false;

  static Piece face() { return {{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, true}; }
  static Piece segment(const Barycentric& a, const Barycentric& b) { return {{a, b, b}, false}; }
  static Piece point(const Barycentric& a) { return {{a, a, a}, false}; }
  /// One of the four triangles between corners and midpoints.
  Piece child(std::size_t k) const;
};

inline Barycentric midpoint(const Barycentric& a, const Barycentric& b) {
  return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
}
/// The corner, or the point at t of edge i (from corner i to the next).
inline Barycentric on_edge(std::size_t i, double t) {
  Barycentric b{};
  b[i] = 1 - t;
  b[(i + 1) % 3] = t;
  return b;
}
inline Piece Piece::child(std::size_t k) const {
  std::array<Barycentric, 3> middle;  // of the side across from each corner
  for (std::size_t i = 0; i < 3; ++i)
    middle[i] = midpoint(corner[(i + 1) % 3], corner[(i + 2) % 3]);
  if (k == 3) return {middle, false};
  return {{corner[k], middle[(k + 2) % 3], middle[(k + 1) % 3]}, false};
}

/// The barycentric coordinates on a piece.
template <class M>
std::array<M, 3> coordinates(const Piece& p) {
  std::array<M, 3> l;
  for (std::size_t i = 0; i < 3; ++i)
    l[i] = M::linear(p.corner[0][i], p.corner[1][i], p.corner[2][i]);
  return l;
}

template <class M>
kernel::MaybeSign certain(const M& x) {
  return kernel::certain_sign(x.range());
}
/// Certain, and not the sign of a zero.
inline bool nonzero(const kernel::MaybeSign& s) {
  return s && *s != kernel::Sign::zero;
}
template <class M>
bool has_no_zero(const M& x) {
  return nonzero(certain(x));
}
template <class M>
bool is_positive(const M& x) {
  return certain(x) == kernel::Sign::positive;
}
inline double magnitude(const kernel::Range& r) {
  return std::fmax(std::fabs(r.low), std::fabs(r.high));
}

/// All constants of the range; unknown (an infinite radius) if that is not finite.
template <class M>
M constants(const kernel::Range& r) {
  const double middle = r.low / 2 + r.high / 2;
  const double radius = std::fmax(r.high - middle, middle - r.low);
  // Each difference errs by a rounding; 2^-1000 for one below the normal numbers.
  if (!(radius < HUGE_VAL)) return M::around(0, HUGE_VAL);
  return M::around(middle, radius * (1 + 0x1p-50) + 0x1p-1000);
}

/// A function near the model's middle: its polynomial alone.
template <int Order>
kernel::TaylorModel<Order> polynomial(kernel::TaylorModel<Order> m) {
  m.radius = 0;
  return m;
}
template <int Order>
kernel::MpTaylorModel<Order> polynomial(const kernel::MpTaylorModel<Order>& m) {
  kernel::MpTaylorModel<Order> r;
  for (std::size_t k = 0; k < r.c.size(); ++k) {
    const double low = m.c[k].lower(), high = m.c[k].upper();
    r.c[k] = kernel::MpInterval(low / 2 + high / 2, kernel::MpTaylorModel<Order>::kBits);
  }
  return r;
}

}  // namespace crest::certify::smooth
