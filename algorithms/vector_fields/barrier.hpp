// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Corridors: between two arcs that the flow crosses one way only, one triangle at a time.
//
// In a triangle the field is affine. With a corner o as origin and the sides to the next and the
// previous corner as axes a point is (a, b), and w = W_o + A (a, b), the field times twice the
// area. A barrier is a Taylor polynomial of the field turned by the angle 2^-angle, to the left
// (+1) or right (-1) in these coordinates: det(w, T w) = s theta |w|^2, so the flow crosses it to
// the right or to the left, strictly, as long as what rounding and truncation change stays below
// theta.
//
// Bound. x' = h T w + r with |r| <= h |A'| |c_degree| + rounding in the maximum norm, so det(x', w)
// has the wanted sign if theta h |w|^2 > 2 |w| |r| + 2.5 h |w| e, e bounding the error of w itself;
// |w| is bounded on the piece by what x' changes. This is a filter for speed; a certificate's
// checker looks at the Bernstein coefficients of det(x', w).
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "algorithms/vector_fields/domain.hpp"

namespace crest::vector_fields {

/// How barriers are made; what a certificate says of them.
struct BarrierSetting {
  int bits = 53, angle = 36, degree = 12, shrink = 0;
};

/// A point of a side: t > 0 from its tail, t < 0 from its head, |t| <= 1/2 of its length, never
/// -1/2: near each end relatively as precise as doubles are.
template <class Real>
struct OnSide {
  Real t;
};

/// Whether s lies nearer to the tail than t.
template <class Real>
bool nearer_to_tail(const Real& s, const Real& t) {
  if ((s > 0) != (t > 0)) return s > 0;
  return s < t;
}
/// The same point seen from the twin.
template <class Real>
Real from_other_side(const Real& t) {
  return t == 0.5 ? t : Real(-t);
}

/// The field in a triangle's coordinates, by the corner in the origin.
template <class Real>
struct TriangleFrame {
  int origin;  ///< corner, 0 to 2
  std::array<Real, 2> w;
  std::array<std::array<Real, 2>, 2> a;  ///< by rows
  Real error;                            ///< of w at any point of the triangle

  TriangleFrame(const Domain& domain, Index t, int corner, bool forward, const Real& unit)
      : TriangleFrame(domain.corners(t), corner, forward, unit) {}
  TriangleFrame(const kernel::FieldOnTriangle& data, int corner, bool forward, const Real& unit)
      : origin(corner) {
    const auto c = static_cast<std::size_t>(corner);
    const std::array<std::size_t, 3> k = {c, (c + 1) % 3, (c + 2) % 3};
    const auto along = [&](std::size_t q, std::size_t i) -> Real {
      return Real(data.p[q][i]) - Real(data.p[k[0]][i]);
    };
    const Real e[2] = {along(k[1], 0), along(k[1], 1)}, f[2] = {along(k[2], 0), along(k[2], 1)};
    std::array<std::array<Real, 2>, 3> at;
    Real size = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double sign = forward ? 1 : -1;
      const Real x = sign * data.v[k[i]][0], y = sign * data.v[k[i]][1];
      const Real p = x * f[1], q = y * f[0], r = e[0] * y, s = e[1] * x;
      at[i] = {p - q, r - s};
      using std::fabs;
      const Real m = std::max<Real>(fabs(p) + fabs(q), fabs(r) + fabs(s));
      if (m > size) size = m;
    }
    w = at[0];
    for (std::size_t i = 0; i < 2; ++i) a[i] = {at[1][i] - w[i], at[2][i] - w[i]};
    error = 32 * unit * size;
  }
  std::array<Real, 2> value(const Real& x, const Real& y) const {
    return {w[0] + a[0][0] * x + a[0][1] * y, w[1] + a[1][0] * x + a[1][1] * y};
  }
};

/// What lines enter only, around a zero, as far as it lies in one triangle: an ellipse around a
/// zero inside it, or what a line cuts off at a corner. In the frame of corner 0.
struct TrapShape {
  std::array<double, 3> p;  ///< aa, ab, bb; of a line a, b, 1
  std::array<double, 2> zero;
  bool attracting;
  bool line = false;  ///< where p[0] a + p[1] b + p[2] is negative
  template <class Real>
  bool holds(const Real& a, const Real& b) const {
    if (line) return p[0] * a + p[1] * b + p[2] < -0x1p-20;
    const Real x = a - zero[0], y = b - zero[1];
    return p[0] * x * x + 2 * p[1] * (x * y) + p[2] * y * y < 1 - 0x1p-20;
  }
};

/// Where an arc ends.
template <class Real>
struct ArcEnd {
  int side = -1;  ///< -1: in the ellipse
  Real t{};
};

/// Makes the arcs of one precision.
template <class Real>
class BarrierMaker {
 public:
  BarrierMaker(const Domain& domain, const BarrierSetting& setting);

  const BarrierSetting& setting() const { return setting_; }
  /// Other pieces and angles than the precision's own.
  void set(int angle, int shrink);
  /// Gives up early: for trials.
  void be_quick(bool quick = true) { quick_ = quick; }
  bool quick() const { return quick_; }
  /// Whether the last arc failed for its number of pieces.
  bool exhausted() const { return exhausted_; }

  /// The arc from (x, y) in the frame to a side or into the ellipse; `left`: turned to the left.
  /// entry: the corner whose coordinate is 0 at the start (the one opposite the side that is
  /// entered), -1: none, 3: the start is the frame's origin. Nothing if a test fails.
  std::optional<ArcEnd<Real>> arc(const TriangleFrame<Real>& frame, const Real& x, const Real& y,
                                  bool left, int entry, const TrapShape* trap);
  const Domain& domain() const { return domain_; }
  const Real& unit() const { return unit_; }

 private:
  struct Piece;
  Real rounding(const Piece& piece) const;
  std::array<Real, 2> series(const Piece& piece, const Real& u, const Real& v,
                             const std::array<Real, 2>& p, const std::array<Real, 2>& q);
  std::pair<int, Real> exit_of(const Piece& piece, const std::array<Real, 2>& end, int entry) const;
  bool one_way(Piece& piece) const;
  bool surely_one_way(Piece& piece) const;
  bool surely_inside(const Piece& piece, int entry, int exit) const;
  bool inside(const Piece& piece, int entry, int exit);
  Real root(const Piece& piece, int corner, bool divided) const;
  Real coefficient(const Piece& piece, int corner, int k) const;
  std::optional<ArcEnd<Real>> leave(const TriangleFrame<Real>& frame, const Real& x, const Real& y,
                                    int exit) const;

  const Domain& domain_;
  BarrierSetting setting_;
  Real unit_, theta_;
  bool exhausted_ = false, quick_ = false;
  std::vector<Real> inverse_binomial_;                  ///< of degree over k
  std::vector<std::array<Real, 2>> c_, points_;         ///< of the piece at hand
  mutable std::vector<std::array<double, 2>> doubles_;  ///< nearly c_
};

}  // namespace crest::vector_fields
