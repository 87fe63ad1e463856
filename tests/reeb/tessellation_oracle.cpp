// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reeb/tessellation_oracle.hpp"

#include <algorithm>

namespace crest::tests {
namespace {

int sign(Integer x) {
  return x < 0 ? -1 : x > 0;
}
Fraction fraction(Integer n, Integer d) {
  return d < 0 ? Fraction{-n, -d} : Fraction{n, d};
}

}  // namespace

QuadraticTriangle::QuadraticTriangle(const std::array<int, 6>& v)
    : a_(2 * (v[0] + v[1] - 2 * v[3])),
      b_(4 * (v[0] + v[4] - v[3] - v[5])),
      c_(2 * (v[0] + v[2] - 2 * v[5])),
      d_(4 * v[3] - 3 * v[0] - v[1]),
      e_(4 * v[5] - 3 * v[0] - v[2]),
      f_(v[0]),
      hessian_(4 * a_ * c_ - b_ * b_) {
  constexpr std::array<std::array<int, 2>, 3> at = {{{0, 0}, {1, 0}, {0, 1}}};
  for (int k = 0; k < 3; ++k) {
    const auto [px, py] = at[static_cast<std::size_t>(k)];
    const auto [qx, qy] = at[static_cast<std::size_t>((k + 1) % 3)];
    const auto [ox, oy] = at[static_cast<std::size_t>((k + 2) % 3)];
    boundary_.push_back({k, -1, {v[static_cast<std::size_t>(k)], 1}, px, py, 1});
    // f(p + x (q - p)) = alpha x^2 + beta x + gamma.
    const int dx = qx - px, dy = qy - py;
    const Integer alpha = a_ * dx * dx + b_ * dx * dy + c_ * dy * dy;
    const Integer beta =
        2 * a_ * px * dx + b_ * (px * dy + py * dx) + 2 * c_ * py * dy + d_ * dx + e_ * dy;
    const Integer w = 2 * alpha * sign(alpha), x = -beta * sign(alpha);  // at x / w
    if (!(0 < x && x < w)) continue;
    BoundaryNode n{-1,
                   k,
                   fraction(4 * alpha * v[static_cast<std::size_t>(k)] - beta * beta, 4 * alpha),
                   px * w + dx * x,
                   py * w + dy * x,
                   w};
    // The derivative towards the opposite corner, times w^2.
    const Integer inward = (2 * a_ * n.x + b_ * n.y + d_ * w) * (ox * w - n.x) +
                           (b_ * n.x + 2 * c_ * n.y + e_ * w) * (oy * w - n.y);
    n.saddle = inward == 0 ? hessian_ < 0 : sign(inward) != sign(alpha);
    boundary_.push_back(n);
  }
  if (hessian_ == 0) return;
  const int s = sign(hessian_);
  centre_x_ = s * (b_ * e_ - 2 * c_ * d_);
  centre_y_ = s * (b_ * d_ - 2 * a_ * e_);
  centre_w_ = s * hessian_;
  centre_ = std::min({sign(centre_x_), sign(centre_y_), sign(centre_w_ - centre_x_ - centre_y_)});
  centre_value_ = {2 * centre_w_ * f_ + d_ * centre_x_ + e_ * centre_y_, 2 * centre_w_};
}

// Strictly outside {f <= c} (below) or {f >= c}.
bool QuadraticTriangle::beyond(std::size_t i, const Fraction& c, bool below) const {
  const int x = compare(boundary_[i].value, c);
  return below ? x > 0 : x < 0;
}

// Which of the two convex sets of a hyperbola node i lies in: told by a line through the centre on
// which the form a s^2 + b s t + c t^2 has the other sign.
int QuadraticTriangle::part_of(std::size_t i, bool below) const {
  const Integer s = below ? 1 : -1, a = s * a_, b = s * b_, c = s * c_;
  Integer x, y;  // a x^2 + b x y + c y^2 > 0
  if (a > 0) {
    x = 1;
    y = 0;
  } else if (c > 0) {
    x = 0;
    y = 1;
  } else if (a < 0) {  // gives -a (b^2 - 4 a c)
    x = -b;
    y = 2 * a;
  } else if (c < 0) {
    x = 2 * c;
    y = -b;
  } else {
    x = 1;
    y = sign(b);
  }
  const BoundaryNode& n = boundary_[i];
  return sign((n.x * centre_w_ - centre_x_ * n.w) * y - (n.y * centre_w_ - centre_y_ * n.w) * x);
}

// Does the open convex set beyond the level (part 0), or its part of that sign, meet both ways
// along the boundary between i and j? Along the boundary f is monotone between nodes.
bool QuadraticTriangle::separated(std::size_t i, std::size_t j, const Fraction& c, bool below,
                                  int part) const {
  std::array<bool, 2> met{};
  bool second = false;
  for (std::size_t k = (i + 1) % boundary_.size(); k != i; k = (k + 1) % boundary_.size())
    if (k == j)
      second = true;
    else if (beyond(k, c, below) && (part == 0 || part_of(k, !below) == part))
      met[second] = true;
  return met[0] && met[1];
}

bool QuadraticTriangle::joined(std::size_t i, std::size_t j, const Fraction& c, bool below) const {
  if (i == j) return true;
  if (hessian_ >= 0) {
    // f or -f is convex; a linear function is both.
    const bool convex = a_ + c_ >= 0;
    return below == convex || !separated(i, j, c, below, 0);
  }
  const int side = below ? compare(c, centre_value_) : compare(centre_value_, c);
  if (side < 0) return part_of(i, below) == part_of(j, below);  // two convex sets
  if (side == 0) return centre_ >= 0 || part_of(i, below) == part_of(j, below);
  // The complement of two disjoint convex sets.
  return !separated(i, j, c, below, 1) && !separated(i, j, c, below, -1);
}

}  // namespace crest::tests
