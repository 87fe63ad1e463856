// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/modes_curves/near.hpp"

#include <algorithm>
#include <numeric>

#include "certify/modes_curves/span.hpp"

namespace crest::certify::curves {
namespace {

/// c[i] x^i.
template <std::size_t n>
using Power = std::array<Ball, n>;

template <std::size_t a, std::size_t b>
Power<a + b - 1> operator*(const Power<a>& x, const Power<b>& y) {
  Power<a + b - 1> z{};
  for (std::size_t i = 0; i < a; ++i)
    for (std::size_t j = 0; j < b; ++j) z[i + j] = z[i + j] + x[i] * y[j];
  return z;
}
template <std::size_t n>
Power<n> operator-(const Power<n>& x, const Power<n>& y) {
  Power<n> z;
  for (std::size_t i = 0; i < n; ++i) z[i] = x[i] - y[i];
  return z;
}
template <std::size_t n>
Power<n> operator*(const Ball& factor, Power<n> x) {
  for (Ball& c : x) c = factor * c;
  return x;
}
template <std::size_t n>
Ball value(const Power<n>& c, const Ball& x) {
  Ball sum = c[n - 1];
  for (std::size_t i = n - 1; i-- > 0;) sum = sum * x + c[i];
  return sum;
}
template <std::size_t n>
Power<n> reversed(Power<n> c) {
  std::ranges::reverse(c);
  return c;
}

/// A change of coordinates, so that no two points lie on a line with the centre; columns are near a
/// rotation's.
constexpr std::array<std::array<double, 3>, 3> kTurn = {
    {{0.75, 0.28125, 0.59375}, {-0.5, 0.8125, 0.25}, {-0.40625, -0.5, 0.765625}}};

Symmetric turned(const Symmetric& m) {
  const auto column = [](std::size_t j) {
    return Vector{Ball(kTurn[0][j]), Ball(kTurn[1][j]), Ball(kTurn[2][j])};
  };
  const std::array<Vector, 3> c = {column(0), column(1), column(2)};
  const std::array<Vector, 3> half = {times(m, c[0]), times(m, c[1]), times(m, c[2])};
  return {dot(c[0], half[0]), dot(c[1], half[1]), dot(c[2], half[2]),
          dot(c[0], half[1]), dot(c[1], half[2]), dot(c[0], half[2])};
}

/// The conics' resultant by z, where y = 1, and what gives z = -a / b.
struct Elimination {
  Power<3> a;
  Power<2> b;
  Power<5> quartic;

  Elimination(const Symmetric& p, const Symmetric& q) {
    // p0 z^2 + p1 z + p2.
    const Power<2> p1 = {p[4] + p[4], p[5] + p[5]}, q1 = {q[4] + q[4], q[5] + q[5]};
    const Power<3> p2 = {p[1], p[3] + p[3], p[0]}, q2 = {q[1], q[3] + q[3], q[0]};
    a = p[2] * q2 - q[2] * p2;
    b = p[2] * q1 - q[2] * p1;
    quartic = a * a - b * (p1 * q2 - q1 * p2);
  }
};

/// Bernstein's coefficients of a quartic on [-1, 1].
std::array<Ball, 5> on_unit_interval(const Power<5>& c) {
  const Ball half = 0.5;
  const Ball odd = half * (c[1] - c[3]);
  return {c[0] - c[1] + c[2] - c[3] + c[4], c[0] - c[4] - odd, c[0] - c[2] / 3 + c[4],
          c[0] - c[4] + odd, c[0] + c[1] + c[2] + c[3] + c[4]};
}

struct Bracket {
  double low, high;
  int sign;  ///< at its lower end
};

/// Simple roots by Descartes' rule; false where errors or 30 halvings do not tell.
bool isolate(std::array<Ball, 5> b, double low, double high, std::vector<Bracket>& list) {
  int changes = 0, last = 0;
  bool certain = true;
  for (const Ball& x : b) {
    const int sign = sign_of(x);
    certain &= sign != 0;
    changes += last * sign < 0;
    last = sign;
  }
  if (sign_of(b[0]) == 0 || last == 0) return false;
  if (certain && changes == 0) return true;
  if (certain && changes == 1) {
    list.push_back({low, high, sign_of(b[0])});
    return true;
  }
  if (high - low < 0x1p-30) return false;
  std::array<Ball, 5> first;
  for (std::size_t k = 0; k < 5; ++k) {
    first[k] = b[0];
    for (std::size_t i = 0; i + k < 4; ++i) b[i] = (b[i] + b[i + 1]) * Ball(0.5);
  }
  const double middle = low + (high - low) / 2;
  return isolate(first, low, middle, list) && isolate(b, middle, high, list);
}

/// A ball around the root in a bracket: Newton's steps find it, signs beside it prove it.
std::optional<Ball> narrow(const Power<5>& c, Bracket at) {
  const auto step = [&](double x) {
    double f = c[4].mid, d = 0;
    for (std::size_t i = 4; i-- > 0;) d = d * x + f, f = f * x + c[i].mid;
    return std::array{f, d};
  };
  double low = at.low, high = at.high, x = low + (high - low) / 2, slope = 0;
  for (int i = 0; i < 60; ++i) {
    const auto [f, d] = step(x);
    slope = d;
    (f * at.sign > 0 ? low : high) = x;
    double next = x - f / d;
    if (!(low < next && next < high)) next = low + (high - low) / 2;
    const double moved = std::fabs(next - x);
    x = next;
    if (moved <= 0x1p-50 * std::fabs(x) + 0x1p-60) break;
  }
  const Ball there = value(c, Ball(x));
  double radius = 2 * (std::fabs(there.mid) + there.rad) / std::fabs(slope) + 0x1p-52 * std::fabs(x) +
                  0x1p-70;
  for (int i = 0; i < 4; ++i, radius *= 8) {
    const double below = std::max(at.low, x - radius), above = std::min(at.high, x + radius);
    const int first = below == at.low ? at.sign : sign_of(value(c, Ball(below)));
    const int second = above == at.high ? -at.sign : sign_of(value(c, Ball(above)));
    if (first == at.sign && second == -at.sign)
      return Ball(x, 1.001 * std::max(x - below, above - x));
  }
  return std::nullopt;
}

/// The common points of two conics, up to factors.
std::optional<std::vector<Vector>> common_points(const Symmetric& p, const Symmetric& q) {
  const Elimination by_z(turned(p), turned(q));
  std::vector<Vector> points;
  std::vector<Bracket> brackets;
  for (const bool swapped : {false, true}) {
    const Power<5> c = swapped ? reversed(by_z.quartic) : by_z.quartic;
    brackets.clear();
    if (!isolate(on_unit_interval(c), -1, 1, brackets)) return std::nullopt;
    for (const Bracket& bracket : brackets) {
      const auto root = narrow(c, bracket);
      if (!root) return std::nullopt;
      // (x, y) = (root, 1), or (1, root): homogeneous of degree 1, 2.
      const Ball x = swapped ? Ball(1) : *root, y = swapped ? *root : Ball(1);
      const Ball b = by_z.b[0] * y + by_z.b[1] * x;
      const Ball a = (by_z.a[0] * y + by_z.a[1] * x) * y + by_z.a[2] * x * x;
      if (sign_of(b) == 0) return std::nullopt;
      const Vector v = {x * b, y * b, -a};
      Vector back;
      for (std::size_t i = 0; i < 3; ++i)
        back[i] = Ball(kTurn[i][0]) * v[0] + Ball(kTurn[i][1]) * v[1] + Ball(kTurn[i][2]) * v[2];
      points.push_back(back);
    }
  }
  return points;
}

const Box* box_of(const std::array<Ball, 3>& weights, const std::vector<Box>& boxes) {
  const Ball sum = weights[0] + weights[1] + weights[2];
  const std::array<Ball, 2> share = {weights[0] / sum, weights[1] / sum};
  const auto holds = [&](const Box& box) {
    for (unsigned k = 0; k < 2; ++k)
      if (!(share[k].mid - box.low[k] > 1.001 * share[k].rad &&
            box.high[k] - share[k].mid > 1.001 * share[k].rad))
        return false;
    return true;
  };
  const auto at = std::ranges::find_if(boxes, holds);
  return at == boxes.end() ? nullptr : &*at;
}

}  // namespace

std::optional<std::vector<NearPoint>> find_near_points(const Corners<3>& tensors,
                                                       const std::vector<Box>& boxes) {
  const Span<3> span(tensors);
  if (!span.independent()) return std::nullopt;
  const auto all = common_points(span.conic(0), span.conic(1));
  if (!all) return std::nullopt;
  const std::array<Symmetric, 3> dual = {span.dual(0), span.dual(1), span.dual(2)};
  std::vector<NearPoint> found;
  std::array<bool, 4> used{};
  for (const Vector& v : *all) {
    std::array<Ball, 3> weights;
    int least = 1, most = -1;
    for (std::size_t i = 0; i < 3; ++i) {
      weights[i] = dot(v, times(dual[i], v));
      const int sign = sign_of(weights[i]);
      least = std::min(least, sign), most = std::max(most, sign);
    }
    if (least < 0 && most > 0) continue;  // outside, whatever a third sign is
    if (least != most) return std::nullopt;
    const Box* box = box_of(weights, boxes);
    if (box == nullptr || box->type != least) return std::nullopt;
    bool& once = used[static_cast<std::size_t>(box - boxes.data())];
    if (once) return std::nullopt;
    once = true;
    found.push_back({least, box->listed, v});
  }
  if (found.size() != boxes.size()) return std::nullopt;
  return found;
}

namespace {

/// The points in their order around a vector inside the conic; false where errors do not tell.
class NearOrder {
 public:
  NearOrder(const Symmetric& conic, int sign, std::span<const NearTetPoint> points)
      : conic_(conic), points_(points) {
    // Vectors around the axis of the eigenvalue that has another sign than the others, to 45
    // degrees at least, as the trace is 0: one of these is there.
    double best = 0;
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        for (int z = -1; z <= 1; ++z) {
          const Vector c = {Ball(x), Ball(y), Ball(z)};
          const Ball form = dot(c, times(conic, c));
          if (const double at = sign * form.mid; at > best && sign_of(form) == sign)
            best = at, centre_ = c;
        }
    known_ = best > 0;
    const Vector polar = times(conic, centre_);
    for (const NearTetPoint& point : points) {
      Vector v = point.point->v;
      const int side = sign_of(dot(polar, v)) * sign;
      known_ &= side != 0;
      if (side < 0)
        for (Ball& x : v) x = -x;
      directions_.push_back(v);
    }
  }

  bool sort(std::vector<std::size_t>& order) const {
    if (!known_) return false;
    bool certain = true;
    order.resize(points_.size());
    std::iota(order.begin(), order.end(), 0);
    // Insertion: what is compared with what cannot run away where errors do not tell.
    for (std::size_t i = 2; i < order.size(); ++i)
      for (std::size_t k = i; k > 1; --k) {
        const int turn = orientation(order[k - 1], order[k]);
        certain &= turn != 0;
        if (turn >= 0) break;
        std::swap(order[k - 1], order[k]);
      }
    return certain;
  }

  /// Whether a form rises from 0 at point 0 where the order goes on; 0 if unknown.
  int rise(const Symmetric& form) const {
    const Vector& v = directions_[0];
    const Vector w = cross(times(conic_, v), v);
    return sign_of(dot(centre_, cross(v, w))) * sign_of(dot(v, times(form, w)));
  }

 private:
  /// Of points 0, a, b round the cone.
  int orientation(std::size_t a, std::size_t b) const {
    return sign_of(dot(directions_[0], cross(directions_[a], directions_[b])));
  }

  const Symmetric& conic_;
  std::span<const NearTetPoint> points_;
  Vector centre_;
  std::vector<Vector> directions_;
  bool known_ = false;
};

}  // namespace

std::optional<std::vector<std::array<std::size_t, 2>>> find_near_arcs(
    const Corners<4>& tensors, std::span<const NearTetPoint> points) {
  const Span<4> span(tensors);
  if (!span.independent()) return std::nullopt;
  const Symmetric conic = span.conic(0);
  const int sign = sign_of(determinant(conic));
  if (sign == 0) return std::nullopt;
  if (points.size() == 2) return std::vector<std::array<std::size_t, 2>>{{0, 1}};
  const NearOrder around(conic, sign, points);
  std::vector<std::size_t> order;
  if (!around.sort(order)) return std::nullopt;
  const int rise = around.rise(span.dual(points[0].opposite));
  if (rise == 0) return std::nullopt;
  const bool ahead = rise == points[0].point->type;
  std::vector<std::array<std::size_t, 2>> arcs;
  for (std::size_t i = 0; i < order.size(); i += 2) {
    const std::size_t first = ahead ? i : i + 1;
    arcs.push_back({order[first], order[(first + 1) % order.size()]});
  }
  return arcs;
}

}  // namespace crest::certify::curves
