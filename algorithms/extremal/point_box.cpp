// SPDX-License-Identifier: GPL-3.0-or-later
// What is proven of boxes, from expansions at their centres. Lengths are in units of R: theta = (1
// - y)^4, y = d^2, d the way from a point.
#include <algorithm>
#include <cmath>

#include "algorithms/extremal/direction.hpp"
#include "algorithms/extremal/point_field.hpp"

namespace crest::extremal {
namespace {

/// Bounds the Hessian of theta over 8, y being the least one.
double kappa(double y) {
  if (y >= 1) return 0;
  const double s = 1 - y;
  return y >= 3.0 / 7 ? s * s * (7 * y - 1) : std::max(s * s * s, 32.0 / 49);
}

/// Bounds the third derivatives of theta, as a trilinear form, over 48: along a unit vector with
/// q = d.u they are q (1 - y) (3 (1 - y) - 4 q^2), q^2 <= y; the largest from y on.
double kappa3(double y) {
  if (y >= 1) return 0;
  const double s = 1 - y, root = std::sqrt(y);
  const double inner = y < 0.1156 ? 0.659 : y < 0.2 ? s * root * (3 - 7 * y) : s * s * std::sqrt(s);
  const double outer = y < 0.7416 ? 0.488 : s * root * (7 * y - 3);
  return std::max(inner, outer);
}

/// Bounds the fourth derivatives of theta: along a unit vector they are 384 q^4 - 1152 q^2 (1 - y)
/// + 144 (1 - y)^2; the largest up to y.
double kappa4(double y) {
  const double far = std::min(y, 1.0);
  return std::max(165.0, 144 - 1440 * far + 1680 * far * far);
}

void add_scaled_outer(Tensor& t, double f, const Vec3& a) {
  const Vec3 b = f * a;
  t[0] += b[0] * a[0];
  t[1] += b[1] * a[1];
  t[2] += b[2] * a[2];
  t[3] += b[0] * a[1];
  t[4] += b[1] * a[2];
  t[5] += b[0] * a[2];
}

Vec3 corner_of(const Vec3& half, int i) {
  return {(i & 1) != 0 ? half[0] : -half[0], (i & 2) != 0 ? half[1] : -half[1],
          (i & 4) != 0 ? half[2] : -half[2]};
}

double dot_form(const Vec3& u, const Tensor& t, const Vec3& v) {
  return kernel::dot(u, product(t, v));
}

/// A point within R of a box.
struct Reached {
  Vec3 d;  ///< from it to the box's centre
  const Vec3* normal;
  double least, y;  ///< of the box, of its centre
};

class BoxProof {
 public:
  BoxProof(const std::vector<Reached>& points, const Vec3& half)
      : points_(points), half_(half), square_(kernel::dot(half, half)) {
    for (const Reached& p : points_) add(p);
    prove_cone();
  }
  bool passed() const { return passed_; }
  const Vec3& w() const { return frame_[0]; }
  double theta() const { return theta_; }
  /// Requires: it is passed. Is g not zero? By grad s's value at the centre, its linear part there
  /// or the second derivatives of n . grad s, too, each with a bound of what is left.
  bool nonzero() const {
    const double radius = std::sqrt(square_);
    const double first = radius * 8 * curved_, second = 0.5 * square_ * 48 * third_;
    if (clear(1, first, first) || clear(8, second, second)) return true;
    return !crossed() && clear(8, bend(), second);
  }
  /// Has the linear part of n . grad s both signs?
  bool crossed() const { return !clear(8, 0, 0); }

 private:
  void add(const Reached& p) {
    curved_ += kappa(p.least);
    third_ += kappa3(p.least);
    if (p.y >= 1) return;
    const double s = 1 - p.y, s2 = s * s, first = 8 * s2 * s;
    Tensor outer{};
    add_scaled_outer(outer, 1, *p.normal);
    gradient_ = gradient_ + first * p.d;
    for (std::size_t i = 0; i < 6; ++i) {
      tensor_[i] += s2 * s2 * outer[i];
      for (std::size_t k = 0; k < 3; ++k) slopes_[k][i] -= first * p.d[k] * outer[i];
    }
    for (std::size_t k = 0; k < 3; ++k) hessian_[k] += first;
    add_scaled_outer(hessian_, -48 * s2, p.d);
  }

  void prove_cone() {
    frame_[0] = dominant_direction(tensor_);
    const auto [u, v] = kernel::frame_across(w());
    frame_[1] = u;
    frame_[2] = v;
    // A point's part of q - mu has second derivatives as theta, of b half of them.
    const double rest = 0.5 * square_ * 8 * curved_;
    double gap = HUGE_VAL, across = 0, size = 0;
    for (int corner = 0; corner < 8; ++corner) {
      Tensor t = tensor_;
      const Vec3 step = corner_of(half_, corner);
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t i = 0; i < 6; ++i) t[i] += step[k] * slopes_[k][i];
      const double a = dot_form(u, t, u), b = dot_form(u, t, v), c = dot_form(v, t, v);
      gap = std::min(
          gap, dot_form(w(), t, w()) - 0.5 * (a + c) - std::sqrt(0.25 * (a - c) * (a - c) + b * b));
      across = std::max(across, std::hypot(dot_form(u, t, w()), dot_form(v, t, w())));
    }
    for (const double x : tensor_) size = std::max(size, std::fabs(x));
    gap = gap * (1 - 1e-9) - rest - 1e-10 * size;
    passed_ = gap > 0;
    if (passed_) theta_ = 0.5 * std::atan(2 * (across + 0.5 * rest) / gap);
  }

  /// Has n . grad s one sign, grad s being off by so much along w and across?
  bool clear(int corners, double along, double across) const {
    double low = HUGE_VAL, high = -HUGE_VAL, aside = 0;
    for (int corner = 0; corner < corners; ++corner) {
      Vec3 g = gradient_;
      if (corners > 1) g = g + product(hessian_, corner_of(half_, corner));
      const double x = kernel::dot(w(), g);
      low = std::min(low, x);
      high = std::max(high, x);
      aside = std::max(aside, std::hypot(kernel::dot(frame_[1], g), kernel::dot(frame_[2], g)));
    }
    constexpr double kRounded = 1 + 1e-9;
    return (std::max(low, -high) - along * kRounded) * std::cos(theta_) >
           (aside + across) * std::sin(theta_) * kRounded;
  }

  /// Bounds what the linear part lacks along w.
  double bend() const {
    Tensor t{};
    double fourth = 0;
    const double radius = std::sqrt(square_);
    for (const Reached& p : points_) {
      const double far = std::sqrt(p.y) + radius;
      fourth += kappa4(far * far);
      if (p.y >= 1) continue;
      const double s = 1 - p.y, along = kernel::dot(w(), p.d), b = 48 * s * s;
      add_scaled_outer(t, -192 * s * along, p.d);
      // d w' + w d'
      const Vec3 sum = p.d + w();
      add_scaled_outer(t, b, sum);
      add_scaled_outer(t, -b, p.d);
      add_scaled_outer(t, -b, w());
      for (std::size_t k = 0; k < 3; ++k) t[k] += b * along;
    }
    double quadratic = 0;
    static constexpr std::array<std::array<std::size_t, 2>, 6> kAxes = {
        {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {0, 2}}};
    for (std::size_t i = 0; i < 6; ++i)
      quadratic += (i < 3 ? 0.5 : 1) * std::fabs(t[i]) * half_[kAxes[i][0]] * half_[kAxes[i][1]];
    return quadratic + square_ * radius / 6 * fourth;
  }

  const std::vector<Reached>& points_;
  const Vec3 half_;
  const double square_;
  Tensor tensor_{}, hessian_{};     ///< T, Hess s at the centre
  std::array<Tensor, 3> slopes_{};  ///< of T
  Vec3 gradient_{};                 ///< of s
  double curved_ = 0, third_ = 0;   ///< sums of kappa, kappa3
  std::array<Vec3, 3> frame_{};     ///< w and a frame across
  double theta_ = 0;
  bool passed_ = false;
};

}  // namespace

PointField::Box PointField::box(const Vec3& centre, const Vec3& half) const {
  return box(centre, half, within(centre, half));
}

PointField::Box PointField::box(const Vec3& centre, const Vec3& half,
                                const std::vector<Index>& among) const {
  Box r;
  std::vector<Reached> reached;
  reached.reserve(among.size());
  const double unit = 1 / radius_;
  for (const Index i : among) {
    const Vec3 d = centre - points_[i];
    double least = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double beyond = std::max(0.0, std::fabs(d[k]) - half[k]);
      least += beyond * beyond;
    }
    if (!(least < radius_ * radius_)) continue;
    r.near = r.near || least <= kNear * kNear * h_ * h_;
    if (least == 0) ++r.inside;
    const Vec3 scaled = unit * d;
    reached.push_back({scaled, &normals_[i], least * unit * unit, kernel::dot(scaled, scaled)});
  }
  if (!r.near) return r;
  const BoxProof proof(reached, unit * half);
  r.passed = proof.passed();
  if (!r.passed) return r;
  r.w = proof.w();
  r.theta = proof.theta();
  r.nonzero = proof.nonzero();
  r.crossed = !r.nonzero && proof.crossed();
  return r;
}

PointField::Box PointField::box_in_parts(const Vec3& centre, const Vec3& half,
                                         const std::vector<Index>& among) const {
  Box r = box(centre, half, among);
  if (!r.near || r.nonzero || r.crossed || half[0] <= h_ / 12) return r;
  r.nonzero = true;
  for (int part = 0; part < 8 && r.nonzero; ++part) {
    const Box b = box_in_parts(centre + 0.5 * corner_of(half, part), 0.5 * half, among);
    r.nonzero = !b.near || b.nonzero;
  }
  return r;
}

}  // namespace crest::extremal
