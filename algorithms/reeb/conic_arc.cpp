// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/reeb/conic_arc.hpp"

#include <algorithm>
#include <cmath>

namespace crest::reeb {
namespace {

/// Of the roots of a x^2 + b x + c the one nearer to zero. NaN if there is none.
double nearer_root(double a, double b, double c) {
  const double q = -0.5 * (b + std::copysign(std::sqrt(b * b - 4 * a * c), b));
  // The roots are q / a and c / q: the product c / a, the second the smaller.
  return c / q;
}

bool in_face(const Vec2& p) {
  constexpr double slack = 1e-9;
  return p[0] >= -slack && p[1] >= -slack && p[0] + p[1] <= 1 + slack;
}

}  // namespace

double FaceFunction::at(const Vec2& p) const {
  const auto [s, t] = p;
  return value + gs * s + gt * t + 0.5 * hss * s * s + hst * s * t + 0.5 * htt * t * t;
}

Vec2 FaceFunction::gradient(const Vec2& p) const {
  return {gs + hss * p[0] + hst * p[1], gt + hst * p[0] + htt * p[1]};
}

FaceFunction face_function(const std::array<double, 3>& f, const std::array<double, 3>& m) {
  return {f[0],
          4 * m[0] - 3 * f[0] - f[1],
          4 * m[2] - 3 * f[0] - f[2],
          4 * (f[0] + f[1] - 2 * m[0]),
          4 * (f[0] + m[1] - m[0] - m[2]),
          4 * (f[0] + f[2] - 2 * m[2])};
}

double crossing_parameter(double a, double m, double b, double c, double u, double v) {
  const double square = 2 * (a + b - 2 * m), slope = 4 * m - 3 * a - b;
  const auto at = [&](double x) { return (square * x + slope) * x + (a - c); };
  const bool rising = at(u) < at(v);
  // Bisection needs no formula for each of the cases and ends at neighbouring doubles.
  for (int i = 0; i < 60; ++i) {
    const double x = 0.5 * (u + v);
    if (x <= u || x >= v) break;
    ((at(x) < 0) == rising ? u : v) = x;
  }
  return 0.5 * (u + v);
}

void sample_arc(const FaceFunction& f, double c, const Vec2& p, const Vec2& q, int depth,
                std::vector<Vec2>& out) {
  constexpr double flat = 1e-3;  // of the chord: below what is seen
  if (depth == 0) return;
  const Vec2 m = {0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1])};
  const Vec2 d = q - p;
  const Vec2 hd = {f.hss * d[0] + f.hst * d[1], f.hst * d[0] + f.htt * d[1]};
  const Vec2 along = {-hd[1], hd[0]};  // conjugate to the chord
  const double length = std::hypot(along[0], along[1]);
  if (!(length > 0)) return;  // the level line is the chord
  const Vec2 e = {along[0] / length, along[1] / length};
  const Vec2 g = f.gradient(m);
  const double curvature = f.hss * e[0] * e[0] + 2 * f.hst * e[0] * e[1] + f.htt * e[1] * e[1];
  const double step = nearer_root(0.5 * curvature, dot(g, e), f.at(m) - c);
  const double chord = std::hypot(d[0], d[1]);
  if (!(std::abs(step) > flat * chord)) return;
  const Vec2 middle = m + step * e;
  // On a chord next to nothing, or where H is, rounding leaves no direction: the chord is better.
  if (!in_face(middle) || !(std::abs(f.at(middle) - c) < std::abs(f.at(m) - c))) return;
  sample_arc(f, c, p, middle, depth - 1, out);
  out.push_back(middle);
  sample_arc(f, c, middle, q, depth - 1, out);
}

}  // namespace crest::reeb
