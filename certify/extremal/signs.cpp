// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/extremal/signs.hpp"

#include "certify/container/reject.hpp"

namespace crest::certify::extremal {
namespace {

using kernel::Rational;

/// Of the largest eigenvalue of a matrix of norm 1 and trace 0: Newton's method from above, where
/// the characteristic polynomial is convex. Only a guess: what it is good for is proven after.
double largest_root(double determinant) {
  double x = std::sqrt(2.0 / 3);
  for (int i = 0; i < 50; ++i) {
    const double slope = 3 * x * x - 0.5;
    if (!(slope > 0)) break;
    const double next = x - (x * (x * x - 0.5) - determinant) / slope;
    if (!(next < x)) break;
    x = next;
  }
  return x;
}

using Matrix = std::array<double, 6>;

Matrix adjugate(const Matrix& m) {
  return {m[1] * m[2] - m[4] * m[4], m[0] * m[2] - m[5] * m[5], m[0] * m[1] - m[3] * m[3],
          m[4] * m[5] - m[3] * m[2], m[3] * m[5] - m[0] * m[4], m[3] * m[4] - m[1] * m[5]};
}
Vec column(const Matrix& m, unsigned k) {
  return {m[kComponent[0][k]], m[kComponent[1][k]], m[kComponent[2][k]]};
}
/// The longest column.
Vec range_of(const Matrix& m) {
  unsigned best = 0;
  for (unsigned k = 1; k < 3; ++k)
    if (dot(column(m, k), column(m, k)) > dot(column(m, best), column(m, best))) best = k;
  return column(m, best);
}

ExactVector times(const ExactMatrix& t, const ExactVector& v) {
  ExactVector out;
  for (unsigned i = 0; i < 3; ++i)
    out[i] = t[kComponent[i][0]] * v[0] + t[kComponent[i][1]] * v[1] + t[kComponent[i][2]] * v[2];
  return out;
}
Rational dot(const ExactVector& a, const ExactVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
ExactVector cross(const ExactVector& a, const ExactVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
bool is_zero(const ExactVector& a) {
  return a[0] == 0 && a[1] == 0 && a[2] == 0;
}
ExactMatrix adjugate(const ExactMatrix& m) {
  return {m[1] * m[2] - m[4] * m[4], m[0] * m[2] - m[5] * m[5], m[0] * m[1] - m[3] * m[3],
          m[4] * m[5] - m[3] * m[2], m[3] * m[5] - m[0] * m[4], m[3] * m[4] - m[1] * m[5]};
}
/// The trace of a b.
Rational product(const ExactMatrix& a, const ExactMatrix& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + 2 * (a[3] * b[3] + a[4] * b[4] + a[5] * b[5]);
}

/// Does the eigenvector belong to the largest eigenvalue, which is simple? (K u = 0; are the other
/// two eigenvalues of K positive?)
bool is_dominant(const ExactMatrix& t, const ExactVector& u) {
  const Rational q = dot(u, times(t, u)) / dot(u, u);
  ExactMatrix k;
  for (size_t i = 0; i < 6; ++i) k[i] = -t[i];
  for (size_t i = 0; i < 3; ++i) k[i] += q;
  return k[0] + k[1] + k[2] > 0 && dot(u, times(adjugate(k), u)) > 0;
}

int sign(const Rational& x) {
  return x > 0 ? 1 : x < 0 ? -1 : 0;
}

/// a x^2 + b x + c.
struct Quadratic {
  Rational a, b, c;
  Rational at(const Rational& x) const { return (a * x + b) * x + c; }
  /// At least as large as the derivative's size on [low, high].
  Rational slope(const Rational& low, const Rational& high) const {
    return std::max(Rational(abs(2 * a * low + b)), Rational(abs(2 * a * high + b)));
  }
};

/// The characteristic polynomial of T, and adj(x I - T) : M, which at lambda1 is a positive
/// multiple of n^T M n.
struct Polynomials {
  Rational trace, minors, determinant;
  Quadratic form;

  Polynomials(const ExactMatrix& t, const ExactMatrix& m) {
    const ExactMatrix adjugate_t = adjugate(t);
    trace = t[0] + t[1] + t[2];
    minors = adjugate_t[0] + adjugate_t[1] + adjugate_t[2];
    determinant = t[0] * adjugate_t[0] + t[3] * adjugate_t[3] + t[5] * adjugate_t[5];
    // adj(x I - T) = x^2 I + x (T - trace I) + adj T.
    const Rational trace_m = m[0] + m[1] + m[2];
    form = {trace_m, product(t, m) - trace * trace_m, product(adjugate_t, m)};
  }
  Rational characteristic(const Rational& x) const {
    return ((x - trace) * x + minors) * x - determinant;
  }
};

}  // namespace

Vec likely_direction(const Matrix& t) {
  // Of an image: beside its entry zz a gap in the plane would be rounded away.
  if (t[4] == 0 && t[5] == 0 && t[2] < -(std::fabs(t[0]) + std::fabs(t[1]) + std::fabs(t[3]))) {
    const double half = (t[0] - t[1]) / 2, r = std::hypot(half, t[3]);
    if (!(r > 0)) return {1, 0, 0};
    return normalised(half > 0 ? Vec{half + r, t[3], 0} : Vec{t[3], r - half, 0});
  }
  const double mean = (t[0] + t[1] + t[2]) / 3;
  Matrix b = t;
  for (size_t k = 0; k < 3; ++k) b[k] -= mean;
  const double norm = std::sqrt(b[0] * b[0] + b[1] * b[1] + b[2] * b[2] +
                                2 * (b[3] * b[3] + b[4] * b[4] + b[5] * b[5]));
  if (!(norm > 0)) return {1, 0, 0};
  for (double& x : b) x /= norm;
  const Matrix a = adjugate(b);
  double lambda = largest_root(b[0] * a[0] + b[3] * a[3] + b[5] * a[5]);
  Vec n{1, 0, 0};
  for (int i = 0; i < 2; ++i) {  // then once with Rayleigh's quotient
    Matrix k = b;
    for (double& x : k) x = -x;
    for (size_t j = 0; j < 3; ++j) k[j] += lambda;
    const Vec next = range_of(adjugate(k));
    if (!(extremal::dot(next, next) > 0)) break;
    n = normalised(next);
    const Vec bn{extremal::dot(column(b, 0), n), extremal::dot(column(b, 1), n),
                 extremal::dot(column(b, 2), n)};
    lambda = extremal::dot(n, bn);
  }
  return n;
}

Direction direction_at(const Matrices<1>& t) {
  const Frame frame(
      likely_direction({t.at[0][0], t.at[1][0], t.at[2][0], t.at[3][0], t.at[4][0], t.at[5][0]}));
  const Cone cone = test_cone(t, frame);
  if (!cone.holds) throw Undecided("the direction at a point is not certain");
  return {frame, cone};
}

int orientation(const Vec& near, double chord, const Vec& w) {
  const double along = extremal::dot(near, w);
  if (!(std::fabs(along) > chord + 0x1p-40))
    throw Undecided("the orientation at a point is not certain");
  return along > 0 ? 1 : -1;
}

bool vanishes(const ExactMatrix& t, const ExactVector& v) {
  // n . v = 0 iff n is across the space that v, T v, T^2 v span, which T maps to itself.
  if (is_zero(v)) return true;
  const ExactVector tv = times(t, v), u = cross(v, tv);
  if (is_zero(u)) return !is_dominant(t, v);
  if (dot(u, times(t, tv)) != 0) return false;
  return is_dominant(t, u);
}

bool vanishes(const ExactMatrix& t, const ExactVector& w, const ExactMatrix& m) {
  const Polynomials p(t, m);
  const auto& [a, b, c] = p.form;
  // Above lambda2, by the cone test: a root of the characteristic polynomial from here on is
  // lambda1.
  const Rational q = dot(w, times(t, w)) / dot(w, w);
  if (a == 0 && b == 0) return c == 0;
  Rational root;  // that a common factor would have
  if (a == 0) {
    root = -c / b;
  } else {
    // Divided by the form: what is left has degree 1.
    const Rational third = p.trace + b / a;  // its root, if it is a factor
    const Rational slope = p.minors - c / a + third * (b / a);
    const Rational rest = third * (c / a) - p.determinant;
    if (slope == 0) return rest == 0 && third < q;
    root = -rest / slope;
  }
  return root >= q && p.form.at(root) == 0 && p.characteristic(root) == 0;
}

int sign_at(const ExactMatrix& t, const ExactVector& w, const ExactMatrix& m) {
  const Polynomials p(t, m);
  const Quadratic& f = p.form;
  // Between lambda2 and lambda1, by the cone test; lambda1 is the one root beyond.
  Rational low = dot(w, times(t, w)) / dot(w, w), step = 0;
  for (const Rational& x : t) step += abs(x);
  step *= Rational(0x1p-30);
  Rational high = low + step;
  while (p.characteristic(high) < 0) {
    low = high;
    step *= 2;
    high = low + step;
  }
  for (int i = 0; i < 1000; ++i) {
    const Rational middle = (low + high) / 2, value = f.at(middle);
    if (abs(value) > f.slope(low, high) * (high - low) / 2) return sign(value);
    (p.characteristic(middle) < 0 ? low : high) = middle;
  }
  throw Undecided("a sign at a point could not be decided");
}

int perturbed_sign(const Direction& direction, const Vectors<1>& v,
                   const std::function<ExactPoint()>& exact) {
  if (const int sign = sign_on(direction.cone, direction.frame, v)) return sign;
  const ExactPoint point = exact();
  ExactVector w;
  for (size_t k = 0; k < 3; ++k) w[k] = Rational(direction.frame.w[k]);
  // The sign of n . x: M is the symmetric part of w x^T, and n . w > 0.
  const auto sign_of = [&](const ExactVector& x) {
    if (vanishes(point.t, x)) return 0;
    const auto entry = [&](size_t i, size_t j) {
      return Rational((w[i] * x[j] + w[j] * x[i]) / 2);
    };
    return sign_at(point.t, w,
                   {entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(1, 2), entry(0, 2)});
  };
  if (const int sign = sign_of(point.v)) return sign;
  for (size_t k = 0; k < 3; ++k) {
    Vectors<1> unit{{}, 1};
    unit.at[k][0] = 1;
    if (const int sign = sign_on(direction.cone, direction.frame, unit)) return sign;
    ExactVector axis{0, 0, 0};
    axis[k] = 1;
    if (const int sign = sign_of(axis)) return sign;
  }
  throw Undecided("a direction is zero");
}

}  // namespace crest::certify::extremal
