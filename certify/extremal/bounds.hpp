// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The cone test and what follows from it (SPEC.md, lemma 9), in doubles with one slack a quantity.
//
// Slack. Every number below is a sum of products of control values, of size at most A and with
// error at most 2^-46 A (nets.hpp; halved 28 times edge_net.hpp; trim.cpp), and of entries of unit
// vectors that err by some u; at most 64 roundings. So it errs by less than (4 + 1) 2^-46 A < 2^-43
// A, with A times 1 / d where it is divided by spacings; slack() is 2^-40 A. Numbers that are not
// polynomials in the controls (angles) get a factor 1 +- 2^-40.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "certify/extremal/fields.hpp"

namespace crest::certify::extremal {

inline constexpr double kMore = 1 + 0x1p-40, kLess = 1 - 0x1p-40;

inline double slack(double size) {
  return 0x1p-40 * size;
}
inline double dot(const Vec& a, const Vec& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vec cross(const Vec& a, const Vec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Vec normalised(const Vec& a) {
  const double n = 1 / std::sqrt(dot(a, a));
  return {a[0] * n, a[1] * n, a[2] * n};
}

/// A direction and two across it: orthonormal to some u.
struct Frame {
  Vec w, u, v;
  explicit Frame(const Vec& direction) : w(normalised(direction)) {
    size_t least = 0;
    for (size_t k = 1; k < 3; ++k)
      if (std::fabs(w[k]) < std::fabs(w[least])) least = k;
    Vec axis{0, 0, 0};
    axis[least] = 1;
    u = normalised(cross(w, axis));
    v = cross(w, u);
  }
  explicit Frame(const ExtremalDirection& w)
      : Frame(
            Vec{static_cast<double>(w[0]), static_cast<double>(w[1]), static_cast<double>(w[2])}) {}
};

/// Control values of symmetric matrices, of vectors; `size`: A.
template <size_t n>
struct Matrices {
  std::array<std::array<double, n>, 6> at;  ///< xx yy zz xy yz xz
  double size;
};
template <size_t n>
struct Vectors {
  std::array<std::array<double, n>, 3> at;
  double size;
};

template <size_t n>
double least(const std::array<double, n>& x) {
  return *std::min_element(x.begin(), x.end());
}
template <size_t n>
double most(const std::array<double, n>& x) {
  return *std::max_element(x.begin(), x.end());
}

/// a^T M b at every control.
template <size_t n>
std::array<double, n> form(const Matrices<n>& m, const Vec& a, const Vec& b) {
  const double xx = a[0] * b[0], yy = a[1] * b[1], zz = a[2] * b[2];
  const double xy = a[0] * b[1] + a[1] * b[0], yz = a[1] * b[2] + a[2] * b[1],
               xz = a[0] * b[2] + a[2] * b[0];
  std::array<double, n> out;
  for (size_t i = 0; i < n; ++i)
    out[i] = (xx * m.at[0][i] + yy * m.at[1][i] + zz * m.at[2][i]) +
             (xy * m.at[3][i] + yz * m.at[4][i] + xz * m.at[5][i]);
  return out;
}
template <size_t n>
std::array<double, n> form(const Vectors<n>& m, const Vec& a) {
  std::array<double, n> out;
  for (size_t i = 0; i < n; ++i) out[i] = a[0] * m.at[0][i] + a[1] * m.at[1][i] + a[2] * m.at[2][i];
  return out;
}
/// At most so large are the (Frobenius) norms of the matrices.
template <size_t n>
double most_norm(const Matrices<n>& m) {
  std::array<double, n> square;
  for (size_t i = 0; i < n; ++i)
    square[i] = (m.at[0][i] * m.at[0][i] + m.at[1][i] * m.at[1][i] + m.at[2][i] * m.at[2][i]) +
                2 * (m.at[3][i] * m.at[3][i] + m.at[4][i] * m.at[4][i] + m.at[5][i] * m.at[5][i]);
  return std::sqrt(most(square)) + slack(m.size);
}
/// At most so long are vectors of these two coordinates.
template <size_t n>
double most_length(const std::array<double, n>& a, const std::array<double, n>& b, double size) {
  std::array<double, n> square;
  for (size_t i = 0; i < n; ++i) square[i] = a[i] * a[i] + b[i] * b[i];
  return std::sqrt(most(square)) + slack(size);
}

/// What holds on the hull of the controls if they pass: lambda1 - lambda2 >= gap, and the direction
/// n is within an angle of +-w, whose bounds these are.
struct Cone {
  bool holds = false;
  double gap = 0;
  double sine = 1, cosine = 0, chord = 2, angle = 2;  ///< of the angle: chord = 2 sin (angle / 2)
};

/// The angle whose double has that tangent at most, in [0, pi/4].
inline Cone cone_of(double gap, double tangent) {
  Cone cone{true, gap};
  const double square = tangent * tangent * kMore;
  const double twice = kLess / std::sqrt(1 + square);  // cos 2 theta
  cone.sine = std::sqrt(square / (2 * (1 + square) * (1 + twice))) * kMore;
  cone.cosine = std::sqrt((1 + twice) / 2) * kLess;
  cone.chord = cone.sine / std::sqrt((1 + cone.cosine) / 2) * kMore;
  const double x = cone.sine, y = x * x;
  // asin x; coefficients from x^9 on descend, and 1 / (1 - x^2) bounds their sum.
  cone.angle = x * (1 + y * (1.0 / 6 + y * (3.0 / 40 + y * (5.0 / 112)))) * kMore +
               x * y * y * y * y * (35.0 / 1152) / (1 - std::min(y, 0.75)) * kMore;
  return cone;
}

/// The cone test for all controls (SPEC.md, lemma 9).
template <size_t n>
Cone test_cone(const Matrices<n>& t, const Frame& frame) {
  const auto q = form(t, frame.w, frame.w);
  const auto cuu = form(t, frame.u, frame.u), cuv = form(t, frame.u, frame.v);
  std::array<double, n> gap;
  for (size_t i = 0; i < n; ++i) {
    const double sum = (t.at[0][i] + t.at[1][i] + t.at[2][i]) - q[i];
    const double difference = 2 * cuu[i] - sum;
    gap[i] = q[i] - 0.5 * (sum + std::sqrt(difference * difference + 4 * cuv[i] * cuv[i]));
  }
  const double delta = least(gap) - slack(t.size);
  if (!(delta > 0)) return {};
  const double b = most_length(form(t, frame.w, frame.u), form(t, frame.w, frame.v), t.size);
  return cone_of(delta, 2 * b / delta * kMore);
}

/// The sign of n . v with n oriented by w, if it is one on the whole hull; 0 if that is not proven.
template <size_t n>
int sign_on(const Cone& cone, const Frame& frame, const Vectors<n>& v) {
  const auto along = form(v, frame.w);
  const double p = most_length(form(v, frame.u), form(v, frame.v), v.size) * cone.sine * kMore;
  if ((least(along) - slack(v.size)) * cone.cosine * kLess > p) return 1;
  if ((-most(along) - slack(v.size)) * cone.cosine * kLess > p) return -1;
  return 0;
}

/// The sign of n^T H n, if it is one on the whole hull; 0 if that is not proven.
template <size_t n>
int curvature_on(const Cone& cone, const Frame& frame, const Matrices<n>& h) {
  const auto along = form(h, frame.w, frame.w);
  const double turn = 2 * cone.angle * most_norm(h) * kMore;
  if (least(along) - slack(h.size) > turn) return 1;
  if (-most(along) - slack(h.size) > turn) return -1;
  return 0;
}

}  // namespace crest::certify::extremal
